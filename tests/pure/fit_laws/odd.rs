//! Odd data: no panic, and numbers that are numbers.

use super::making::{chance, fit, kept, problem, table, variant};
use grazing::brdf::Fresnel;
use grazing::fit::{FitOptions, Outcome};
use grazing::geom::{Cosines, Rgb};
use grazing::measured::{Grid, Table};

/// What is not sound about an outcome.
fn unsound(outcome: &Outcome, black: [bool; 3]) -> Vec<String> {
    let mut found = Vec::new();
    let brdf = &outcome.brdf;
    for row in brdf.used() {
        let (low, high) = row.bounds;
        let values = brdf.get(row.id);
        if !values.iter().all(|x| (low..=high).contains(x)) {
            found.push(format!("{} = {values:?}", row.key()));
        }
    }
    // All black is one of the choices, and has E = 1.
    if !(0.0..=1.0 + 1e-6).contains(&outcome.errors.total) {
        found.push(format!("{:?}", outcome.errors));
    }
    for (k, black) in black.into_iter().enumerate() {
        let error = outcome.errors.channels[k];
        if error.is_nan() != black || error < 0.0 || error.is_infinite() {
            found.push(format!("channel {k}: {error}"));
        }
    }
    if outcome
        .errors
        .grazing
        .is_some_and(|e| !(0.0..).contains(&e))
    {
        found.push(format!("grazing {:?}", outcome.errors.grazing));
    }
    for report in &outcome.stages {
        if !(0.0..=report.start_error * (1.0 + 1e-6)).contains(&report.error) {
            found.push(format!("{report:?}"));
        }
    }
    if !outcome
        .albedo
        .iter()
        .flatten()
        .all(|x| *x >= 0.0 && x.is_finite())
    {
        found.push(format!("albedo {:?}", outcome.albedo));
    }
    found
}

fn check(name: &str, table: &Table, black: [bool; 3]) {
    let problem = problem(table);
    for variant in [
        variant("phong", Fresnel::None),
        variant("combined", Fresnel::Exact),
    ] {
        let outcome = fit(&problem, variant, &FitOptions::default());
        let unsound = unsound(&outcome, black);
        assert!(unsound.is_empty(), "{name}: {unsound:?} {outcome:?}");
    }
}

/// One cell in forty, from a closure of the cosines and a number of the cell.
fn sparse(f_r: impl Fn(u64, &Cosines) -> Option<Rgb>) -> Table {
    table(Grid::FOLDED, |index, c| {
        kept(index, 40).then(|| f_r(index as u64, c)).flatten()
    })
}

fn highlight(c: &Cosines) -> f64 {
    0.1 + c.wh_n.pow(80.0)
}

const NONE_BLACK: [bool; 3] = [false; 3];

#[test]
fn hardly_any_cells() {
    let grid = Grid::FOLDED;
    for (name, chosen) in [
        ("one at the peak", vec![grid.index(0, 30, 20)]),
        ("one far from it", vec![grid.index(50, 20, 90)]),
        ("two", vec![grid.index(3, 30, 20), grid.index(40, 20, 90)]),
        ("a row", (0..180).map(|p| grid.index(10, 40, p)).collect()),
    ] {
        let few = table(grid, |index, c| {
            let f_r = highlight(c);
            chosen.contains(&index).then_some([f_r, 2.0 * f_r, 0.5])
        });
        check(name, &few, NONE_BLACK);
        // One value, or two, can always be met: E is 0.
        if chosen.len() == 1 {
            let outcome = fit(
                &problem(&few),
                variant("phong", Fresnel::None),
                &FitOptions::default(),
            );
            assert!(outcome.errors.total < 1e-5, "{name}: {outcome:?}");
        }
    }
}

#[test]
fn flat_and_black_channels() {
    check("constant", &sparse(|_, _| Some([0.1; 3])), NONE_BLACK);
    check(
        "one black channel",
        &sparse(|_, c| Some([highlight(c), 0.0, 1.0])),
        [false, true, false],
    );
    check(
        "black but for one cell",
        &table(Grid::FOLDED, |index, _| {
            Some([if index == 4321 { 1.0 } else { 0.0 }; 3])
        }),
        NONE_BLACK,
    );
    check(
        "dark at the peak",
        &sparse(|_, c| Some([1.0 - 0.9 * c.wh_n.pow(40.0); 3])),
        NONE_BLACK,
    );
}

#[test]
fn only_grazing_cells() {
    let low = 70_f64.to_radians().cos();
    let grazing = sparse(|_, c| {
        let lower = c.cos_theta_i.min(c.cos_theta_o);
        (lower < low).then(|| [highlight(c); 3])
    });
    check("only grazing", &grazing, NONE_BLACK);
    let steep = sparse(|_, c| {
        let lower = c.cos_theta_i.min(c.cos_theta_o);
        (lower > low).then(|| [highlight(c); 3])
    });
    check("nothing grazing", &steep, NONE_BLACK);
}

#[test]
fn huge_and_tiny_values() {
    check(
        "all huge",
        &sparse(|_, c| Some([1e30 * highlight(c); 3])),
        NONE_BLACK,
    );
    check(
        "all tiny",
        &sparse(|_, c| Some([1e-30 * highlight(c); 3])),
        NONE_BLACK,
    );
    check(
        "subnormal",
        &sparse(|_, c| Some([1e-41 * highlight(c); 3])),
        NONE_BLACK,
    );
    check(
        "the largest there is",
        &sparse(|_, _| Some([f32::MAX.into(); 3])),
        NONE_BLACK,
    );
    let spikes = |spike: f64| {
        sparse(move |index, c| {
            let f_r = if index % 1001 == 0 {
                spike
            } else {
                highlight(c)
            };
            Some([f_r; 3])
        })
    };
    check("a few huge", &spikes(1e30), NONE_BLACK);
    check(
        "a few infinite, so invalid",
        &spikes(f64::INFINITY),
        NONE_BLACK,
    );
    check(
        "from 1e-20 to 1e20",
        &sparse(|index, _| Some([10_f64.powf(40.0 * chance(index) - 20.0); 3])),
        NONE_BLACK,
    );
}

#[test]
fn a_planted_unsound_outcome_is_caught() {
    let sound = fit(
        &problem(&sparse(|_, c| Some([highlight(c); 3]))),
        variant("phong", Fresnel::None),
        &FitOptions::default(),
    );
    let caught = |change: &dyn Fn(&mut Outcome)| {
        let mut outcome = sound.clone();
        change(&mut outcome);
        !unsound(&outcome, NONE_BLACK).is_empty()
    };
    assert!(!caught(&|_| {}), "{sound:?}");
    assert!(caught(&|o| o.brdf.params.lobe[0] = f64::NAN));
    assert!(caught(&|o| o.brdf.params.k_s[1] = -1.0));
    assert!(caught(&|o| o.errors.total = 1.1));
    assert!(caught(&|o| o.errors.channels[2] = f64::NAN));
    assert!(caught(&|o| o.errors.grazing = Some(f64::NAN)));
    assert!(caught(&|o| o.stages[0].error = f64::INFINITY));
    assert!(caught(&|o| o.albedo[1][1] = f64::INFINITY));
}
