//! Fits of one variant or several: variants that one contains are fitted with it, once.

use super::multistart::StartGrid;
use super::options::{FitOptions, Variant};
use super::outcome::{EndReason, FitProgress, Outcome, Watch};
use super::problem::Problem;
use super::staged_fit::StagedFit;
use crate::brdf::{MODELS, ParamId};
use std::ops::ControlFlow;

/// Fits a variant.
///
/// Where `watch` stops it, the outcome is the best model so far. A variant that contains others (the combined model at
/// α = 0 and 1) is never worse than these, fitted under the same options.
pub fn fit(problem: &Problem, variant: Variant, options: &FitOptions, watch: Watch) -> Outcome {
    fit_knowing(
        problem,
        variant,
        options,
        &[],
        &mut StartGrid::default(),
        watch,
    )
}

/// Fits several variants; each outcome helps the variants that contain it, so this is quicker than one by one.
///
/// `watch` also gets the index of the variant under way. Where it stops, the outcomes so far are returned, the one
/// under way as the last of them.
pub fn fit_all(
    problem: &Problem,
    variants: &[Variant],
    options: &FitOptions,
    watch: &mut (dyn FnMut(usize, &FitProgress) -> ControlFlow<()> + Send),
) -> Vec<Outcome> {
    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut grid = StartGrid::default();
    for (position, variant) in variants.iter().enumerate() {
        let mut watch = |progress: &FitProgress| watch(position, progress);
        let outcome = fit_knowing(problem, *variant, options, &outcomes, &mut grid, &mut watch);
        let stopped = outcome.ended == EndReason::Cancelled;
        outcomes.push(outcome);
        if stopped {
            break;
        }
    }
    outcomes
}

/// Fits a variant, reusing outcomes of others under the same options.
fn fit_knowing(
    problem: &Problem,
    variant: Variant,
    options: &FitOptions,
    known: &[Outcome],
    grid: &mut StartGrid,
    watch: Watch,
) -> Outcome {
    let contained = contained_variants(variant, options);
    StagedFit::new(problem, variant, options, grid, watch).run(&mut |grid, go_on| {
        let mut found = Vec::new();
        for (inner, inner_options) in &contained {
            let same = |outcome: &&Outcome| Variant::from(&outcome.brdf) == *inner;
            let of = |outcome: &Outcome| (outcome.brdf, outcome.errors);
            found.push(match known.iter().find(same) {
                Some(outcome) if inner_options == options => of(outcome),
                _ => of(
                    &StagedFit::new(problem, *inner, inner_options, grid, &mut |_| go_on())
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

/// Variants that equal this one at some α, with the equivalent options for them.
fn contained_variants(variant: Variant, options: &FitOptions) -> Vec<(Variant, FitOptions)> {
    let Some(alpha) = variant.model.param(ParamId::Alpha) else {
        return Vec::new();
    };
    if options.held.alpha.is_some() {
        return Vec::new();
    }
    let (low, high) = options.bounds_of(alpha);
    let within = |alpha: f64| (low..=high).contains(&alpha);
    MODELS
        .into_iter()
        .filter(|model| model.alpha.is_some_and(within))
        .map(|model| {
            let ratio = model.exponent_ratio / variant.model.exponent_ratio;
            let mut inner = *options;
            inner.held.s = inner.held.s.map(|s| s * ratio);
            inner.start.s = inner.start.s.map(|s| s * ratio);
            let bounds = inner.bounds.s;
            inner.bounds.s = bounds.map(|(low, high)| (low * ratio, high * ratio));
            let fresnel = variant.fresnel;
            (Variant { model, fresnel }, inner)
        })
        .collect()
}
