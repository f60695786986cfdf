//! Listing of a folder: names at once, and the kind of each file without reading all of it.

use super::error::FileError;
use super::fits::{self, MaterialFits};
use super::json_file;
use super::open::{JsonKind, open};
use crate::measured::merl;
use crate::quote;
use std::cmp::Ordering;
use std::fs::File;
use std::iter::Peekable;
use std::path::{Path, PathBuf};
use std::str::Chars;

/// Kind of a file, as far as its beginning and its length tell.
#[derive(Clone, Debug, PartialEq)]
pub enum FileContent {
    /// MERL file of the right length.
    Measured,
    /// JSON file with models, grouped by material.
    Models(Vec<MaterialFits>),
    /// JSON file with models that is too large to be read when its folder is listed.
    ManyModels,
}

/// Files and folders in a folder, hidden ones left out, sorted by [`natural_order`].
///
/// # Errors
/// Says in one line why the folder cannot be read.
pub fn list(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let cannot = |error| FileError::io(folder, "cannot read the folder", &error);
    let mut named = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        let name = shown_name(&path);
        if !name.starts_with('.') {
            named.push((name, path));
        }
    }
    // Names that are not UTF-8 may look alike.
    named.sort_by(|a, b| natural_order(&a.0, &b.0).then_with(|| a.1.cmp(&b.1)));
    Ok(named.into_iter().map(|(_, path)| path).collect())
}

/// Name of a file on screen: one line, with control characters escaped.
pub fn shown_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    quote::one_line(&name.to_string_lossy())
}

/// Determines the kind of a file from the header and length of a MERL file, or from a JSON file: from all of it up to 8 MiB,
/// else from its beginning.
///
/// # Errors
/// Says why it is neither.
pub fn inspect(path: &Path) -> Result<FileContent, FileError> {
    let (mut file, len) = open(path)?;
    if let Some(head) = json_file::head(&mut file, path)? {
        let other = reason_not_listed(JsonKind::of(&head.text));
        return match other {
            Some(what) => Err(FileError::new(path, what)),
            None if len <= MOST_LISTED => models(&mut file, len, path),
            None if head.begins_with_model() => Ok(FileContent::ManyModels),
            None => Err(FileError::new(
                path,
                "this large JSON file begins with no model",
            )),
        };
    }
    merl::read_header(&mut file, len)
        .map(|_| FileContent::Measured)
        .map_err(|error| FileError::merl(path, error))
}

/// Bytes of a JSON file at most whose fits are shown with the folder that it lies in: those of 5,000 fits.
const MOST_LISTED: u64 = 8 << 20;

/// Models of a JSON file that is small enough to be read for a list.
fn models(file: &mut File, len: u64, path: &Path) -> Result<FileContent, FileError> {
    let text = json_file::rest(file, len, MOST_LISTED, path)?;
    // The keys may stand behind the head.
    if let Some(what) = reason_not_listed(JsonKind::of(&text)) {
        return Err(FileError::new(path, what));
    }
    let entries = fits::entries(&text).map_err(|what| FileError::new(path, what))?;
    Ok(FileContent::Models(fits::by_material(path, entries)))
}

/// Words for a file without models in a list.
fn reason_not_listed(kind: JsonKind) -> Option<&'static str> {
    match kind {
        JsonKind::Session => Some("this is a session; Open… opens it in place of what is open"),
        JsonKind::Figure => Some("this is a figure; Open… opens its data"),
        JsonKind::Models => None,
    }
}

/// Order of names without regard to case, with numbers by their value: a2, A10, b.
pub fn natural_order(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a.chars().peekable(), b.chars().peekable());
    loop {
        let order = match (left.peek(), right.peek()) {
            (None, None) => return a.cmp(b),
            (None, _) => return Ordering::Less,
            (_, None) => return Ordering::Greater,
            (Some(x), Some(y)) if x.is_ascii_digit() && y.is_ascii_digit() => {
                let (x, y) = (number(&mut left), number(&mut right));
                x.len().cmp(&y.len()).then_with(|| x.cmp(&y))
            }
            _ => {
                let lower = |c: Option<char>| c.map(|c| c.to_lowercase().collect::<String>());
                lower(left.next()).cmp(&lower(right.next()))
            }
        };
        if order.is_ne() {
            return order;
        }
    }
}

/// Digits ahead without leading zeros: of two of them the longer one is the larger number.
fn number(chars: &mut Peekable<Chars>) -> String {
    let mut digits = String::new();
    while let Some(digit) = chars.next_if(char::is_ascii_digit) {
        if digit != '0' || !digits.is_empty() {
            digits.push(digit);
        }
    }
    digits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_ordered_as_a_person_does() {
        let mut names = [
            "b",
            "a10",
            "A2",
            "a2",
            "a",
            "a02b",
            "",
            "a100000000000000000000",
            "a 3",
        ];
        names.sort_by(|a, b| natural_order(a, b));
        let expected = [
            "",
            "a",
            "a 3",
            "A2",
            "a2",
            "a02b",
            "a10",
            "a100000000000000000000",
            "b",
        ];
        assert_eq!(names, expected);
        // The plain order differs.
        names.sort_unstable();
        assert_ne!(names, expected);
    }

    #[test]
    fn what_a_file_is_shows_at_its_beginning() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, bytes: &[u8]| {
            let path = folder.path().join(name);
            std::fs::write(&path, bytes).expect("written");
            path
        };
        let header: Vec<u8> = [90i32, 90, 180]
            .iter()
            .flat_map(|n| n.to_le_bytes())
            .collect();
        let good = write("good.binary", &header);
        let length = merl::byte_count(crate::measured::Grid::FOLDED);
        let file = std::fs::File::options().write(true).open(&good);
        file.and_then(|file| file.set_len(length)).expect("long");
        assert_eq!(inspect(&good).expect("good"), FileContent::Measured);
        for (path, words) in [
            (write("short.binary", &header), "truncated"),
            (write("text.txt", b"hello, world"), "it is a text"),
            (write("empty.binary", b""), "empty"),
            (write("no.json", b"[1]"), "entry 0"),
            (folder.path().to_path_buf(), "directory"),
        ] {
            let reason = inspect(&path).expect_err("no BRDF").reason();
            assert!(reason.contains(words), "{reason}");
            assert!(!reason.contains(&path.display().to_string()), "{reason}");
        }
        let model = br#"{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": 3}"#;
        let models = inspect(&write("model.json", model)).expect("a model");
        assert!(matches!(models, FileContent::Models(all) if all.len() == 1));
        write(".hidden", b"");
        let names: Vec<String> = list(folder.path())
            .expect("listed")
            .iter()
            .map(|path| shown_name(path))
            .collect();
        let expected = [
            "empty.binary",
            "good.binary",
            "model.json",
            "no.json",
            "short.binary",
            "text.txt",
        ];
        assert_eq!(names, expected);
        assert!(list(&good).is_err());
    }

    #[test]
    fn a_large_file_of_models_is_told_by_its_beginning() {
        let folder = tempfile::tempdir().expect("a folder");
        let model = r#"{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": 3}"#;
        let write = |name: &str, begin: &str| {
            let path = folder.path().join(name);
            // What is behind the beginning is no JSON at all, and not read.
            let text = format!("{begin}{}", "\0".repeat(MOST_LISTED as usize));
            std::fs::write(&path, text).expect("written");
            path
        };
        let models = write("models.json", &format!("[{model},"));
        assert_eq!(inspect(&models).expect("models"), FileContent::ManyModels);
        for (name, begin, words) in [
            ("numbers.json", "[1, 2, ", "begins with no model"),
            ("session.json", "{\"grazing_session\": 1, ", "a session"),
            ("figure.json", "{\"subjects\": [], \"rows\": [", "a figure"),
        ] {
            let reason = inspect(&write(name, begin))
                .expect_err("no models")
                .reason();
            assert!(reason.contains(words), "{reason}");
        }
        // Where only the name of a material says so, it is none.
        let named = model.replacen('{', "{\"material\": \"grazing_session\",", 1);
        let path = folder.path().join("small.json");
        std::fs::write(&path, named).expect("written");
        assert!(matches!(inspect(&path), Ok(FileContent::Models(_))));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn names_that_look_alike_are_in_one_order() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt as _;
        let folder = tempfile::tempdir().expect("a folder");
        // Scattered, as the file system may list them as they were made.
        let bytes: Vec<u8> = (0..16).map(|k| 0x80 + (k * 7) % 16).collect();
        for byte in &bytes {
            let path = folder.path().join(OsStr::from_bytes(&[*byte]));
            std::fs::write(path, b"").expect("written");
        }
        let listed = list(folder.path()).expect("listed");
        assert_eq!(listed.len(), bytes.len());
        assert!(listed.iter().all(|path| shown_name(path) == "\u{fffd}"));
        assert!(listed.is_sorted());
    }
}
