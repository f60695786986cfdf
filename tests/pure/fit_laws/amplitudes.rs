//! Stage 1 is optimal: nothing near is better, and nothing far on small problems.

use super::making::{bell, brdf, chance, problem, sample, table};
use super::reference::{self, Counted};
use grazing::brdf::{Brdf, Fresnel, ParamId};
use grazing::fit::Weight;
use grazing::fit::options::NO_LIMIT;
use grazing::measured::{Grid, Table};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// By how much, relatively, E can be lowered by a small change of one amplitude.
fn gain_nearby(cells: &[Counted], best: &Brdf) -> f64 {
    let before = reference::errors(cells, best).total;
    let mut gain: f64 = 0.0;
    for id in [ParamId::RHO_D, ParamId::K_S] {
        for channel in 0..3 {
            let value = best.get(id)[channel];
            let steps = [-1e-3, -1e-5, 1e-5, 1e-3].map(|step| value * (1.0 + step));
            // A zero must have its reason too.
            for changed in steps.into_iter().chain([0.0, value + 1e-4]) {
                let mut other = *best;
                other.get_mut(id)[channel] = changed;
                gain = gain.max(1.0 - reference::errors(cells, &other).total / before);
            }
        }
    }
    gain
}

#[test]
fn no_change_of_an_amplitude_lowers_the_error() {
    for (key, b) in [
        (
            "copper-glaze",
            brdf("combined", Fresnel::Exact, 30.0, 0.5, 1.5),
        ),
        (
            "blue-porcelain",
            brdf("blinn-phong", Fresnel::None, 2000.0, 0.0, 1.5),
        ),
        (
            "violet-felt",
            brdf("phong", Fresnel::Schlick, 0.5, 0.0, 1.1),
        ),
        // A lobe that the data do not have, so that an amplitude is 0.
        (
            "green-lacquer",
            brdf("combined", Fresnel::None, 1e5, 0.9, 1.5),
        ),
    ] {
        let thin = super::making::thinned(sample(key), 6);
        let best = problem(&thin).with_best_amplitudes(&b);
        assert_eq!((best.model, best.fresnel), (b.model, b.fresnel));
        assert_eq!(
            (best.params.lobe[0], best.params.lobe[1], best.params.eta),
            (b.params.lobe[0], b.params.lobe[1], b.params.eta)
        );
        let cells = reference::counted(&thin, &b, Weight::Cosine, NO_LIMIT);
        let gain = gain_nearby(&cells, &best);
        assert!(gain < 1e-8, "{key}: {best:?} can gain {gain:e}");
        // Planted: half a percent off in one channel.
        let mut planted = best;
        planted.params.rho_d[1] = planted.params.rho_d[1] * 1.005 + 1e-4;
        assert!(gain_nearby(&cells, &planted) > 1e-8, "{key}");
    }
}

/// The smallest Σ w |a + b x − f| over a, b ≥ 0 of one channel: some optimum goes through two of the points, or
/// through one with a or b at 0.
fn brute_force(cells: &[Counted], channel: usize) -> f64 {
    let cost = |a: f64, b: f64| {
        let one = |cell: &Counted| cell.weight * (a + b * cell.shape - cell.f_r[channel]).abs();
        cells.iter().map(one).sum::<f64>()
    };
    let mut best = cost(0.0, 0.0);
    for (k, p) in cells.iter().enumerate() {
        let f = p.f_r[channel];
        best = best.min(cost(f, 0.0));
        if p.shape > 0.0 {
            best = best.min(cost(0.0, f / p.shape));
        }
        for q in &cells[..k] {
            let b = (f - q.f_r[channel]) / (p.shape - q.shape);
            let a = f - b * p.shape;
            if a >= 0.0 && b >= 0.0 && b.is_finite() {
                best = best.min(cost(a, b));
            }
        }
    }
    best
}

/// A few dozen cells: a highlight with much noise, some zeros, some equal.
fn small_table(seed: u64, b: &Brdf) -> Table {
    let grid = Grid::FOLDED;
    let chosen: BTreeSet<usize> = (0..40)
        .map(|k| {
            let bin = |axis: u64, bins: f64| (chance(seed * 1000 + 3 * k + axis) * bins) as usize;
            grid.index(bin(0, 60.0), bin(1, 80.0), bin(2, 180.0))
        })
        .collect();
    table(grid, |index, c| {
        if !chosen.contains(&index) {
            return None;
        }
        let place = seed * 77 + index as u64;
        let noise = |k: u64| (1.0 + 0.6 * bell(3 * place + k)).max(0.0);
        let f_r = b.eval(c);
        Some(match (chance(place) * 8.0) as usize {
            0 => [0.0; 3],
            1 => [0.25; 3],
            _ => std::array::from_fn(|k| f_r[k] * noise(k as u64)),
        })
    })
}

#[test]
fn on_small_problems_stage_1_is_the_best_of_all() {
    let mut at_zero = [0; 2];
    for seed in 0..24 {
        let s = 10_f64.powf(3.0 * chance(seed) - 0.7);
        let truth = brdf("combined", Fresnel::Exact, s, 0.5, 1.5);
        let small = small_table(seed, &truth);
        // Now and then a lobe that does not fit at all.
        let mut b = truth;
        if seed % 3 == 0 {
            b.params.lobe[0] = 1e4 / s;
            b.fresnel = Fresnel::None;
        }
        let found = problem(&small).with_best_amplitudes(&b);
        let cells = reference::counted(&small, &b, Weight::Cosine, NO_LIMIT);
        let errors = reference::errors(&cells, &found);
        for channel in 0..3 {
            let sum: f64 = cells.iter().map(|c| c.weight * c.f_r[channel]).sum();
            let wanted = brute_force(&cells, channel) / sum;
            let ratio = errors.channels[channel] / wanted;
            assert!(
                (1.0 - 1e-9..1.0 + 1e-5).contains(&ratio),
                "seed {seed}, channel {channel}: {found:?} has {ratio} times the best"
            );
            // Planted: 2 % more light.
            let mut planted = found;
            planted.params.rho_d[channel] = planted.params.rho_d[channel] * 1.02 + 1e-3 * PI;
            let planted = reference::errors(&cells, &planted).channels[channel] / wanted;
            assert!(planted > 1.0 + 1e-5, "seed {seed}: {planted}");
            at_zero[0] += usize::from(found.params.rho_d[channel] == 0.0);
            at_zero[1] += usize::from(found.params.k_s[channel] == 0.0);
        }
    }
    // The cases are what they are meant to be.
    assert!(at_zero[0] > 0 && at_zero[1] > 0, "{at_zero:?}");
}
