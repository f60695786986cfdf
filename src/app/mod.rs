//! The window.

use std::path::PathBuf;

/// Opens the window with these files.
///
/// # Errors
/// Why there is none.
pub fn run(_files: Vec<PathBuf>) -> Result<(), String> {
    Err("no window in this build".into())
}
