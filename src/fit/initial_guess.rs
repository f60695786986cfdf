//! Initial guess of the parameters from the data: the sliders' values when a material opens.

use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, COMBINED, Fresnel};
use crate::geom::{Cosines, Rgb};
use crate::measured::Table;
use crate::measured::grid::{THETA_D_BINS, THETA_H_BINS};
use std::f64::consts::PI;

/// Steps in bins of θ_d and φ_d between the cells that are sampled; θ_h, along which the highlight varies, is taken
/// whole.
const STRIDE: (usize, usize) = (5, 15);
/// Number of candidates for s, from 0.3 to 30,000, evenly in the logarithm.
const EXPONENTS: usize = 21;
const ALPHAS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
const ETAS: [f64; 3] = [1.2, 1.5, 2.5];

/// Sampled cell: its f_r and its weight, the solid angle times both cosines.
struct WeightedCell {
    cosines: Cosines,
    weight: f64,
    /// Weight divided by f_r, per channel.
    relative: Rgb,
    f_r: Rgb,
}

/// Combined model with exact Fresnel factor that fits best on a coarse grid of (s, α, η) and a few thousand cells.
///
/// For each candidate ρ_d and k_s are the least-squares solution with weights w/f, which stands in for L1 as both
/// measure an error in proportion to the value. It takes a fraction of a second and is no fit.
pub fn from_table(table: &Table) -> Brdf {
    let samples = samples(table);
    let mut best = Brdf::new(&COMBINED, Fresnel::Exact);
    let mut best_error = f64::INFINITY;
    // A shape is R_F · exp(s · ln base): of its parts each is made once.
    let reflectance = |eta: f64| {
        let of = |sample: &WeightedCell| best.fresnel.reflectance(sample.cosines.wi_wh.cos, eta);
        samples.iter().map(of).collect::<Vec<f64>>()
    };
    let reflectances = ETAS.map(reflectance);
    let mut lobe = vec![0.0; samples.len()];
    let mut shapes = vec![0.0; samples.len()];
    for alpha in ALPHAS {
        let base = lobe_values([1.0, alpha]);
        let ln_base = |sample: &WeightedCell| (best.model.lobe)(&base, &sample.cosines).ln();
        let ln_base: Vec<f64> = samples.iter().map(ln_base).collect();
        for k in 0..EXPONENTS {
            let s = 0.3 * 1e5f64.powf(k as f64 / (EXPONENTS - 1) as f64);
            for (lobe, ln_base) in lobe.iter_mut().zip(&ln_base) {
                *lobe = (s * ln_base).exp();
            }
            for (eta, reflectance) in ETAS.into_iter().zip(&reflectances) {
                let mut candidate = best;
                candidate.params.lobe = lobe_values([s, alpha]);
                candidate.params.eta = eta;
                for ((shape, lobe), reflectance) in shapes.iter_mut().zip(&lobe).zip(reflectance) {
                    *shape = reflectance * lobe;
                }
                let mut error = 0.0;
                for channel in 0..3 {
                    let (rho_d, k_s) = amplitudes(&samples, &shapes, channel);
                    candidate.params.rho_d[channel] = rho_d;
                    candidate.params.k_s[channel] = k_s;
                    error += absolute_error(&samples, &shapes, channel, rho_d, k_s);
                }
                if error < best_error {
                    (best, best_error) = (candidate, error);
                }
            }
        }
    }
    best
}

fn samples(table: &Table) -> Vec<WeightedCell> {
    let grid = table.grid();
    let mut samples = Vec::new();
    for h in 0..THETA_H_BINS {
        for d in (STRIDE.0 / 2..THETA_D_BINS).step_by(STRIDE.0) {
            for phi in (STRIDE.1 / 2..grid.phi_d_bins()).step_by(STRIDE.1) {
                let Some(f_r) = table.cell(grid.index(h, d, phi)) else {
                    continue;
                };
                let center = grid.center(h, d, phi);
                let cosines = center.cosines();
                if !cosines.above_horizon() {
                    continue;
                }
                // dωi dωo = 4 cos θd dωh dωd, and a bin of θ_h is as wide as 2h + 1.
                let solid_angle = center.theta_d.cos()
                    * center.theta_h.sin()
                    * center.theta_d.sin()
                    * (2 * h + 1) as f64;
                let weight = solid_angle * cosines.cos_theta_i * cosines.cos_theta_o;
                samples.push(WeightedCell {
                    cosines,
                    weight,
                    relative: f_r.map(|f| weight / f.max(1e-6)),
                    f_r,
                });
            }
        }
    }
    samples
}

/// (ρ_d, k_s) ≥ 0 that minimise Σ (w/f) (ρ_d/π + k_s·shape − f)².
fn amplitudes(samples: &[WeightedCell], shapes: &[f64], channel: usize) -> (f64, f64) {
    let (mut aa, mut ab, mut bb, mut af, mut bf) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (sample, b) in samples.iter().zip(shapes) {
        let (f, w) = (sample.f_r[channel], sample.relative[channel]);
        aa += w;
        ab += w * b;
        bb += w * b * b;
        af += w * f;
        bf += w * b * f;
    }
    let determinant = aa * bb - ab * ab;
    if determinant <= 1e-12 * aa * bb {
        return (PI * af / aa.max(f64::MIN_POSITIVE), 0.0);
    }
    let a = (af * bb - bf * ab) / determinant;
    let b = (bf * aa - af * ab) / determinant;
    match (a < 0.0, b < 0.0) {
        (false, false) => (PI * a, b),
        (true, _) => (0.0, bf / bb),
        (false, true) => (PI * af / aa, 0.0),
    }
}

fn absolute_error(
    samples: &[WeightedCell],
    shapes: &[f64],
    channel: usize,
    rho_d: f64,
    k_s: f64,
) -> f64 {
    samples
        .iter()
        .zip(shapes)
        .map(|(sample, shape)| {
            sample.weight * (rho_d / PI + k_s * shape - sample.f_r[channel]).abs()
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::Params;
    use crate::measured::{Grid, tabulate};

    #[test]
    fn the_guess_is_near_the_model_that_made_the_data() {
        let mut truth = Brdf {
            model: &COMBINED,
            fresnel: Fresnel::Exact,
            params: Params {
                rho_d: [0.3, 0.2, 0.1],
                k_s: [40.0, 50.0, 60.0],
                lobe: lobe_values([60.0, 0.75]),
                eta: 1.5,
            },
        };
        let guess = from_table(&tabulate(&truth, Grid::FOLDED)).params;
        for k in 0..3 {
            assert!(
                (guess.rho_d[k] / truth.params.rho_d[k] - 1.0).abs() < 0.1,
                "{guess:?}"
            );
            assert!(
                (guess.k_s[k] / truth.params.k_s[k] - 1.0).abs() < 0.3,
                "{guess:?}"
            );
        }
        let [s, alpha, ..] = guess.lobe;
        assert!((s / 60.0).ln().abs() < 0.4, "{guess:?}");
        assert!(
            (alpha - 0.75).abs() <= 0.25 && guess.eta == 1.5,
            "{guess:?}"
        );
        // A planted change of the data moves the guess.
        truth.params.lobe[0] = 600.0;
        assert!(from_table(&tabulate(&truth, Grid::FOLDED)).params.lobe[0] > 4.0 * s);
    }

    #[test]
    fn data_without_a_highlight_still_give_finite_parameters() {
        let flat = Table::new(Grid::FOLDED, vec![[0.1; 3]; Grid::FOLDED.len()]);
        let guess = from_table(&flat).params;
        assert!((guess.rho_d[0] - 0.1 * PI).abs() < 1e-3, "{guess:?}");
        assert!(
            guess.k_s[0] * Fresnel::Exact.reflectance(1.0, guess.eta) < 1e-3,
            "{guess:?}"
        );
    }
}
