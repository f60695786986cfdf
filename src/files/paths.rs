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
    named_place(&followed(&path))
}

/// Path at which a file is made that is written under this one: where a link to nothing points, else the path itself.
pub fn followed(path: &Path) -> PathBuf {
    // As many as Linux follows; a circle ends as a link.
    const MOST_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(to) = path.read_link() else {
            break;
        };
        path = path.parent().unwrap_or(Path::new("")).join(to);
    }
    path
}

/// Whether two paths are of one file: the same place, or two names of what is there.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    place(a) == place(b) || is_same_inode(a, b)
}

#[cfg(unix)]
fn is_same_inode(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let inode = |path: &Path| {
        let metadata = path.metadata().ok()?;
        Some((metadata.dev(), metadata.ino()))
    };
    inode(a).is_some_and(|found| inode(b) == Some(found))
}

#[cfg(not(unix))]
fn is_same_inode(_: &Path, _: &Path) -> bool {
    false
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
