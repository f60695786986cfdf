//! Paths: from the root on, of the file that they lead to, and the name of a material in one.

use std::path::{Path, PathBuf};

/// The path from the root on, links as they are; as it is where the current directory is gone.
pub fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// The same for two paths that lead to the same file, also where it is not there yet.
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

/// What a material is called: its file's name without the extension.
pub fn material_name(path: &Path) -> String {
    path.file_stem()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
