//! How the state changes when a folder is opened, closed and stepped through.

use crate::app::msg::Task;
use crate::app::msg::library::{FolderMsg, LibraryMsg, LibraryTask};
use crate::app::reduce::context::Context;
use crate::app::reduce::{folder_fit, listing, memory, show};
use crate::app::state::State;
use crate::app::state::job::CancelFlag;
use crate::app::state::library::{Folder, Scan};
use crate::app::state::prefs::MemoryLimit;
use crate::files;
use std::path::Path;

/// Changes the state.
pub(crate) fn apply(state: &mut State, msg: LibraryMsg) -> Vec<Task> {
    match msg {
        LibraryMsg::Open(path) => return open(state, &path),
        LibraryMsg::Close => close(state),
        LibraryMsg::Folder(msg) => {
            let shows = matches!(msg, FolderMsg::Seen { .. });
            let State {
                library,
                notices,
                next_id,
                ..
            } = state;
            listing::apply(library, &mut Context { notices, next_id }, msg);
            if shows {
                return show_first(state);
            }
        }
        LibraryMsg::Show { path, keep } => return show::show_file(state, path, keep),
        LibraryMsg::Step(by) => return show::step(state, by),
        LibraryMsg::Keep => show::keep_open(state),
        LibraryMsg::SetLimit(mib) => state.prefs.memory = MemoryLimit(mib),
        LibraryMsg::Fit { number, update } => folder_fit::update(state, number, update),
    }
    Vec::new()
}

fn open(state: &mut State, path: &Path) -> Vec<Task> {
    let path = files::absolute(path);
    close(state);
    state.prefs.remember(path.clone());
    state.prefs.folder = Some(path.clone());
    let (number, cancel) = (state.fresh_id(), CancelFlag::default());
    state.library.folder = Some(Folder {
        number,
        path: path.clone(),
        files: Vec::new(),
        scan: Scan::Listing,
        cancel: cancel.clone(),
    });
    vec![Task::Library(LibraryTask::Scan {
        number,
        path,
        cancel,
        hold: state.library.hold.clone(),
    })]
}

pub(crate) fn close(state: &mut State) {
    if let Some(cursor) = state.library.cursor.take()
        && state.position_of_file(&cursor).is_none()
    {
        memory::cancel_pending(state);
    }
    let library = &mut state.library;
    library.folder = None;
    library.search.clear();
}

/// In an empty window, a folder shows its first material.
fn show_first(state: &mut State) -> Vec<Task> {
    let empty = state.scene.opened.is_empty() && state.jobs.is_empty();
    if !empty || state.library.cursor.is_some() || state.library.pending.is_some() {
        return Vec::new();
    }
    match state.library.steps().first() {
        Some(first) => show::show_file(state, first.clone(), false),
        None => Vec::new(),
    }
}
