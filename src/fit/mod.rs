//! Fitting the models to a table by L1, as the poster does it [Nielsen14] and then all parameters together. Pure.
//!
//! ```text
//! Table ── Problem::new(weight, limit) ──▶ Problem        what is measured, arranged for passes over all cells
//! Problem + Variant + Options ── fit ──▶ Outcome          parameters, errors, stages; watched and stopped by a closure
//! ```
//!
//! Work is spread over the threads of the current rayon pool; results do not depend on their number.

mod cells;
mod descent;
#[cfg(test)]
mod experiment;
mod lanes;
pub mod options;
pub mod outcome;
mod passes;
pub mod problem;
mod regression;
mod shape;
mod sites;
pub mod start;
mod vertex;

pub use options::{Options, Partial, STAGES, Stage, Variant, WEIGHTS, Weight};
pub use outcome::{Concern, Ended, Errors, Outcome, Progress, StageReport};
pub use problem::{Problem, ProblemError};

use std::ops::ControlFlow;

/// Called with the best so far, several times a second and at least once a stage; may stop the fit.
pub type Watch<'a> = &'a mut dyn FnMut(&Progress) -> ControlFlow<()>;

/// Fits one variant.
///
/// Stopped by `watch`, the outcome is the best so far.
pub fn fit(problem: &Problem, variant: Variant, options: &Options, watch: Watch) -> Outcome {
    let _ = (problem, variant, options, watch);
    todo!()
}

/// Fits several variants; what one finds helps those that contain it, so this is quicker than one by one.
///
/// `watch` also gets the position of the variant under way. Stopped, the outcomes so far are returned, the one
/// under way as the last of them.
pub fn fit_all(
    problem: &Problem,
    variants: &[Variant],
    options: &Options,
    watch: &mut dyn FnMut(usize, &Progress) -> ControlFlow<()>,
) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    for (position, variant) in variants.iter().enumerate() {
        let outcome = fit(problem, *variant, options, &mut |progress| {
            watch(position, progress)
        });
        let stopped = outcome.ended == Ended::Cancelled;
        outcomes.push(outcome);
        if stopped {
            break;
        }
    }
    outcomes
}
