//! JSON files: told from others by their beginning, and read once and up to a bound.

use super::error::FileError;
use crate::brdf;
use crate::encoding::{WIDE, is_wide};
use crate::json;
use crate::quote::quoted;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek};
use std::path::Path;

/// Bytes of a JSON file at most.
pub const MOST: u64 = 64 << 20;

/// Bytes at most of a file that begins with a model in an array, as fit files do: those of 100,000 fits and more.
pub const MOST_OF_FITS: u64 = 256 << 20;

/// Bytes at the beginning of a file that say what it is.
const HEAD: u64 = 64 << 10;

/// Beginning of a JSON file.
pub struct Head {
    /// The first 64 KiB, without a byte order mark and without half a character at the end.
    pub text: String,
}

impl Head {
    /// Whether it is an array whose first entry is a model.
    pub fn begins_with_model(&self) -> bool {
        let mut is_model = false;
        // The first entry is enough, and the text ends soon after.
        let _ = json::entries(&self.text, &brdf::json::is_key, &mut |at, value| {
            is_model = at.is_some() && brdf::json::from_value(&value).is_ok();
            Err(String::new())
        });
        is_model
    }
}

/// Beginning of a JSON file; `None` if the file is something else. Leaves the file at its start.
///
/// # Errors
/// Says what a file is that is called `.json`, or that is text of another encoding.
pub fn head(file: &mut File, path: &Path) -> Result<Option<Head>, FileError> {
    let (bytes, first) =
        beginning(file).map_err(|error| FileError::io(path, "reading failed", &error))?;
    if is_wide(&bytes) {
        return Err(FileError::new(path, format!("not valid JSON: {WIDE}")));
    }
    let text = bytes.strip_prefix(BOM).unwrap_or(&bytes);
    if matches!(first, Some(b'{' | b'[')) {
        let text = String::from_utf8_lossy(text);
        let text = text.trim_end_matches('\u{fffd}').to_owned();
        return Ok(Some(Head { text }));
    }
    let named = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    let is_binary = text.iter().any(|byte| *byte < 9 || *byte == 0x7f);
    if !named || is_binary {
        return Ok(None);
    }
    let text = String::from_utf8_lossy(text);
    let text = text.trim_start();
    let what = if first.is_none() {
        "the file is empty; expected JSON".to_owned()
    } else if ["//", "/*", "#"]
        .iter()
        .any(|comment| text.starts_with(comment))
    {
        "not valid JSON: it begins with a comment, which JSON has not; leave that out".to_owned()
    } else {
        let begin: String = text.chars().take(20).collect();
        format!(
            "not valid JSON: it begins with {}; expected {{ or [",
            quoted(&begin)
        )
    };
    Err(FileError::new(path, what))
}

/// Text of a JSON file; `None` if the file is something else.
///
/// # Errors
/// Errors of [`head`]; a file that is larger than is read, or no UTF-8.
pub fn text(file: &mut File, len: u64, path: &Path) -> Result<Option<String>, FileError> {
    let Some(head) = head(file, path)? else {
        return Ok(None);
    };
    let most = if len > MOST && head.begins_with_model() {
        MOST_OF_FITS
    } else {
        MOST
    };
    rest(file, len, most, path).map(Some)
}

/// Remaining text of a file, without a byte order mark.
///
/// # Errors
/// Says that the file has more than `most` bytes or is no UTF-8.
pub fn rest(file: &mut File, len: u64, most: u64, path: &Path) -> Result<String, FileError> {
    // A file that grows, or does not tell its length, is not read on either.
    let mut bytes = Vec::with_capacity(usize::try_from(len.min(most)).unwrap_or(0) + 1);
    if len <= most {
        let read = file.take(most + 1).read_to_end(&mut bytes);
        read.map_err(|error| FileError::io(path, "reading failed", &error))?;
    }
    if len > most || bytes.len() as u64 > most {
        let [most, fits] = [MOST, MOST_OF_FITS].map(|bytes| bytes >> 20);
        let what = format!(
            "the file is too large; JSON is read up to {most} MiB, and up to {fits} MiB where it begins as a fit file does"
        );
        return Err(FileError::new(path, what));
    }
    if bytes.starts_with(BOM) {
        bytes.drain(..BOM.len());
    }
    String::from_utf8(bytes).map_err(|error| {
        let what = if is_wide(error.as_bytes()) {
            WIDE
        } else {
            "it is no UTF-8 text"
        };
        FileError::new(path, format!("not valid JSON: {what}"))
    })
}

/// Byte order mark of UTF-8.
const BOM: &[u8] = b"\xef\xbb\xbf";

/// The first bytes of a file, and the first byte that is no white space, as far as JSON is read. Leaves the file at its
/// start.
fn beginning(file: &mut File) -> io::Result<(Vec<u8>, Option<u8>)> {
    let mut bytes = Vec::new();
    file.by_ref().take(HEAD).read_to_end(&mut bytes)?;
    let text = bytes.strip_prefix(BOM).unwrap_or(&bytes);
    let is_blank = |byte: &&u8| byte.is_ascii_whitespace();
    let mut first = text.iter().find(|byte| !is_blank(byte)).copied();
    if first.is_none() && bytes.len() as u64 == HEAD {
        let mut further = BufReader::new(file.by_ref().take(MOST));
        while first.is_none() {
            let chunk = further.fill_buf()?;
            if chunk.is_empty() {
                break;
            }
            first = chunk.iter().find(|byte| !is_blank(byte)).copied();
            let length = chunk.len();
            further.consume(length);
        }
    }
    file.rewind()?;
    Ok((bytes, first))
}
