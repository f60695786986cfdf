//! Queries about fitting the folder.

use crate::app::state::State;
use crate::brdf::{Brdf, COMBINED, Fresnel};
use std::path::PathBuf;

/// Why the folder cannot be fitted now, in words.
pub fn blocked(state: &State) -> Option<&'static str> {
    if state.library.folder.is_none() {
        return Some("Open a folder first.");
    }
    if state.library.run.is_some() {
        return Some("The folder is being fitted.");
    }
    if measured(state).is_empty() {
        return Some("No file of the folder is a MERL file.");
    }
    state.fit.settings.blocked(&model(state))
}

/// The model that is fitted.
pub(crate) fn model(state: &State) -> Brdf {
    state
        .current()
        .map_or(Brdf::new(&COMBINED, Fresnel::Exact), |(_, opened)| {
            opened.brdf
        })
}

/// The measured files of the folder.
pub(crate) fn measured(state: &State) -> Vec<PathBuf> {
    let files = state.library.folder.iter().flat_map(|folder| &folder.files);
    files
        .filter(|file| file.is_measured())
        .map(|file| file.path.clone())
        .collect()
}
