//! Fitting the models to a table by L1, as the poster does it [Nielsen14] and then all parameters together. Pure.
//!
//! ```text
//! Table ── Problem::new(weight, limit) ──▶ Problem        what is measured, arranged for passes over all cells
//! Problem + Variant + Options ── fit ──▶ Outcome          parameters, errors, stages; watched and stopped by a closure
//! ```
//!
//! Work is spread over the threads of the current rayon pool; results do not depend on their number.

mod cells;
pub mod concerns;
mod contained;
mod descent;
mod engine;
pub mod error_map;
pub mod landscape;
mod lanes;
mod objective;
pub mod options;
pub mod outcome;
mod passes;
pub mod problem;
mod regression;
mod shape;
mod sites;
pub mod start;
mod starts;
mod units;
mod vertex;

pub use options::{Options, Partial, STAGES, Stage, Variant, WEIGHTS, Weight};
pub use outcome::{Concern, Ended, Errors, Outcome, Progress, StageReport};
pub use problem::{Problem, ProblemError};

use engine::Engine;
use starts::Grid;
use std::ops::ControlFlow;

/// Called with the best so far, at least every few hundredths of a second and once a stage; may stop the fit. Calls
/// come one at a time, but from any thread of the pool.
pub type Watch<'a> = &'a mut (dyn FnMut(&Progress) -> ControlFlow<()> + Send);

/// Fits one variant.
///
/// Stopped by `watch`, the outcome is the best so far. A variant that contains others (the combined model at α = 0
/// and 1) is never worse than these, fitted likewise.
pub fn fit(problem: &Problem, variant: Variant, options: &Options, watch: Watch) -> Outcome {
    fit_knowing(problem, variant, options, &[], &mut Grid::default(), watch)
}

/// Fits several variants; what one finds helps those that contain it, so this is quicker than one by one.
///
/// `watch` also gets the position of the variant under way. Stopped, the outcomes so far are returned, the one
/// under way as the last of them.
pub fn fit_all(
    problem: &Problem,
    variants: &[Variant],
    options: &Options,
    watch: &mut (dyn FnMut(usize, &Progress) -> ControlFlow<()> + Send),
) -> Vec<Outcome> {
    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut grid = Grid::default();
    for (position, variant) in variants.iter().enumerate() {
        let mut watch = |progress: &Progress| watch(position, progress);
        let outcome = fit_knowing(problem, *variant, options, &outcomes, &mut grid, &mut watch);
        let stopped = outcome.ended == Ended::Cancelled;
        outcomes.push(outcome);
        if stopped {
            break;
        }
    }
    outcomes
}

/// Fits a variant with what is known of others under the same options.
fn fit_knowing(
    problem: &Problem,
    variant: Variant,
    options: &Options,
    known: &[Outcome],
    grid: &mut Grid,
    watch: Watch,
) -> Outcome {
    let contained = contained::variants(variant, options);
    Engine::new(problem, variant, options, grid, watch).run(&mut |grid, go_on| {
        let mut found = Vec::new();
        for (inner, inner_options) in &contained {
            let same = |outcome: &&Outcome| Variant::from(&outcome.brdf) == *inner;
            let of = |outcome: &Outcome| (outcome.brdf, outcome.errors);
            found.push(match known.iter().find(same) {
                Some(outcome) if inner_options == options => of(outcome),
                _ => of(
                    &Engine::new(problem, *inner, inner_options, grid, &mut |_| go_on())
                        .run(&mut |_, _| Vec::new()),
                ),
            });
            if go_on().is_break() {
                break;
            }
        }
        found
    })
}

#[cfg(test)]
mod tests;
