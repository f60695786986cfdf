//! A fit of a whole folder under way.

use crate::app::state::job::{CancelFlag, Hold};

/// A fit of the folder that is under way. It ends with this.
#[derive(Debug)]
pub struct FolderRun {
    /// Tells it from older ones.
    pub number: u64,
    /// Number of files it fits.
    pub total: usize,
    /// Number of files that are done.
    pub done: usize,
    /// Progress of the present file, in [0, 1].
    pub share: f32,
    /// Name of the present file.
    pub name: String,
    /// Why files could not be fitted.
    pub failed: Vec<String>,
    /// Makes it wait.
    pub hold: Hold,
    /// Set to make it stop.
    pub cancel: CancelFlag,
}

impl Drop for FolderRun {
    fn drop(&mut self) {
        self.cancel.set();
    }
}

impl FolderRun {
    /// Progress of the whole run, in [0, 1].
    pub fn progress(&self) -> f32 {
        (self.done as f32 + self.share.clamp(0.0, 1.0)) / self.total.max(1) as f32
    }
}
