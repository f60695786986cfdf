//! Messages and tasks of fitting.

use crate::app::state::fitting::run::FitUpdates;
use crate::app::state::fitting::settings::{FitSettings, Setup};
use crate::app::state::fitting::table::Column;
use crate::app::state::job::CancelFlag;
use crate::app::state::material::MaterialId;
use crate::brdf::Brdf;
use crate::fit::{Outcome, ProblemError, Variant};
use crate::measured::Table;
use std::sync::Arc;

/// Something happened to the fits.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum FitMsg {
    /// Change what the next fit is asked.
    Settings(FitSettings),
    /// The fit under way reports.
    Updates(FitUpdates),
    /// A fit ended.
    Done {
        job: u64,
        result: Result<Vec<Timed>, String>,
    },
    /// Lay the kept fit of this variant over the shown material.
    Show(Variant),
    /// Draw the kept fit of this variant beside the model, or no longer.
    Overlay(Variant, bool),
    /// Order the table by a column; the other way round where it is.
    SortBy(Column),
    /// Show a column of the table, or hide it.
    ShowColumn(Column, bool),
    /// The best ρ_d and k_s for a model; only these two are taken from it.
    AmplitudesRefit {
        number: u64,
        as_step: bool,
        material: MaterialId,
        result: Result<Brdf, ProblemError>,
    },
}

/// An outcome and the seconds that it took.
#[derive(Clone, Debug)]
pub struct Timed {
    /// Result of the fit.
    pub outcome: Outcome,
    /// Duration in seconds.
    pub seconds: f64,
}

/// A fit to be started in the background.
#[derive(Debug)]
pub struct FitTask {
    /// Number of the job.
    pub job: u64,
    /// Material that is fitted.
    pub material: MaterialId,
    /// The data.
    pub table: Arc<Table>,
    /// Variants that are fitted; one, or several.
    pub variants: Vec<Variant>,
    /// Settings of the fit.
    pub setup: Setup,
    /// Set to make it stop.
    pub cancel: CancelFlag,
}

/// Asks for the best ρ_d and k_s of a model in the background.
#[derive(Debug)]
pub struct RefitAmplitudes {
    /// Number of the request; newer ones win.
    pub number: u64,
    /// Material that is fitted.
    pub material: MaterialId,
    /// The data.
    pub table: Arc<Table>,
    /// Settings of the fit.
    pub setup: Setup,
    /// Model whose lobe and η are kept.
    pub brdf: Brdf,
    /// Whether the answer is a step of its own: no edit asked for it.
    pub as_step: bool,
}
