//! Fitting in the window: what is asked for, what is under way, what is kept.
//!
//! ```text
//! Settings ── Command::Fit ──▶ Run + Task::Fit ──▶ a job (jobs/fit.rs)
//!                               │                      │ what it reports is gathered for about a frame
//!     what is on screen ◀── Run.live ◀── FitMsg::Updates ┘
//!                               │
//! Esc, a slider, another fit: stop ── the best so far becomes the model, at once, as one step
//!                               │
//!                          FitMsg::Done ──▶ Material.fits, one KeptFit per variant
//! ```
//!
//! The scene does not change while a fit runs: [`crate::app::state::State::current`] lays `FitRun.live` over it, and the end is one edit.
//! So the fit is one step of the history whatever else is edited meanwhile. Kept fits, settings and check boxes are
//! beside the scene: undo brings the model's numbers back, not these.
//!
//! A run of the shown model drives the model of its material; one that compares leaves it alone and fills the table.
//! Newest wins: a run that is stopped or replaced is known by its number, and its later reports change nothing.
//!
//! "Keep ρ_d, k_s optimal": an edit of the model's shape asks for their refit; the answer sets ρ_d and k_s of
//! whatever shape is there then, without a step of its own, so that a drag with its answers is one step.

pub mod comparison;
pub mod kept;
pub mod run;
pub mod settings;
pub mod table;

use crate::app::state::fitting::run::FitRun;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::state::fitting::table::FitTable;

/// The part of the state that is about fitting.
#[derive(Debug, Default)]
pub struct FitState {
    /// Settings of the next fit.
    pub settings: FitSettings,
    /// The fit under way, or told to stop and not yet gone.
    pub run: Option<FitRun>,
    /// Whether ρ_d and k_s follow the other parameters.
    pub keep_optimal: bool,
    /// Refits of ρ_d and k_s with a smaller number are out of date.
    pub refit_from: u64,
    /// The refit of a model that was taken whole: its answer counts though ρ_d and k_s follow nothing.
    pub refit_taken: u64,
    /// Columns and order of the table.
    pub table: FitTable,
}
