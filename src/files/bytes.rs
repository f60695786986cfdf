//! Bytes of a regular file: its beginning, or all of it up to a limit.

use super::error::FileError;
use super::open::open;
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

/// Bytes at the beginning that tell a kind of file.
const HEAD: u64 = 256;

/// The first bytes of a file.
///
/// # Errors
/// One line with the path last.
pub fn read_head(path: &Path) -> Result<Vec<u8>, FileError> {
    let (file, _) = open(path)?;
    read(&file, HEAD, path)
}

/// All bytes of a file of at most `most`.
///
/// # Errors
/// One line with the path last; a file that is larger.
pub fn read_bytes(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let (file, len) = open(path)?;
    if len > most {
        let mib = most >> 20;
        let what = format!("the file is far too large for this; expected at most {mib} MiB");
        return Err(FileError::new(path, what));
    }
    read(&file, most, path)
}

fn read(file: &File, most: u64, path: &Path) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    file.take(most)
        .read_to_end(&mut bytes)
        .map_err(|error| FileError::io(path, "reading failed", &error))?;
    Ok(bytes)
}
