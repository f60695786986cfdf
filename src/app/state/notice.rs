//! Notices in the corner of the window, and the dialogs over it.

use crate::app::guide::GuideAt;

/// Severity of a notice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Good to know.
    Info,
    /// Something did not work.
    Error,
}

/// A sentence in the corner of the window, until it is closed.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// Number of the notice.
    pub id: u64,
    /// Severity.
    pub level: Severity,
    /// One line.
    pub text: String,
}

/// A window over the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialog {
    /// All commands, to be searched.
    Palette,
    /// A path to open, typed.
    OpenPath,
    /// A figure to export.
    Figure,
    /// The pages of the guide, at a place.
    Guide(GuideAt),
    /// Angles, vectors, units.
    Conventions,
    /// Version and graphics adapter.
    About,
}
