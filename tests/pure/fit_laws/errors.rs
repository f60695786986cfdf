//! E is what the design says: against a plain loop in f64.

use super::making::{brdf, problem, sample, table_of};
use super::reference;
use grazing::brdf::{Brdf, Fresnel};
use grazing::fit::options::NO_LIMIT;
use grazing::fit::{Errors, Problem, ProblemError, WEIGHTS, Weight};
use grazing::measured::{Grid, Table};

/// Largest relative distance of all numbers; infinite where one has a number and the other none.
fn distance(found: &Errors, wanted: &Errors) -> f64 {
    let mut pairs = vec![(found.total, wanted.total)];
    pairs.extend(found.channels.into_iter().zip(wanted.channels));
    pairs.push((
        found.grazing.unwrap_or(f64::NAN),
        wanted.grazing.unwrap_or(f64::NAN),
    ));
    let relative = |(found, wanted): (f64, f64)| match (found.is_nan(), wanted.is_nan()) {
        (true, true) => 0.0,
        (false, false) => (found / wanted - 1.0).abs(),
        _ => f64::INFINITY,
    };
    pairs.into_iter().map(relative).fold(0.0, f64::max)
}

fn both(table: &Table, b: &Brdf, weight: Weight, limit: f64) -> (Errors, Errors) {
    let found = Problem::new(table, weight, limit)
        .expect("something to fit")
        .errors(b);
    let cells = reference::counted(table, b, weight, limit);
    (found, reference::errors(&cells, b))
}

#[test]
fn errors_are_those_of_a_plain_loop() {
    let table = sample("copper-glaze");
    for (weight, limit, b) in [
        (
            Weight::Cosine,
            NO_LIMIT,
            brdf("combined", Fresnel::Exact, 40.0, 0.4, 1.5),
        ),
        (
            Weight::Cosine,
            80_f64.to_radians(),
            brdf("phong", Fresnel::None, 7.0, 0.0, 1.5),
        ),
        (
            Weight::SolidAngle,
            NO_LIMIT,
            brdf("blinn-phong", Fresnel::Schlick, 900.0, 0.0, 1.3),
        ),
        (
            Weight::SolidAngle,
            80_f64.to_radians(),
            brdf("combined", Fresnel::None, 0.3, 0.9, 1.5),
        ),
        (
            Weight::Cells,
            NO_LIMIT,
            brdf("combined", Fresnel::Schlick, 3000.0, 0.1, 2.5),
        ),
        (
            Weight::Cells,
            80_f64.to_radians(),
            brdf("phong", Fresnel::Exact, 5e4, 0.0, 1.01),
        ),
    ] {
        let (found, wanted) = both(table, &b, weight, limit);
        assert!(
            distance(&found, &wanted) < 1e-6,
            "{weight:?} {limit} {b:?}: {found:?}, not {wanted:?}"
        );
        // Planted: the other weights, another limit, a slightly different model.
        for other in WEIGHTS.into_iter().filter(|other| *other != weight) {
            assert!(distance(&found, &both(table, &b, other, limit).1) > 1e-3);
        }
        let other = both(table, &b, weight, limit - 2_f64.to_radians()).1;
        assert!(distance(&found, &other) > 1e-5);
        let mut other = b;
        other.params.rho_d[2] *= 1.001;
        other.params.k_s[2] *= 1.001;
        let cells = reference::counted(table, &b, weight, limit);
        assert!(distance(&found, &reference::errors(&cells, &other)) > 1e-6);
    }
}

#[test]
fn the_whole_turn_counts_like_half_of_it() {
    let b = brdf("combined", Fresnel::Exact, 25.0, 0.7, 1.6);
    // Not the same in both halves, so that a half left out is seen.
    let full = super::making::table(Grid::FULL, |index, c| {
        let factor = 1.0 + 0.3 * super::making::bell(index as u64);
        Some(b.eval(c).map(|x| x * factor.max(0.0)))
    });
    let (found, wanted) = both(&full, &b, Weight::Cosine, NO_LIMIT);
    assert!(distance(&found, &wanted) < 1e-6, "{found:?} {wanted:?}");
    let half = super::making::map(&full, |index, f_r| {
        (Grid::FULL.bins(index).2 < 180).then_some(f_r)
    });
    let (_, planted) = both(&half, &b, Weight::Cosine, NO_LIMIT);
    assert!(distance(&found, &planted) > 1e-6);
}

#[test]
fn a_perfect_model_has_no_error() {
    let b = brdf("combined", Fresnel::Exact, 120.0, 0.5, 1.5);
    let problem = problem(&table_of(&b, 4));
    assert!(problem.errors(&b).total < 1e-5, "{:?}", problem.errors(&b));
    let mut planted = b;
    planted.params.lobe[0] *= 1.001;
    assert!(problem.errors(&planted).total > 1e-5);
}

#[test]
fn nothing_grazing_within_the_limit_has_no_grazing_error() {
    let b = brdf("phong", Fresnel::None, 12.0, 0.0, 1.5);
    let table = sample("copper-glaze");
    let (found, wanted) = both(table, &b, Weight::Cosine, 60_f64.to_radians());
    assert_eq!(found.grazing, None);
    assert!(distance(&found, &wanted) < 1e-6, "{found:?} {wanted:?}");
    assert!(
        both(table, &b, Weight::Cosine, 75_f64.to_radians())
            .0
            .grazing
            .is_some()
    );
}

#[test]
fn without_data_there_is_no_problem() {
    let of = |table: &Table, limit: f64| Problem::new(table, Weight::Cosine, limit).err();
    let grid = Grid::FOLDED;
    let invalid = Table::new(grid, vec![[-1.0; 3]; grid.len()]);
    assert_eq!(of(&invalid, NO_LIMIT), Some(ProblemError::NoCells));
    let black = Table::new(grid, vec![[0.0; 3]; grid.len()]);
    assert_eq!(of(&black, NO_LIMIT), Some(ProblemError::Black));
    let below = (0..grid.len()).map(|index| {
        let (h, d, phi) = grid.bins(index);
        let above = grid.center(h, d, phi).cosines().above_horizon();
        if above { [-1.0; 3] } else { [1.0; 3] }
    });
    let below = Table::new(grid, below.collect());
    assert_eq!(of(&below, NO_LIMIT), Some(ProblemError::NoCells));
    let gray = Table::new(grid, vec![[0.1; 3]; grid.len()]);
    assert_eq!(of(&gray, 1e-4), Some(ProblemError::NoCells));
    assert_eq!(of(&gray, NO_LIMIT), None);
}
