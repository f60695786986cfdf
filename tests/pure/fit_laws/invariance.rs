//! What must not change the result, and what must not be changed by the fit.

use super::making::{
    bounds, distance, fit, map, numbers, problem, sample, thinned, variant, watched,
};
use grazing::brdf::PHONG_FAMILY;
use grazing::brdf::{Brdf, Fresnel, ParamId};
use grazing::fit::{
    self, Concern, EndReason, FitOptions, Outcome, Partial, Stage, StageSet, Variant,
};
use grazing::measured::{Grid, Table};
use std::ops::ControlFlow;

fn combined() -> Variant {
    variant("combined", Fresnel::Exact)
}

fn with_threads(count: usize, table: &Table) -> Outcome {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(count)
        .build()
        .expect("a pool");
    pool.install(|| fit(&problem(table), combined(), &FitOptions::default()))
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let table = thinned(sample("hammered-gold"), 4);
    let [one, two, five] = [1, 2, 5].map(|count| with_threads(count, &table));
    // Bit for bit: `==` on all numbers.
    assert_eq!(one, two);
    assert_eq!(one, five);
    let mut planted = one.clone();
    planted.brdf.params.lobe[0] = planted.brdf.params.lobe[0].next_up();
    assert_ne!(one, planted);
}

fn scaled(table: &Table, factor: f32) -> Table {
    map(table, |_, f_r| Some(f_r.map(|x| x * factor)))
}

fn with_amplitudes_times(brdf: &Brdf, factor: f64) -> Brdf {
    let mut brdf = *brdf;
    brdf.params.rho_d = brdf.params.rho_d.map(|x| x * factor);
    brdf.params.k_s = brdf.params.k_s.map(|x| x * factor);
    brdf
}

#[test]
fn brighter_data_give_a_brighter_model_of_the_same_shape() {
    let table = thinned(sample("hammered-gold"), 8);
    let of = |table: &Table| fit(&problem(table), combined(), &FitOptions::default());
    let plain = of(&table);
    for factor in [4.0, 0.0625] {
        let scaled = of(&scaled(&table, factor));
        assert_eq!(
            scaled.brdf,
            with_amplitudes_times(&plain.brdf, factor.into())
        );
        assert_eq!(scaled.errors, plain.errors);
    }
    // Other factors round the data anew: the descent takes another way and ends elsewhere on the same flat ground.
    let table = thinned(sample("green-lacquer"), 8);
    let plain = of(&table);
    let factor = 3.0;
    let scaled = of(&scaled(&table, factor));
    let wanted = with_amplitudes_times(&plain.brdf, factor.into());
    let off = distance(&scaled.brdf, &wanted);
    assert!(off < 3e-2, "off by {off}: {scaled:?} {plain:?}");
    assert!((scaled.errors.total / plain.errors.total - 1.0).abs() < 1e-4);
    // Planted: the amplitudes left as they were.
    assert!(distance(&plain.brdf, &wanted) > 5e-3);
}

#[test]
fn the_whole_turn_gives_the_same_fit_as_half_of_it() {
    let half = thinned(sample("copper-glaze"), 4);
    let (folded, full) = (Grid::FOLDED, Grid::FULL);
    let cells = (0..full.len()).map(|index| {
        let (h, d, phi) = full.bins(index);
        half.cells()[folded.index(h, d, phi % 180)]
    });
    let whole = Table::new(full, cells.collect());
    assert_eq!(whole.valid_count(), 2 * half.valid_count());
    let of = |table: &Table| fit(&problem(table), combined(), &FitOptions::default());
    let (one, other) = (of(&half), of(&whole));
    let ratio = other.errors.total / one.errors.total;
    // Sums are rounded in another order, and a descent ends where a step promises less than 1e-5.
    assert!((ratio - 1.0).abs() < 3e-5, "{ratio}");
    let off = distance(&other.brdf, &one.brdf);
    assert!(off < 0.01, "off by {off}: {one:?} {other:?}");
    // Planted: another material.
    let planted = of(&thinned(sample("hammered-gold"), 8));
    assert!(distance(&planted.brdf, &one.brdf) > 0.01);
}

#[test]
fn held_parameters_stay() {
    let problem = problem(&thinned(sample("copper-glaze"), 8));
    let free = fit(&problem, combined(), &FitOptions::default());
    for held in [
        Partial {
            shared: numbers(&[("s", 33.0), ("eta", 1.7)]),
            ..Partial::default()
        },
        Partial {
            shared: numbers(&[("alpha", 0.125)]),
            k_s: Some([1.0, 2.0, 3.0]),
            ..Partial::default()
        },
        Partial {
            rho_d: Some([0.1, 0.0, 0.3]),
            ..Partial::default()
        },
        Partial {
            shared: numbers(&[("s", 20.0), ("alpha", 0.5), ("eta", 1.5)]),
            rho_d: Some([0.1, 0.2, 0.3]),
            k_s: Some([1.0, 2.0, 3.0]),
        },
    ] {
        let options = FitOptions {
            held: held.clone(),
            ..FitOptions::default()
        };
        let (outcome, said) = watched(&problem, combined(), &options);
        let keeps = |brdf: &Brdf| held.over(*brdf) == *brdf;
        assert!(keeps(&outcome.brdf), "{held:?} {outcome:?}");
        for report in &outcome.stages {
            assert!(keeps(&report.start) && keeps(&report.end), "{report:?}");
            assert!(report.error <= report.start_error * (1.0 + 1e-6));
        }
        assert!(said.iter().all(|progress| keeps(&progress.brdf)));
        // Holding costs, and not holding is what it says.
        assert!(outcome.errors.total >= free.errors.total * (1.0 - 1e-4));
        assert!(!keeps(&free.brdf));
    }
}

#[test]
fn bounds_are_kept_and_named_where_they_stop_the_fit() {
    let problem = problem(&thinned(sample("copper-glaze"), 8));
    let free = fit(&problem, combined(), &FitOptions::default());
    // Every bound cuts off where the free fit went.
    let p = free.brdf.params;
    let set = [
        (ParamId::RHO_D, (0.0, 0.5 * p.rho_d[0])),
        (ParamId("s"), (1.5 * p.lobe[0], 3.0 * p.lobe[0])),
        (ParamId::ETA, (p.eta + 0.3, p.eta + 0.5)),
    ];
    let options = FitOptions {
        bounds: bounds(&set),
        ..FitOptions::default()
    };
    let keeps = |brdf: &Brdf| {
        set.iter().all(|(id, (low, high))| {
            let inside = |x: &f64| (*low..=*high).contains(x);
            brdf.get(*id).iter().all(inside)
        })
    };
    let (outcome, said) = watched(&problem, combined(), &options);
    assert!(keeps(&outcome.brdf), "{outcome:?}");
    for report in &outcome.stages {
        assert!(keeps(&report.end), "{report:?}");
    }
    assert!(said.iter().all(|progress| keeps(&progress.brdf)));
    assert!(!keeps(&free.brdf));
    let stopped: Vec<ParamId> = outcome
        .concerns
        .iter()
        .filter_map(|concern| match concern {
            Concern::AtBound(id, _) => Some(*id),
            _ => None,
        })
        .collect();
    assert!(stopped.contains(&ParamId::RHO_D), "{outcome:?}");
    assert!(
        stopped.contains(&ParamId("s")) || stopped.contains(&ParamId::ETA),
        "{outcome:?}"
    );
    assert!(outcome.errors.total > free.errors.total);
}

#[test]
fn a_cancelled_fit_keeps_the_best_so_far() {
    let problem = problem(&thinned(sample("copper-glaze"), 4));
    let whole = fit(&problem, combined(), &FitOptions::default());
    for calls in [1, 2, 7] {
        let mut said = Vec::new();
        let outcome = fit::fit(
            &problem,
            combined(),
            &FitOptions::default(),
            &mut |progress| {
                said.push(*progress);
                if said.len() == calls {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            },
        );
        assert_eq!(outcome.ended, EndReason::Cancelled);
        assert_eq!(said.len(), calls, "watched after it was stopped");
        assert_eq!(problem.errors(&outcome.brdf), outcome.errors);
        let best = said
            .iter()
            .map(|progress| problem.errors(&progress.brdf).total)
            .fold(f64::INFINITY, f64::min);
        // What looked best on a part of the cells may be a little worse on all.
        assert!(
            outcome.errors.total <= best * 1.001,
            "{outcome:?} after {said:?}"
        );
        // Not the whole fit after all.
        assert!(outcome.evaluations < whole.evaluations);
    }
    assert_eq!(whole.ended, EndReason::Converged);
}

#[test]
fn every_shape_that_is_tried_is_a_chance_to_stop() {
    let problem = problem(&thinned(sample("copper-glaze"), 8));
    let phong = variant("phong", Fresnel::Exact);
    let options = FitOptions {
        stages: StageSet::from_iter([Stage::Joint]),
        ..FitOptions::default()
    };
    let (whole, said) = watched(&problem, phong, &options);
    let chances = |said: &[usize]| said.windows(2).all(|pair| pair[1] <= pair[0] + 1);
    let tried: Vec<usize> = said.iter().map(|progress| progress.evaluations).collect();
    assert!(chances(&tried), "{tried:?}");
    assert_eq!(tried.last(), Some(&whole.evaluations));
    // Planted: a descent of which only the end is heard.
    assert!(!chances(&[tried[0], tried[tried.len() - 1]]));
    for calls in [tried.len() / 4, tried.len() / 2, tried.len() - 2] {
        let mut count = 0;
        let outcome = fit::fit(&problem, phong, &options, &mut |_| {
            count += 1;
            if count == calls {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        assert_eq!((outcome.ended, count), (EndReason::Cancelled, calls));
        assert_eq!(problem.errors(&outcome.brdf), outcome.errors);
    }
}

#[test]
fn cancelling_several_returns_those_so_far() {
    let problem = problem(&thinned(sample("copper-glaze"), 8));
    let variants = Variant::of(PHONG_FAMILY, Fresnel::Exact);
    let mut positions = Vec::new();
    let outcomes = fit::fit_all(&problem, &variants, &FitOptions::default(), &mut |at, _| {
        positions.push(at);
        if at == 1 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    positions.dedup();
    assert_eq!(positions, [0, 1]);
    assert_eq!(outcomes.len(), 2);
    assert_eq!(outcomes[0].ended, EndReason::Converged);
    assert_eq!(outcomes[1].ended, EndReason::Cancelled);
    for (outcome, variant) in outcomes.iter().zip(variants) {
        assert_eq!(Variant::from(&outcome.brdf), variant);
    }
}
