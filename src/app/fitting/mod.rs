//! Fitting in the window: what is asked for, what is under way, what is kept.
//!
//! ```text
//! Settings ── Command::Fit ──▶ Run + Task::Fit ──▶ a thread with a pool of its own (work.rs)
//!                               │                      │ every word of the fit goes into a slot
//!     what is on screen ◀── Run.live ◀── FitMsg::Heard ┘ that the window empties at each frame
//!                               │
//! Esc, a slider, another fit: stop ── the best so far becomes the model, at once, as one step
//!                               │
//!                          FitMsg::Done ──▶ Material.fits, one KeptFit per variant
//! ```
//!
//! The scene does not change while a fit runs: [`State::current`] lays `Run.live` over it, and the end is one edit.
//! So the fit is one step of the history whatever else is edited meanwhile. Kept fits, settings and check boxes are
//! beside the scene: undo brings the model's numbers back, not these.
//!
//! A run of one variant drives the model of its material; a run of several leaves the model alone and fills the table.
//! Newest wins: a run that is stopped or replaced is known by its number, and what it says later is not heard.
//!
//! "Keep ρ_d, k_s optimal": an edit of the model's shape asks for a [`Resolve`]; the answer sets ρ_d and k_s of
//! whatever shape is there then, without a step of its own, so that a drag with its answers is one step.

mod kept;
mod run;
pub(super) mod steps;
pub(super) mod work;

pub use kept::{KeptFit, Settings, Setup, SortBy, short_variant_name, variant_name};
pub use run::{Part, Run, stage_words};

use super::state::{CancelFlag, MaterialId, State};
use crate::brdf::Brdf;
use crate::fit::{Outcome, ProblemError, Progress, Variant};
use crate::measured::Table;
use std::sync::Arc;

/// The part of the state that is about fitting.
#[derive(Debug, Default)]
pub struct FitState {
    /// What the next fit is asked.
    pub settings: Settings,
    /// The fit under way, or told to stop and not yet gone.
    pub run: Option<Run>,
    /// Whether ρ_d and k_s follow the other parameters.
    pub keep_optimal: bool,
    /// Answers to a [`Resolve`] with a smaller number are out of date.
    pub resolve_from: u64,
    /// The [`Resolve`] of a model that was taken whole: its answer counts though ρ_d and k_s follow nothing.
    pub resolve_taken: u64,
    /// Order of the table.
    pub sort: SortBy,
}

/// Something happened to the fits.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum FitMsg {
    /// Change what the next fit is asked.
    Settings(Settings),
    /// What the fit under way has said since the last frame.
    Heard(Heard),
    /// A fit ended; `rest` is what it said since it was last heard.
    Done {
        job: u64,
        rest: Option<Heard>,
        result: Result<Vec<Timed>, String>,
    },
    /// Lay the kept fit of this variant over the shown material.
    Show(Variant),
    /// Draw the kept fit of this variant beside the model, or no longer.
    Overlay(Variant, bool),
    /// Order the table.
    SortBy(SortBy),
    /// The best ρ_d and k_s for a model; only these two are taken from it.
    Resolved {
        number: u64,
        as_step: bool,
        material: MaterialId,
        result: Result<Brdf, ProblemError>,
    },
}

/// Words of a fit, in order: the position of the variant, and what was said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heard {
    /// Whose.
    pub job: u64,
    /// All since the last time.
    pub words: Vec<(usize, Progress)>,
}

/// An outcome and the seconds that it took.
#[derive(Clone, Debug)]
pub struct Timed {
    /// What it brought.
    pub outcome: Outcome,
    /// How long it took, in seconds.
    pub seconds: f64,
}

/// A fit to be started in the background.
#[derive(Debug)]
pub struct FitTask {
    /// Its number.
    pub job: u64,
    /// Of which material.
    pub material: MaterialId,
    /// The data.
    pub table: Arc<Table>,
    /// What is fitted; one, or several.
    pub variants: Vec<Variant>,
    /// How.
    pub setup: Setup,
    /// Set to make it stop.
    pub cancel: CancelFlag,
}

/// Asks for the best ρ_d and k_s of a model in the background.
#[derive(Debug)]
pub struct Resolve {
    /// Its number; newer ones win.
    pub number: u64,
    /// Of which material.
    pub material: MaterialId,
    /// The data.
    pub table: Arc<Table>,
    /// How.
    pub setup: Setup,
    /// For these s, α and η.
    pub brdf: Brdf,
    /// Whether the answer is a step of its own: no edit asked for it.
    pub as_step: bool,
}

impl State {
    /// Keeps a fit of a material in place of the one of the same variant.
    ///
    /// One that was cancelled does not replace one that was made with the same setup and ran to its end.
    /// Of a file, it is kept with the path too: the file may be opened again.
    pub fn keep_fit(&mut self, material: MaterialId, mut fit: KeptFit) {
        let Some(material) = self.materials.get_mut(&material) else {
            return;
        };
        let variant = fit.variant();
        match material
            .fits
            .iter_mut()
            .find(|kept| kept.variant() == fit.variant())
        {
            Some(kept)
                if fit.is_cancelled()
                    && !kept.is_cancelled()
                    && kept.setup.asks_the_same(&fit.setup) => {}
            Some(kept) => {
                fit.overlaid = kept.overlaid;
                *kept = fit;
            }
            None => material.fits.push(fit),
        }
        if let (Some(path), Some(kept)) = (material.file(), material.fit(variant)) {
            let record = kept.record(material.name.clone(), material.source.clone());
            self.library.keep_fit(&path, record);
        }
    }

    /// The kept fit of the shown material for the shown model and Fresnel factor.
    pub fn current_fit(&self) -> Option<&KeptFit> {
        let (material, opened) = self.current()?;
        material.fit(Variant::from(&opened.brdf))
    }

    /// The run under way, if it is of the shown material.
    pub fn current_run(&self) -> Option<&Run> {
        let opened = self.scene.opened.get(self.scene.selected)?;
        self.fit
            .run
            .as_ref()
            .filter(|run| run.material == opened.id)
    }

    /// Whether the settings would ask something else now than what the fit was asked.
    pub fn is_stale(&self, fit: &KeptFit) -> bool {
        self.current().is_some_and(|(_, opened)| {
            !fit.setup
                .asks_the_same(&self.fit.settings.setup(&opened.brdf))
        })
    }

    /// Why no fit can be started now, in words.
    pub fn fit_blocked(&self) -> Option<&'static str> {
        let Some((material, opened)) = self.current() else {
            return Some("Open a material first.");
        };
        if material.is_loading() {
            return Some("The data of this material are being loaded.");
        }
        self.fit.settings.blocked(&opened.brdf)
    }
}
