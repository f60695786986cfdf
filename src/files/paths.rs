//! Absolute and canonical paths, and material names from paths.

use std::path::{Path, PathBuf};

/// Absolute path with links unresolved; the path unchanged where the current directory is gone.
pub fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// Canonical path, equal for two paths that lead to the same file, also where the file does not exist yet.
pub fn place(path: &Path) -> PathBuf {
    let path = absolute(path);
    if let Ok(place) = path.canonicalize() {
        return place;
    }
    match (
        path.parent().and_then(|folder| folder.canonicalize().ok()),
        path.file_name(),
    ) {
        (Some(folder), Some(name)) => folder.join(name),
        _ => path,
    }
}

/// Name of a file's material: the file name without its extension.
pub fn material_name(path: &Path) -> String {
    path.file_stem()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
