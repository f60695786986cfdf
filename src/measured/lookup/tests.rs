use super::*;
use crate::geom::direction;
use crate::measured::Grid;
use std::f64::consts::FRAC_PI_2;

/// Table of a function of the bins; its double and triple in green and blue.
fn table(grid: Grid, f: impl Fn(usize, usize, usize) -> f64) -> Table {
    let cells = (0..grid.len())
        .map(|index| {
            let (h, d, phi) = grid.bins(index);
            let f_r = f(h, d, phi);
            [f_r as f32, 2.0 * f_r as f32, 3.0 * f_r as f32]
        })
        .collect();
    Table::new(grid, cells)
}

/// Angles at given bin coordinates.
fn angles(h: f64, d: f64, phi: f64) -> HalfDiff {
    HalfDiff {
        theta_h: (h / 90.0).powi(2) * FRAC_PI_2,
        theta_d: d.to_radians(),
        phi_d: phi.to_radians(),
    }
}

/// Largest distance of the smooth lookup from a function that is linear in the bins, with an error planted in it.
fn worst_distance_from_linear(planted: f64) -> f64 {
    let linear = |h: f64, d: f64, phi: f64| 1.0 + 0.25 * h + 0.5 * d + (0.125 + planted) * phi;
    let table = table(Grid::FULL, |h, d, phi| {
        let phi = phi as f64 + 0.5;
        1.0 + 0.25 * (h as f64 + 0.5) + 0.5 * (d as f64 + 0.5) + 0.125 * phi
    });
    let mut worst: f64 = 0.0;
    for k in 0..2000 {
        let t = |step: f64| (f64::from(k) * step).fract();
        let (h, d) = (0.5 + 89.0 * t(0.618_034), 0.5 + 89.0 * t(0.754_878));
        let phi = 0.5 + 359.0 * t(0.569_84);
        let f_r = table
            .lookup_angles(angles(h, d, phi), Lookup::Smooth)
            .expect("all valid");
        worst = worst.max((f_r[0] - linear(h, d, phi)).abs());
        worst = worst.max((f_r[2] - 3.0 * linear(h, d, phi)).abs() / 3.0);
    }
    worst
}

#[test]
fn linear_functions_are_reproduced() {
    let worst = worst_distance_from_linear(0.0);
    assert!(worst < 1e-5, "{worst}");
}

#[test]
fn a_wrong_slope_is_caught() {
    assert!(worst_distance_from_linear(1e-6) > 1e-4);
}

#[test]
fn both_give_the_cell_at_its_centre() {
    for grid in [Grid::FOLDED, Grid::FULL] {
        let table = table(grid, |h, d, phi| (h * 7 + d * 31 + phi * 13) as f64 % 97.0);
        for index in (0..grid.len()).step_by(101) {
            let (h, d, phi) = grid.bins(index);
            let center = grid.center(h, d, phi);
            let cell = table.cell(index).expect("valid");
            assert_eq!(table.lookup_angles(center, Lookup::Nearest), Some(cell));
            let smooth = table.lookup_angles(center, Lookup::Smooth).expect("valid");
            assert!((smooth[1] - cell[1]).abs() < 1e-9, "{index}");
        }
    }
}

#[test]
fn both_are_constant_past_the_last_centres_of_theta() {
    let table = table(Grid::FOLDED, |h, d, _| (h + 2 * d) as f64);
    for lookup in LOOKUPS {
        for (h, d, expected) in [
            (0.0, 0.0, 0.0),
            (0.3, 0.2, 0.0),
            (90.0, 90.0, 89.0 * 3.0),
            (89.7, 89.9, 89.0 * 3.0),
        ] {
            let f_r = table.lookup_angles(angles(h, d, 20.5), lookup);
            assert!((f_r.expect("valid")[0] - expected).abs() < 1e-9);
        }
    }
}

#[test]
fn phi_wraps_around_the_grid() {
    for (grid, last) in [(Grid::FOLDED, 179), (Grid::FULL, 359)] {
        let table = table(grid, |_, _, phi| {
            if phi == 0 {
                1.0
            } else if phi == last {
                3.0
            } else {
                100.0
            }
        });
        // Halfway between the centres of the last bin and the first, and a quarter to either side.
        for (phi, expected) in [(0.0, 2.0), (0.25, 1.5), (-0.25, 2.5), (180.0, 2.0)] {
            let f_r = table.lookup_angles(angles(40.0, 40.0, phi), Lookup::Smooth);
            let expected = if phi == 180.0 && grid == Grid::FULL {
                100.0
            } else {
                expected
            };
            assert!((f_r.expect("valid")[0] - expected).abs() < 1e-9, "{phi}");
        }
    }
}

#[test]
fn invalid_neighbors_do_not_leak_and_gaps_are_the_same() {
    let hole = |h: usize, d: usize, phi: usize| (h * 5 + d * 3 + phi).is_multiple_of(4);
    let table = table(
        Grid::FOLDED,
        |h, d, phi| if hole(h, d, phi) { -1.0 } else { 2.0 },
    );
    let mut gaps = 0;
    for k in 0..5000 {
        let t = |step: f64| (f64::from(k) * step).fract();
        let at = angles(
            90.0 * t(0.618_034),
            90.0 * t(0.754_878),
            360.0 * t(0.569_84),
        );
        let [nearest, smooth] = LOOKUPS.map(|lookup| table.lookup_angles(at, lookup));
        assert_eq!(nearest.is_none(), smooth.is_none());
        match smooth {
            Some(f_r) => assert!((f_r[0] - 2.0).abs() < 1e-12, "{f_r:?}"),
            None => gaps += 1,
        }
    }
    assert!((1000..1500).contains(&gaps), "{gaps}");
}

#[test]
fn directions_without_a_value_have_none() {
    let table = table(Grid::FOLDED, |_, _, _| 1.0);
    let up = direction(0.5, 0.0);
    for lookup in LOOKUPS {
        assert_eq!(table.lookup(up, DVec3::X, lookup), Some([1.0, 2.0, 3.0]));
        assert_eq!(table.lookup(up, direction(1.6, 1.0), lookup), None);
        assert_eq!(table.lookup(direction(1.6, 1.0), up, lookup), None);
        // At the horizon the mirror direction is a limit, not an exception.
        assert_eq!(
            table.lookup(DVec3::X, -DVec3::X, lookup),
            Some([1.0, 2.0, 3.0])
        );
        assert_eq!(Lookup::by_key(lookup.key()), Some(lookup));
    }
    assert_eq!(Lookup::by_key("cubic"), None);
}

#[test]
fn folded_tables_are_reciprocal() {
    let table = table(Grid::FOLDED, |h, d, phi| (h * 3 + d * 5 + phi) as f64);
    let (a, b) = (direction(0.4, 0.3), direction(1.1, 2.0));
    for lookup in LOOKUPS {
        let (there, back) = (table.lookup(a, b, lookup), table.lookup(b, a, lookup));
        let (there, back) = (there.expect("valid"), back.expect("valid"));
        assert!((there[0] - back[0]).abs() < 1e-9);
    }
}
