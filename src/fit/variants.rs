//! Fits of one variant or several: variants that one contains are fitted with it, once.

use super::multistart::StartGrid;
use super::options::{FitOptions, Variant};
use super::outcome::{EndReason, FitProgress, Outcome, Watch};
use super::problem::Problem;
use super::staged_fit::StagedFit;
use crate::brdf::Contained;
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

/// Variants that this one contains, with the equivalent options for them.
fn contained_variants(variant: Variant, options: &FitOptions) -> Vec<(Variant, FitOptions)> {
    let with_options = |contained: &'static Contained| {
        let (outer, inner) = (variant.model, contained.model);
        // What sets the two apart must be free to take the value at which they are equal.
        let apart = outer.params[contained.factors.len()..].iter();
        let mut apart = apart.zip(contained.fixed);
        let may = apart.all(|(row, fixed)| {
            let (low, high) = options.bounds_of(row);
            !options.held.has(row.id) && (low..=high).contains(fixed)
        });
        let mut of_inner = options.clone();
        for ((factor, row), to) in contained.factors.iter().zip(outer.params).zip(inner.params) {
            for values in [&mut of_inner.held.shared, &mut of_inner.start.shared] {
                if let Some(value) = values.remove(&row.id) {
                    values.insert(to.id, value / factor);
                }
            }
            if let Some((low, high)) = of_inner.bounds.remove(&row.id) {
                of_inner.bounds.insert(to.id, (low / factor, high / factor));
            }
        }
        let fresnel = variant.fresnel;
        let variant = Variant {
            model: inner,
            fresnel,
        };
        may.then_some((variant, of_inner))
    };
    variant
        .model
        .contains
        .iter()
        .filter_map(with_options)
        .collect()
}
