//! Figures from files to files: opens what a figure names, fits and surveys what it needs, draws it, writes it.
//!
//! The window and the command line come here alike, so that the same figure gives the same bytes in both. May know all
//! but the window and the graphics adapter.
//!
//! ```text
//! FigureSpec ── prepare ──▶ Prepared ── draw ──▶ Page ── FigureFormat::bytes ──▶ write
//! ```

mod error;
pub mod fit_output;
pub mod fonts;
mod prepare;
pub mod preset;
mod recipe;
mod spec;
mod write;

pub use error::ExportError;
pub use prepare::{OpenedTable, OpenedTables, Prepared, open_from_files, prepare};
pub use recipe::recipe_in;
pub use spec::{FigureSpec, SubjectLook, SubjectSource, SubjectSpec, spec_beside};
pub use write::{FORMATS, FigureFormat, check_writable, write_figure};

#[cfg(test)]
mod tests;
