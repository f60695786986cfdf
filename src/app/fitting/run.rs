//! A fit under way.

use super::{Heard, Setup};
use crate::app::state::{CancelFlag, MaterialId, Opened};
use crate::fit::{Progress, Stage, Variant};

/// A fit under way: of one variant, or of several.
#[derive(Debug)]
pub struct Run {
    /// Its number.
    pub job: u64,
    /// Of which material; another one may be shown.
    pub material: MaterialId,
    /// What is fitted, in order.
    pub parts: Vec<Part>,
    /// Position of the part that spoke last.
    pub at: usize,
    /// What it was asked.
    pub setup: Setup,
    /// Set to make it stop.
    pub cancel: CancelFlag,
    /// It was told to stop; its outcome is yet to come.
    pub stopping: bool,
    /// The best so far, shown in place of the scene's model. None for several variants, and none once it is stopped.
    pub live: Option<Opened>,
    /// What `live` was when the run was stopped.
    pub left: Option<Opened>,
}

/// One variant of a run.
#[derive(Debug)]
pub struct Part {
    /// What is fitted.
    pub variant: Variant,
    /// All that it said.
    pub heard: Vec<Progress>,
}

impl Part {
    /// The best so far.
    pub fn best(&self) -> Option<&Progress> {
        self.heard.last()
    }
}

impl Run {
    /// Whether it moves the model of its material: one variant does, several fill the table.
    pub fn drives_model(&self) -> bool {
        self.parts.len() == 1 && !self.stopping
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

    /// Takes in what was said.
    pub(super) fn hear(&mut self, heard: Heard) {
        for (position, progress) in heard.words {
            let Some(part) = self.parts.get_mut(position) else {
                continue;
            };
            part.heard.push(progress);
            self.at = position;
        }
        if self.drives_model()
            && let Some(best) = self.parts[0].best()
        {
            self.live = Some(Opened {
                beside: false,
                id: self.material,
                brdf: best.brdf,
            });
        }
    }
}

/// What a stage said: its first and its last words.
pub fn stage_words(heard: &[Progress], stage: Stage) -> Option<(&Progress, &Progress)> {
    let first = heard.iter().find(|progress| progress.stage == stage)?;
    let last = heard.iter().rfind(|progress| progress.stage == stage)?;
    Some((first, last))
}
