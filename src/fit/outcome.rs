//! Progress and result of a fit.

use super::stages::Stage;
use crate::brdf::{Brdf, ParamId};
use crate::geom::Rgb;
use std::ops::ControlFlow;

/// E = Σ w |f̂ − f| / Σ w f, over all cells that count and over parts of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// E over all cells and channels.
    pub total: f64,
    /// E over cells with θi or θo ≥ 70°; `None` where the grazing limit leaves none.
    pub grazing: Option<f64>,
    /// E per channel, each against its own Σ w f. NaN for a channel that is black.
    pub channels: Rgb,
}

/// Progress report of a fit: the best model so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitProgress {
    /// Stage under way.
    pub stage: Stage,
    /// Best model of this stage so far.
    pub brdf: Brdf,
    /// E of `brdf`; estimated on a sample of the cells unless `all_cells`. The estimate may end up slightly below the
    /// final E.
    pub error: f64,
    /// Whether `error` is over all cells.
    pub all_cells: bool,
    /// Number of shapes (lobe and η) that this stage has tried.
    pub evaluations: usize,
    /// Approximate share of the whole fit that is done, in [0, 1].
    pub share: f32,
}

/// Observer of a fit, called with the best model so far, at least every few hundredths of a second and once a stage;
/// may stop the fit. Calls come one at a time, but from any thread of the pool.
pub type Watch<'a> = &'a mut (dyn FnMut(&FitProgress) -> ControlFlow<()> + Send);

/// Report of a finished stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageReport {
    /// Stage that was run.
    pub stage: Stage,
    /// Model at the start of the stage.
    pub start: Brdf,
    /// E of `start`, over all cells.
    pub start_error: f64,
    /// Model at the end of the stage.
    pub end: Brdf,
    /// E of `end`, over all cells; never above `start_error`.
    pub error: f64,
    /// Number of shapes (lobe and η) that the stage has tried.
    pub evaluations: usize,
}

/// Reason why a fit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EndReason {
    /// No step promised a lower E.
    Converged,
    /// The evaluations were used up before that.
    Limit,
    /// The observer stopped it.
    Cancelled,
}

impl EndReason {
    /// Name in files, e.g. "converged".
    pub fn key(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Limit => "evaluation limit",
            Self::Cancelled => "cancelled",
        }
    }
}

/// Reason to distrust fitted parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Concern {
    /// A parameter ended at its bound: its identity and the bound.
    AtBound(ParamId, f64),
    /// A parameter ended at a bound beyond which nothing is to be had: what that means.
    AtEnd(&'static str),
    /// The lobe is narrower than the bins at the highlight resolve: the parameter that sets its width, and whether it is
    /// a lower limit, as an exponent is, or an upper one.
    TooGlossy {
        /// Identity of the parameter.
        id: ParamId,
        /// Whether a larger value makes the lobe narrower.
        is_lower_limit: bool,
    },
    /// η is so near 1 that only k_s·R_F(0) is determined.
    EtaNearOne,
    /// k_s is 0 in all channels, so that the lobe's parameters and η mean nothing.
    NoHighlight,
    /// The directional albedo of the model is above 1 at one of [`super::outcome::ALBEDO_ANGLES`].
    AlbedoAboveOne,
}

impl Concern {
    /// Message in one sentence, in plain characters.
    pub fn text(&self) -> String {
        match self {
            Self::AtBound(id, bound) => {
                format!(
                    "{} ended at its bound {bound}; the best may lie beyond.",
                    id.key()
                )
            }
            Self::AtEnd(meaning) => (*meaning).into(),
            Self::TooGlossy { id, is_lower_limit } => {
                let limit = if *is_lower_limit {
                    "a lower"
                } else {
                    "an upper"
                };
                format!(
                    "The highlight is narrower than a few bins of the table; {} is {limit} limit.",
                    id.key()
                )
            }
            Self::EtaNearOne => "eta went to 1: only the product k_s R_F(0) is determined.".into(),
            Self::NoHighlight => {
                "k_s is 0: the data show no lobe, and its parameters and eta mean nothing.".into()
            }
            Self::AlbedoAboveOne => "The model reflects more light than it receives.".into(),
        }
    }
}

/// Angles of incidence of the reported directional albedo, in degrees.
pub const ALBEDO_ANGLES: [f64; 3] = [0.0, 45.0, 80.0];

/// Result of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Fitted model.
    pub brdf: Brdf,
    /// E of the fitted model over all cells.
    pub errors: Errors,
    /// Reports of the stages that were run, in order.
    pub stages: Vec<StageReport>,
    /// Number of shapes (lobe and η) that were tried in all.
    pub evaluations: usize,
    /// Reason why the fit ended.
    pub ended: EndReason,
    /// Directional albedo of the model at [`ALBEDO_ANGLES`], linear RGB.
    pub albedo: [Rgb; 3],
    /// Concerns about the parameters, the gravest first.
    pub concerns: Vec<Concern>,
}

impl Outcome {
    /// Whether the directional albedo is above 1 at one of [`ALBEDO_ANGLES`].
    pub fn exceeds_one(&self) -> bool {
        self.albedo.iter().flatten().any(|albedo| *albedo > 1.0)
    }
}
