//! Serde adapter for paths: text in files, paths in memory. For `#[serde(with = "path_text")]`.
//!
//! A path that is UTF-8 is written as a string, as it is. Any other, which Unix allows, is an object: `{"bytes": TEXT}`,
//! where TEXT has `%` and two hexadecimal digits for `%`, control characters and every byte that is not ASCII. No string
//! can be mistaken for that object, whereas a marker inside a string could be the beginning of a file's name.
//!
//! Windows has such paths too, as 16-bit units that are no UTF-16. There they are written with U+FFFD in place of what
//! is no text, and do not lead back.

use percent_encoding::percent_decode_str;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::VecDeque;
use std::path::{Path, PathBuf};

/// Serializes a path, an optional one or a list.
///
/// # Errors
/// Errors of the serializer.
pub fn serialize<T: Paths, S: Serializer>(paths: &T, serializer: S) -> Result<S::Ok, S::Error> {
    paths.to_text().serialize(serializer)
}

/// Deserializes a path, an optional one or a list.
///
/// # Errors
/// Errors of the deserializer; a value that is neither a string nor an object with `bytes` alone.
pub fn deserialize<'de, T: Paths, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    T::Text::deserialize(deserializer).map(T::from_text)
}

/// Text of a path in a table without types: the string, or the object as JSON. A path from the root never begins with
/// the `{` of that.
pub fn cell(path: &Path) -> String {
    match PathText::from(path) {
        PathText::Plain(text) => text,
        // A key and a text: nothing that JSON lacks.
        object => serde_json::to_string(&object).unwrap_or_default(),
    }
}

/// Path as text that leads back to it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "expected a path: a string, or {\"bytes\": string} with % and two digits for a byte that is no text"
)]
pub enum PathText {
    /// Path that is UTF-8.
    Plain(String),
    /// Path that is not.
    Bytes {
        /// Bytes of the path, percent-encoded.
        bytes: String,
    },
}

impl From<&Path> for PathText {
    fn from(path: &Path) -> Self {
        match path.to_str() {
            Some(text) => Self::Plain(text.to_owned()),
            None => not_utf8(path),
        }
    }
}

impl From<PathText> for PathBuf {
    fn from(text: PathText) -> Self {
        match text {
            PathText::Plain(text) => text.into(),
            PathText::Bytes { bytes } => of_bytes(percent_decode_str(&bytes).collect()),
        }
    }
}

#[cfg(unix)]
fn not_utf8(path: &Path) -> PathText {
    use percent_encoding::{AsciiSet, CONTROLS, percent_encode};
    use std::os::unix::ffi::OsStrExt as _;
    const ESCAPED: &AsciiSet = &CONTROLS.add(b'%');
    PathText::Bytes {
        bytes: percent_encode(path.as_os_str().as_bytes(), ESCAPED).to_string(),
    }
}

#[cfg(unix)]
fn of_bytes(bytes: Vec<u8>) -> PathBuf {
    use std::os::unix::ffi::OsStringExt as _;
    std::ffi::OsString::from_vec(bytes).into()
}

#[cfg(not(unix))]
fn not_utf8(path: &Path) -> PathText {
    PathText::Plain(path.to_string_lossy().into_owned())
}

#[cfg(not(unix))]
fn of_bytes(bytes: Vec<u8>) -> PathBuf {
    String::from_utf8_lossy(&bytes).into_owned().into()
}

/// Value made of paths: one, an optional one, a list.
pub trait Paths {
    /// Form of the value in files.
    type Text: Serialize + DeserializeOwned;

    /// Form in files of this value.
    fn to_text(&self) -> Self::Text;

    /// Value of a form in files.
    fn from_text(text: Self::Text) -> Self;
}

impl Paths for PathBuf {
    type Text = PathText;

    fn to_text(&self) -> PathText {
        self.as_path().into()
    }

    fn from_text(text: PathText) -> Self {
        text.into()
    }
}

impl Paths for Option<PathBuf> {
    type Text = Option<PathText>;

    fn to_text(&self) -> Option<PathText> {
        self.as_deref().map(PathText::from)
    }

    fn from_text(text: Option<PathText>) -> Self {
        text.map(PathBuf::from)
    }
}

impl Paths for VecDeque<PathBuf> {
    type Text = VecDeque<PathText>;

    fn to_text(&self) -> VecDeque<PathText> {
        self.iter().map(Paths::to_text).collect()
    }

    fn from_text(text: VecDeque<PathText>) -> Self {
        text.into_iter().map(PathBuf::from).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Held {
        #[serde(with = "super")]
        one: PathBuf,
        #[serde(default, with = "super")]
        perhaps: Option<PathBuf>,
        #[serde(default, with = "super")]
        many: VecDeque<PathBuf>,
    }

    fn read(value: &serde_json::Value) -> Result<PathBuf, String> {
        let held: Result<Held, _> = serde_json::from_value(json!({ "one": value }));
        held.map(|held| held.one).map_err(|error| error.to_string())
    }

    #[test]
    fn utf8_is_written_as_it_always_was() {
        for text in [
            "/data/half brass.binary",
            "/100%/%41/a%E9.binary",
            "/\"quoted\"/back\\slash\\n",
            "{\"bytes\":\"/a\"}",
            "/Güte/β/\u{fffd}",
            "/tab\tand\nline",
            "C:\\far\\silver.binary",
            "",
        ] {
            let path = PathBuf::from(text);
            let held = Held {
                one: path.clone(),
                perhaps: Some(path.clone()),
                many: [path.clone(), path.clone()].into(),
            };
            // What serde makes of the paths themselves.
            let plain = json!({"one": path, "perhaps": path, "many": [path, path]});
            assert_eq!(serde_json::to_value(&held).expect("is written"), plain);
            assert_eq!(read(&json!(text)), Ok(path.clone()));
            assert_eq!(cell(&path), text);
        }
    }

    #[test]
    fn what_is_no_path_is_named() {
        for value in [
            json!(7),
            json!(["/a"]),
            json!({}),
            json!({"bytes": 7}),
            json!({"bytes": "/a", "more": 1}),
        ] {
            let said = read(&value).expect_err("no path");
            assert!(said.contains("expected a path"), "{said}");
        }
    }

    #[cfg(unix)]
    mod unix {
        use super::*;
        use std::ffi::OsString;
        use std::os::unix::ffi::OsStringExt as _;

        fn path(bytes: &[u8]) -> PathBuf {
            OsString::from_vec(bytes.to_vec()).into()
        }

        #[track_caller]
        fn leads_back(path: &Path) {
            let held = Held {
                one: path.to_owned(),
                perhaps: Some(path.to_owned()),
                many: [path.to_owned(), "/plain".into()].into(),
            };
            let text = serde_json::to_string(&held).expect("is written");
            let again: Held = serde_json::from_str(&text).expect("is read");
            assert_eq!(again, held, "{text}");
            let cell = cell(path);
            let again = match path.to_str() {
                Some(_) => PathBuf::from(cell),
                None => read(&serde_json::from_str(&cell).expect("JSON")).expect("a path"),
            };
            assert_eq!(again, path);
        }

        #[test]
        fn other_bytes_are_an_object_that_leads_back() {
            let grey = path(b"/a b/gr\xe9\xe9n 5%\n\"\\.binary");
            let text = serde_json::to_value(PathText::from(grey.as_path())).expect("is written");
            assert_eq!(text, json!({"bytes": "/a b/gr%E9%E9n 5%25%0A\"\\.binary"}));
            for bytes in [
                &b"gr\xe9\xe9n.binary"[..],
                b"/a b/%E9/\xe9",
                b"\xff%",
                b"\xff\"\\\r\n\t",
                b"\xc3\xa9\xe9",
                b"/\xf0\x9f\x98",
            ] {
                leads_back(&path(bytes));
            }
            // By hand: small digits, and a % that is none.
            assert_eq!(read(&json!({"bytes": "/%e9/50%"})), Ok(path(b"/\xe9/50%")));
        }

        #[test]
        fn any_bytes_lead_back() {
            let mut seed = 1u64;
            let mut draw = |below: u64| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (seed >> 33) % below
            };
            let mut others = 0;
            for _ in 0..5000 {
                let len = 1 + draw(12);
                // A name has no 0; half of the bytes are ASCII.
                let byte = |draw: &mut dyn FnMut(u64) -> u64| {
                    let most = if draw(2) == 0 { 127 } else { 255 };
                    1 + draw(most) as u8
                };
                let bytes: Vec<u8> = (0..len).map(|_| byte(&mut draw)).collect();
                let path = path(&bytes);
                others += usize::from(path.to_str().is_none());
                leads_back(&path);
                // Planted: the lossy text leads elsewhere.
                let lossy = PathBuf::from(path.to_string_lossy().into_owned());
                assert_eq!(lossy == path, path.to_str().is_some());
            }
            assert!((1000..4999).contains(&others), "{others}");
        }
    }
}
