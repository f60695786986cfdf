//! Tables, models and fits for the tests.

pub use crate::common::tables::table;
use grazing::brdf::params::lobe_values;
use grazing::brdf::{BLINN_PHONG, Brdf, Fresnel, Model, ParamId, Params};
use grazing::fit::options::{Bounds, NO_LIMIT};
use grazing::fit::{self, FitOptions, FitProgress, Outcome, Problem, Variant, Weight};
use grazing::measured::{Grid, SAMPLES, SyntheticMaterial, Table};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::OnceLock;

/// A synthetic sample, made once.
pub fn sample(key: &str) -> &'static Table {
    static TABLES: [OnceLock<Table>; SAMPLES.len()] = [const { OnceLock::new() }; SAMPLES.len()];
    let position = SAMPLES.iter().position(|sample| sample.key == key);
    let position = position.expect("a sample of this name");
    TABLES[position].get_or_init(|| SyntheticMaterial::synthesize(&SAMPLES[position]))
}

pub fn variant(key: &str, fresnel: Fresnel) -> Variant {
    let model = Model::by_key(key).expect("a model");
    Variant { model, fresnel }
}

pub fn brdf(key: &str, fresnel: Fresnel, s: f64, alpha: f64, eta: f64) -> Brdf {
    variant(key, fresnel).with(Params {
        rho_d: [0.3, 0.2, 0.05],
        k_s: [30.0, 40.0, 35.0],
        lobe: lobe_values([s, alpha]),
        eta,
    })
}

/// The table of a model, with one cell in `thinning` valid.
pub fn table_of(brdf: &Brdf, thinning: u64) -> Table {
    table(Grid::FOLDED, |index, c| {
        kept(index, thinning).then(|| brdf.eval(c))
    })
}

/// A table with one cell in `thinning` of those that were valid.
pub fn thinned(from: &Table, thinning: u64) -> Table {
    map(from, |index, f_r| kept(index, thinning).then_some(f_r))
}

/// A table with its valid cells changed.
pub fn map(from: &Table, change: impl Fn(usize, [f32; 3]) -> Option<[f32; 3]>) -> Table {
    let cells = from.cells().iter().enumerate();
    let change = |(index, cell): (usize, &[f32; 3])| {
        let valid = !cell[0].is_nan();
        valid
            .then(|| change(index, *cell))
            .flatten()
            .unwrap_or([-1.0; 3])
    };
    Table::new(from.grid(), cells.map(change).collect())
}

/// One in `thinning`, an even number, at random: every other cell of some rows of φ_d, as fits are quick by row.
pub fn kept(index: usize, thinning: u64) -> bool {
    let row = (index / 180) as u64;
    hash(!row).is_multiple_of(thinning / 2) && hash(index as u64).is_multiple_of(2)
}

/// Chance by number: SplitMix64.
pub fn hash(place: u64) -> u64 {
    let mut x = place.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Even in [0, 1).
pub fn chance(place: u64) -> f64 {
    (hash(place) >> 11) as f64 / (1_u64 << 53) as f64
}

/// Nearly a standard normal, symmetric about 0.
pub fn bell(place: u64) -> f64 {
    let sum: f64 = (0..6).map(|k| chance(6 * place + k) - 0.5).sum();
    sum * 2.0_f64.sqrt()
}

pub fn problem(table: &Table) -> Problem {
    Problem::new(table, Weight::default(), NO_LIMIT).expect("something to fit")
}

/// A fit that nobody watches.
pub fn fit(problem: &Problem, variant: Variant, options: &FitOptions) -> Outcome {
    fit::fit(
        problem,
        variant,
        options,
        &mut |_| ControlFlow::Continue(()),
    )
}

/// A fit with all that it said.
pub fn watched(
    problem: &Problem,
    variant: Variant,
    options: &FitOptions,
) -> (Outcome, Vec<FitProgress>) {
    let mut said = Vec::new();
    let outcome = fit::fit(problem, variant, options, &mut |progress| {
        said.push(*progress);
        ControlFlow::Continue(())
    });
    (outcome, said)
}

/// Bounds by parameter.
pub fn bounds(of: &[(ParamId, Bounds)]) -> BTreeMap<ParamId, Bounds> {
    of.iter().copied().collect()
}

/// Values by the keys of their parameters.
pub fn numbers(of: &[(&'static str, f64)]) -> BTreeMap<ParamId, f64> {
    let of = of.iter();
    of.map(|(key, value)| (ParamId(key), *value)).collect()
}

/// Exponent of a model that gives the same highlight at normal incidence as Phong's 1.
pub fn exponent_ratio(model: &Model) -> f64 {
    if model == &BLINN_PHONG { 4.0 } else { 1.0 }
}

/// The largest relative distance of the parameters that count; of α, which may be 0, the distance itself.
pub fn distance(found: &Brdf, wanted: &Brdf) -> f64 {
    let rows = wanted.used();
    rows.flat_map(|row| {
        let pairs = found.get(row.id).iter().zip(wanted.get(row.id));
        pairs.map(move |(found, wanted)| match row.id {
            ParamId("alpha") => (found - wanted).abs(),
            _ => (found - wanted).abs() / wanted.abs().max(1e-12),
        })
    })
    .fold(0.0, f64::max)
}
