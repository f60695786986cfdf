//! Absolute and canonical paths, and material names from paths.

use std::ffi::OsStr;
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
    named_place(&path)
}

/// Canonical path of the folder with the name of the file as it is given: equal for two paths that lead to the same name.
pub fn named_place(path: &Path) -> PathBuf {
    let path = absolute(path);
    match (
        path.parent().and_then(|folder| folder.canonicalize().ok()),
        path.file_name(),
    ) {
        (Some(folder), Some(name)) => folder.join(name),
        _ => path,
    }
}

/// Name of the file at the end of a path that may come from another system: what follows the last `/` or `\`.
pub fn last_name(path: &Path) -> &OsStr {
    match path.to_str() {
        Some(text) => OsStr::new(text.rsplit(['/', '\\']).next().unwrap_or(text)),
        // A path of another system is UTF-8, or it could not be read.
        None => path.file_name().unwrap_or(path.as_os_str()),
    }
}

/// Name of a file's material: the file name without its extension.
pub fn material_name(path: &Path) -> String {
    path.file_stem()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
