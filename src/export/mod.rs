//! Figures from files to files: opens what a figure names, fits and surveys what it needs, draws it, writes it.
//!
//! The window and the command line come here alike, so that the same figure gives the same bytes in both. May know all
//! but the window and the graphics adapter.
//!
//! ```text
//! FigureSpec ── prepare ──▶ Prepared ── draw ──▶ Page ── Format::bytes ──▶ write
//! ```

pub mod made;
mod prepare;
pub mod preset;
mod spec;
mod write;

pub use prepare::{Opened, Prepared, open_from_files, prepare};
pub use spec::{FigureSpec, SubjectLook, SubjectSource, SubjectSpec, spec_beside};
pub use write::{FORMATS, Format, write_figure};

use crate::files::FileError;

/// Why there is no figure: one line, with the path last where there is one.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// Something else.
    #[error("{0}")]
    Other(String),
    /// Nobody waits for it any more.
    #[error("stopped")]
    Stopped,
}

#[cfg(test)]
mod tests;
