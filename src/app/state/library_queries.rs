//! Queries about the files of the folder.

use crate::app::state::library::Kind;
use std::path::{Path, PathBuf};

impl crate::app::state::library::Library {
    /// What a file of the folder is.
    pub fn kind_of(&self, path: &Path) -> Option<&Kind> {
        let mut files = self.folder.as_ref()?.files.iter();
        files.find(|file| file.path == path).map(|file| &file.kind)
    }

    /// The measured files in the order in which they are listed.
    pub fn steps(&self) -> Vec<PathBuf> {
        let Some(folder) = &self.folder else {
            return Vec::new();
        };
        let rows = self.visible();
        let files = rows.iter().map(|index| &folder.files[*index]);
        files
            .filter(|file| file.is_measured())
            .map(|file| file.path.clone())
            .collect()
    }
}
