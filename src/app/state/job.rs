//! Jobs under way, and the switches that stop them or make them wait.

use crate::app::state::material::MaterialId;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// A job under way.
#[derive(Clone, Debug)]
pub struct Job {
    /// Number of the job.
    pub id: u64,
    /// Activity, for the status bar.
    pub label: String,
    /// Progress, in [0, 1].
    pub progress: f32,
    /// Set to make it stop.
    pub cancel: CancelFlag,
    /// Use of the material that it brings.
    pub purpose: Purpose,
}

/// Use of the material that a job brings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Purpose {
    /// A new material.
    #[default]
    Open,
    /// A material that a person steps through, if it is still asked for.
    Preview,
    /// The data of this material, which were let go.
    Reload(MaterialId),
}

/// A flag that a job looks at.
#[derive(Clone, Debug, Default)]
pub struct CancelFlag(Arc<AtomicBool>);

impl CancelFlag {
    /// Asks the job to stop.
    pub fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the job is to stop.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A switch that makes threads wait.
#[derive(Clone, Debug, Default)]
pub struct Hold(Arc<AtomicBool>);

impl Hold {
    /// Lets them wait, or go on.
    pub fn set(&self, wait: bool) {
        self.0.store(wait, Ordering::Relaxed);
    }

    /// Returns when it is off or the job is cancelled. Not for the window's thread.
    pub fn wait(&self, cancel: &CancelFlag) {
        while self.0.load(Ordering::Relaxed) && !cancel.is_set() {
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}
