//! The data of a fit.

use super::options::{Options, STAGES, Variant, Weight};
use super::outcome::{Ended, Errors, Outcome, Progress, StageReport};
use crate::brdf::Brdf;
use crate::measured::Table;

/// A table, a weight and a grazing limit: what the error of a model is measured on.
#[derive(Clone, Debug)]
pub struct Problem {
    guess: Brdf,
}

/// Why there is nothing to fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProblemError {
    /// No cell counts.
    #[error("no cell is measured within the grazing limit; raise the limit")]
    NoCells,
    /// Σ w f is 0.
    #[error("every measured value within the grazing limit is 0; there is nothing to fit")]
    Black,
}

impl Problem {
    /// Arranges a table for fitting. `limit` is the grazing limit in radians: cells with θi or θo above it do not
    /// count, and [`super::options::NO_LIMIT`] leaves none out that is above the horizon.
    ///
    /// # Errors
    /// If no cell counts or all are 0.
    pub fn new(table: &Table, _weight: Weight, _limit: f64) -> Result<Self, ProblemError> {
        Ok(Self {
            guess: super::start::from_table(table),
        })
    }

    /// E of a model.
    pub fn errors(&self, _brdf: &Brdf) -> Errors {
        Errors {
            total: 0.25,
            grazing: Some(0.5),
            channels: [0.2, 0.25, 0.3],
        }
    }

    /// The model with the best ρ_d and k_s within their default bounds for its (s, α, η): stage 1.
    pub fn with_best_amplitudes(&self, brdf: &Brdf) -> Brdf {
        *brdf
    }
}

pub(super) fn stub(
    problem: &Problem,
    variant: Variant,
    options: &Options,
    watch: super::Watch,
) -> Outcome {
    let guess = problem.guess.with_model(variant.model);
    let mut ended = Ended::Converged;
    let mut brdf = variant.with(guess.params);
    let mut stages = Vec::new();
    for stage in STAGES.into_iter().filter(|stage| options.runs(*stage)) {
        let start = brdf;
        for k in 0..50 {
            brdf.params.s *= 1.002;
            std::hint::black_box((0..2_000_000).fold(0.0_f64, |a, k| (a + f64::from(k)).sqrt()));
            let progress = Progress {
                stage,
                brdf,
                error: 0.3 / (1.0 + 0.01 * f64::from(k)) / stage.number() as f64,
                all_cells: k > 30,
                evaluations: k as usize + 1,
                share: (stage.number() as f32 - 1.0 + k as f32 / 50.0) / 4.0,
            };
            if watch(&progress).is_break() {
                ended = Ended::Cancelled;
                break;
            }
        }
        stages.push(StageReport {
            stage,
            start,
            start_error: 0.3 / stage.number() as f64,
            end: brdf,
            error: 0.2 / stage.number() as f64,
            evaluations: 50,
        });
        if ended == Ended::Cancelled {
            break;
        }
    }
    Outcome {
        brdf,
        errors: problem.errors(&brdf),
        evaluations: 50 * stages.len(),
        stages,
        ended,
        albedo: [[0.3; 3]; 3],
        concerns: Vec::new(),
    }
}
