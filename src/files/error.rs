//! Errors of files.

use crate::measured::merl::MerlError;
use crate::quote;
use std::fmt;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Error of a file. Shown as one line with the path last. What it quotes is bounded where it is quoted, by
/// `crate::quote`.
#[derive(Debug)]
pub struct FileError {
    path: PathBuf,
    what: String,
    cancelled: bool,
}

impl FileError {
    /// Error with a text that says what is wrong and what was expected.
    pub fn new(path: &Path, what: impl Into<String>) -> Self {
        Self {
            path: path.to_owned(),
            what: what.into(),
            cancelled: false,
        }
    }

    /// Error of the operating system, in plain words; `doing` says what failed where there are none.
    pub fn io(path: &Path, doing: &str, error: &io::Error) -> Self {
        let what = match error.kind() {
            ErrorKind::NotFound => "there is no such file or directory".into(),
            ErrorKind::PermissionDenied => {
                format!("{doing}: no permission; change it or use a copy")
            }
            ErrorKind::StorageFull => format!("{doing}: the disk is full"),
            ErrorKind::NotADirectory => "a part of the path is no directory".into(),
            _ => format!("{doing}: {error}"),
        };
        Self::new(path, what)
    }

    /// Error of the reader of MERL files.
    pub fn merl(path: &Path, error: MerlError) -> Self {
        match error {
            MerlError::Io(error) => Self::io(path, "reading failed", &error),
            error => Self {
                cancelled: matches!(error, MerlError::Cancelled),
                ..Self::new(path, error.to_string())
            },
        }
    }

    /// Path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reason in one line, without the path.
    pub fn reason(&self) -> String {
        quote::one_line(&self.what)
    }

    /// Whether reading was cancelled by `progress`, which is no error to show.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.reason(), quote::path(&self.path))
    }
}

impl std::error::Error for FileError {}
