//! A fit under way.

use crate::app::state::fitting::settings::Setup;
use crate::app::state::job::CancelFlag;
use crate::app::state::material::{MaterialId, Opened};
use crate::brdf::Brdf;
use crate::fit::{FitProgress, Stage, Variant};

/// A fit under way: of the shown model, or of the models to compare.
#[derive(Debug)]
pub struct FitRun {
    /// Number of its job.
    pub job: u64,
    /// Material that is fitted; another one may be shown.
    pub material: MaterialId,
    /// Variants that are fitted, in order.
    pub parts: Vec<Part>,
    /// Whether its fits are compared in the table, and the model of the material stays as it is.
    pub compares: bool,
    /// Position of the part that spoke last.
    pub at: usize,
    /// Settings of the fit.
    pub setup: Setup,
    /// Set to make it stop.
    pub cancel: CancelFlag,
    /// Whether it was told to stop and its outcome is yet to come.
    pub stopping: bool,
    /// The best so far, shown in place of the scene's model. None for several variants, and none once it is stopped.
    pub live: Option<Opened>,
    /// The first guess that it began from, where it is part of the opening of its material.
    pub on_opening: Option<Brdf>,
    /// Model that `live` was when the run was stopped.
    pub left: Option<Opened>,
}

/// One variant of a run.
#[derive(Debug)]
pub struct Part {
    /// Model and Fresnel factor that are fitted.
    pub variant: Variant,
    /// Reports so far.
    pub updates: Vec<FitProgress>,
}

impl Part {
    /// The best so far.
    pub fn best(&self) -> Option<&FitProgress> {
        self.updates.last()
    }
}

impl FitRun {
    /// Whether it moves the model of its material.
    pub fn drives_model(&self) -> bool {
        !self.compares && !self.stopping
    }

    /// The part under way.
    pub fn current_part(&self) -> Option<&Part> {
        self.parts.get(self.at)
    }

    /// Roughly how far it is, in [0, 1].
    pub fn share(&self) -> f32 {
        let best = self.current_part().and_then(Part::best);
        let within = best.map_or(0.0, |progress| progress.share.clamp(0.0, 1.0));
        (self.at as f32 + within) / self.parts.len().max(1) as f32
    }

    /// Takes in reports.
    pub(crate) fn take_in(&mut self, updates: FitUpdates) {
        for (position, progress) in updates.updates {
            let Some(part) = self.parts.get_mut(position) else {
                continue;
            };
            part.updates.push(progress);
            self.at = position;
        }
        if self.drives_model()
            && let Some(best) = self.current_part().and_then(Part::best)
        {
            self.live = Some(Opened {
                beside: false,
                id: self.material,
                brdf: best.brdf,
            });
        }
    }
}

/// The first and the last report of a stage.
pub fn stage_ends(updates: &[FitProgress], stage: Stage) -> Option<(&FitProgress, &FitProgress)> {
    let first = updates.iter().find(|progress| progress.stage == stage)?;
    let last = updates.iter().rfind(|progress| progress.stage == stage)?;
    Some((first, last))
}

/// Reports of a fit, in order: the position of the variant, and its progress.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FitUpdates {
    /// Number of the fit.
    pub job: u64,
    /// All since the last message.
    pub updates: Vec<(usize, FitProgress)>,
}
