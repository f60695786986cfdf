//! What a fit says while it runs and when it ends.

use super::options::Stage;
use crate::brdf::{Brdf, ParamId};
use crate::geom::Rgb;
use std::ops::ControlFlow;

/// E = Σ w |f̂ − f| / Σ w f over the cells that count, over parts of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Over all cells and channels.
    pub total: f64,
    /// Over cells with θi or θo ≥ 70°; `None` where the grazing limit leaves none.
    pub grazing: Option<f64>,
    /// Per channel, each against its own Σ w f. NaN for a channel that is black.
    pub channels: Rgb,
}

/// The best so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The stage under way.
    pub stage: Stage,
    /// The best of this stage so far.
    pub brdf: Brdf,
    /// Its E; estimated on a part of the cells unless `all_cells`. The estimate may pass the last word by a little.
    pub error: f64,
    /// Whether `error` is over all cells.
    pub all_cells: bool,
    /// How many shapes (s, α, η) this stage has tried.
    pub evaluations: usize,
    /// Roughly how far the whole fit is, in [0, 1].
    pub share: f32,
}

/// Called with the best so far, at least every few hundredths of a second and once a stage; may stop the fit. Calls
/// come one at a time, but from any thread of the pool.
pub type Watch<'a> = &'a mut (dyn FnMut(&Progress) -> ControlFlow<()> + Send);

/// A stage that is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageReport {
    /// Which one.
    pub stage: Stage,
    /// Where it began.
    pub start: Brdf,
    /// E there, over all cells.
    pub start_error: f64,
    /// Where it ended.
    pub end: Brdf,
    /// E there, over all cells; never above `start_error`.
    pub error: f64,
    /// How many shapes (s, α, η) it has tried.
    pub evaluations: usize,
}

/// Why a fit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ended {
    /// Nothing near is better.
    Converged,
    /// It used up its evaluations before that.
    Limit,
    /// It was told to stop.
    Cancelled,
}

impl Ended {
    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Limit => "evaluation limit",
            Self::Cancelled => "cancelled",
        }
    }
}

/// What one should know before trusting the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Concern {
    /// A parameter ended at a bound: which, and the bound.
    AtBound(ParamId, f64),
    /// The lobe is narrower than the bins at the highlight can tell.
    TooGlossy,
    /// η is so near 1 that only k_s·R_F(0) is determined.
    EtaNearOne,
    /// The fitted lobe adds nothing: k_s is 0 in all channels, so that s, α and η mean nothing.
    NoHighlight,
    /// The model reflects more than it receives at one of the angles of [`super::outcome::ALBEDO_ANGLES`].
    AlbedoAboveOne,
}

impl Concern {
    /// One sentence for people, in plain characters.
    pub fn text(&self) -> String {
        match self {
            Self::AtBound(id, bound) => {
                format!(
                    "{} ended at its bound {bound}; the best may lie beyond.",
                    id.key()
                )
            }
            Self::TooGlossy => {
                "The highlight is narrower than a few bins of the table; s is a lower limit.".into()
            }
            Self::EtaNearOne => "eta went to 1: only the product k_s R_F(0) is determined.".into(),
            Self::NoHighlight => {
                "k_s is 0: the data show no lobe, and s, alpha, eta mean nothing.".into()
            }
            Self::AlbedoAboveOne => "The model reflects more light than it receives.".into(),
        }
    }
}

/// Angles of incidence at which the directional albedo is given, in degrees.
pub const ALBEDO_ANGLES: [f64; 3] = [0.0, 45.0, 80.0];

/// What a fit brings.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The fitted model.
    pub brdf: Brdf,
    /// Its E over all cells.
    pub errors: Errors,
    /// The stages that were run, in order.
    pub stages: Vec<StageReport>,
    /// How many shapes (s, α, η) were tried in all.
    pub evaluations: usize,
    /// Why it ended.
    pub ended: Ended,
    /// Directional albedo of the model at [`ALBEDO_ANGLES`].
    pub albedo: [Rgb; 3],
    /// What to know before trusting it.
    pub concerns: Vec<Concern>,
}

impl Outcome {
    /// Whether the model reflects more than it receives at one of the angles.
    pub fn exceeds_one(&self) -> bool {
        self.albedo.iter().flatten().any(|albedo| *albedo > 1.0)
    }
}
