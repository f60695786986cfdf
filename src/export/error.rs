//! Why there is no figure.

use crate::files::FileError;

/// Why there is no figure: one line, with the path last where there is one.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A figure's spec says what cannot be drawn.
    #[error(transparent)]
    Spec(FileError),
    /// Something else.
    #[error("{0}")]
    Other(String),
    /// Nobody waits for it any more.
    #[error("stopped")]
    Stopped,
}
