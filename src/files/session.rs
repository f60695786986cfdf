//! Session files as far as the file system goes: the key that tells them from other JSON, and paths of their materials.
//!
//! The window interprets their content; `docs/formats.md` documents its keys.

use super::fits::SourceFile;
use super::path_text;
use super::paths::{absolute, material_name};
use serde::{Deserialize, Serialize};
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

/// Key that every session has; its value is the version of the format.
pub const KEY: &str = "grazing_session";
/// Ending of the name of a session file.
pub const ENDING: &str = ".grazing.json";
/// Whether a file has the name of a session.
pub fn has_ending(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.to_lowercase().ends_with(ENDING)
}

/// Name of a session: that of its file without the ending.
pub fn name(path: &Path) -> String {
    let stem = material_name(path);
    match stem.strip_suffix(".grazing") {
        Some(name) if !name.is_empty() => name.into(),
        _ => stem,
    }
}

/// Measured file as named by a session.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedSource {
    /// Absolute path of the file.
    #[serde(with = "path_text")]
    pub path: PathBuf,
    /// Path relative to the folder of the session file, with `/` between the parts; `None` where there is none.
    #[serde(default, with = "path_text")]
    pub relative: Option<PathBuf>,
    /// Length of the file in bytes; `None` where not known.
    #[serde(default)]
    pub bytes: Option<u64>,
    /// SHA-256 of the file's bytes in hexadecimal; `None` where not known.
    #[serde(default)]
    pub sha256: Option<String>,
    /// Path that `relative` leads to, where that is not `path`.
    #[serde(skip)]
    pub beside: Option<PathBuf>,
}

impl From<&SourceFile> for SavedSource {
    fn from(source: &SourceFile) -> Self {
        Self {
            path: source.path.clone(),
            relative: None,
            bytes: source.bytes,
            sha256: source.sha256.clone(),
            beside: None,
        }
    }
}

impl SavedSource {
    /// Identity of the file.
    pub fn file(&self) -> SourceFile {
        SourceFile {
            path: self.path.clone(),
            bytes: self.bytes,
            sha256: self.sha256.clone(),
        }
    }

    /// Sets the relative path for a session file in this folder.
    pub fn place_in(&mut self, folder: &Path) {
        let to = self.beside.as_deref().unwrap_or(&self.path);
        self.relative = relative(folder, to);
    }

    /// Paths at which the file may be, in the order in which to look, without repeats: its path relative to the
    /// session's `folder`, its absolute path, its name in that folder.
    pub fn places(&self, folder: &Path) -> Vec<PathBuf> {
        let mut places = Vec::new();
        if let Some(relative) = &self.relative {
            // Where a part of the folder's path is a link, the two may differ.
            places.push(tidy(&folder.join(relative)));
            let plain = folder.join(relative);
            if plain != places[0] && plain.is_file() {
                places.push(plain);
            }
        }
        places.extend(self.file().places(folder));
        let mut seen = Vec::new();
        places.retain(|place| {
            let new = !seen.contains(place);
            seen.push(place.clone());
            new
        });
        places
    }
}

/// Relative path from a folder to a file, with `/` between the parts; `None` where there is none, as between two
/// drives.
pub fn relative(folder: &Path, file: &Path) -> Option<PathBuf> {
    let (folder, file) = (tidy(&absolute(folder)), tidy(file));
    let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), file.components().collect());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return None;
    }
    let up = (shared..from.len()).map(|_| OsStr::new(".."));
    let down = to[shared..].iter().map(|part| part.as_os_str());
    // `PathBuf::push` would put `\` between them on Windows.
    let parts: Vec<&OsStr> = up.chain(down).collect();
    Some(parts.join(OsStr::new("/")).into())
}

/// Path without `.` and `..`, resolved without looking at the disk.
pub fn tidy(path: &Path) -> PathBuf {
    let mut tidy = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                tidy.pop();
            }
            part => tidy.push(part),
        }
    }
    tidy
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, relative: Option<&str>) -> SavedSource {
        SavedSource {
            path: path.into(),
            relative: relative.map(PathBuf::from),
            bytes: None,
            sha256: None,
            beside: None,
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_relative_path_leads_back_to_its_file() {
        for (folder, file, expected) in [
            ("/a/b", "/a/b/c.binary", "c.binary"),
            ("/a/b", "/a/c/d.binary", "../c/d.binary"),
            ("/a/b/c", "/d.binary", "../../../d.binary"),
            ("/", "/a/b.binary", "a/b.binary"),
            ("/a/./x/../b", "/a/b/c.binary", "c.binary"),
        ] {
            let mut saved = source(file, None);
            saved.place_in(Path::new(folder));
            assert_eq!(saved.relative.as_deref(), Some(Path::new(expected)));
            assert_eq!(saved.places(Path::new(folder))[0], Path::new(file));
        }
    }

    #[cfg(unix)]
    #[test]
    fn places_are_looked_at_in_order_and_once() {
        let places = |relative| {
            let places = source("/far/away/c.binary", relative).places(Path::new("/here"));
            let texts = places.iter().map(|place| place.display().to_string());
            texts.collect::<Vec<_>>()
        };
        let expected = ["/data/c.binary", "/far/away/c.binary", "/here/c.binary"];
        assert_eq!(places(Some("../data/c.binary")), expected);
        assert_eq!(
            places(Some("c.binary")),
            ["/here/c.binary", "/far/away/c.binary"]
        );
        assert_eq!(places(None), ["/far/away/c.binary", "/here/c.binary"]);
    }

    #[test]
    fn sessions_are_named_after_their_file() {
        let path = Path::new("/a/teflon study.grazing.json");
        assert_eq!(name(path), "teflon study");
        assert!(has_ending(path) && !has_ending(Path::new("/a/teflon.json")));
        assert_eq!(name(Path::new("other.json")), "other");
        assert_eq!(name(Path::new(".grazing.json")), ".grazing");
    }
}
