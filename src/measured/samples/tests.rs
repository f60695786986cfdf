use super::*;
use crate::brdf::COMBINED;
use crate::brdf::params::lobe_values;
use crate::brdf::{Fresnel, Model, Params};
use crate::geom::Cosines;
use crate::measured::Grid;

#[test]
fn samples_are_named_as_synthetic_and_found_by_key() {
    for sample in &SAMPLES {
        assert!(sample.name.ends_with("(synthetic)"));
        assert!(std::ptr::eq(
            SyntheticMaterial::by_key(sample.key).expect("its own key"),
            sample
        ));
    }
    assert!(SyntheticMaterial::by_key("chrome").is_none());
}

#[test]
fn samples_have_the_gaps_of_a_measurement_and_are_the_same_every_time() {
    for sample in &SAMPLES {
        let table = sample.synthesize();
        let invalid = 1.0 - table.valid_count() as f64 / Grid::FOLDED.len() as f64;
        assert!((0.19..0.23).contains(&invalid), "{invalid}");
        // Some of the lost cells are above the horizon, none of them far.
        let lost = (0..table.cells().len()).filter(|index| table.cell(*index).is_none());
        let cosines = lost.map(|index| {
            let c = cosines(index);
            c.cos_theta_i.min(c.cos_theta_o)
        });
        let highest = cosines.fold(f64::MIN, f64::max);
        assert!((0.005..0.05).contains(&highest), "{highest}");
        let again = sample.synthesize();
        let bits = |table: &Table| -> u64 {
            let all = table.cells().iter().flatten();
            all.fold(0, |sum, f_r| {
                sum * 31 % 1_000_003 + u64::from(f_r.to_bits())
            })
        };
        assert_eq!(bits(&table), bits(&again));
    }
}

#[test]
fn no_sample_reflects_more_than_it_gets() {
    for sample in &SAMPLES {
        let table = sample.synthesize();
        for theta_i in [0.1_f64, 0.6, 1.0, 1.3] {
            let wi = crate::geom::direction(theta_i, 0.0);
            let (mut sum, steps) = ([0.0; 3], 120);
            for a in 0..steps {
                for b in 0..2 * steps {
                    // Even in cos² θ_o, so that the cosine is in the spacing.
                    let cos2 = (f64::from(a) + 0.5) / f64::from(steps);
                    let phi = (f64::from(b) + 0.5) * std::f64::consts::PI / f64::from(steps);
                    let wo = crate::geom::direction(cos2.sqrt().acos(), phi);
                    if let Some(f_r) = table.lookup(wi, wo, crate::measured::Lookup::Smooth) {
                        for (sum, f_r) in sum.iter_mut().zip(f_r) {
                            *sum += f_r * std::f64::consts::PI / f64::from(2 * steps * steps);
                        }
                    }
                }
            }
            assert!(
                sum.iter().all(|albedo| (0.01..1.0).contains(albedo)),
                "{} at {theta_i}: {sum:?}",
                sample.key
            );
        }
    }
}

/// Checks the poster's observations: which α of the combined model fits best.
#[test]
fn the_samples_are_phong_like_blinn_phong_like_and_between() {
    for (key, expected) in [
        ("green-lacquer", 0.0..0.35),
        ("copper-glaze", 0.35..0.65),
        ("hammered-gold", 0.65..1.01),
    ] {
        let table = SyntheticMaterial::by_key(key)
            .expect("a sample")
            .synthesize();
        let fits = fits(&table);
        let (error, alpha) = best(&fits, |_| true);
        let (phong, _) = best(&fits, |alpha| alpha == 0.0);
        let (blinn_phong, _) = best(&fits, |alpha| alpha == 1.0);
        println!(
            "{key}: α {alpha:.2}, error {error:.4}, Phong {phong:.4}, Blinn-Phong {blinn_phong:.4}"
        );
        assert!(expected.contains(&alpha), "{key}: α = {alpha}");
        // It is not a matter of the last digit: the wrong model is clearly worse.
        let worse = if expected.contains(&0.9) {
            phong
        } else {
            blinn_phong
        };
        assert!(worse > 1.05 * error, "{key}: {error} {worse}");
    }
}

fn best(fits: &[(f64, f64)], wanted: impl Fn(f64) -> bool) -> (f64, f64) {
    let wanted = fits.iter().filter(|(_, alpha)| wanted(*alpha));
    *wanted
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .expect("some fits")
}

/// (error, α) of the combined model with exact Fresnel factor on a coarse grid of s, α and η, for the green channel of
/// a sample of the cells.
fn fits(table: &Table) -> Vec<(f64, f64)> {
    let picked: Vec<(Cosines, f64, f64)> = (0..table.cells().len())
        .filter(|index| {
            let (h, d, phi) = Grid::FOLDED.bins(*index);
            h % 3 == 1 && d % 4 == 1 && phi % 12 == 5 && phi < 90
        })
        .filter_map(|index| {
            let (f_r, c) = (table.cell(index)?, cosines(index));
            let (theta_h, theta_d) = (center(index).theta_h, center(index).theta_d);
            let weight = theta_h.sin()
                * theta_h.sqrt()
                * theta_d.sin()
                * theta_d.cos()
                * c.cos_theta_i
                * c.cos_theta_o;
            (c.above_horizon()).then_some((c, f_r[1], weight))
        })
        .collect();
    let combined = Model::by_key("combined").expect("a model");
    let mut fits = Vec::new();
    for alpha in (0..=10).map(|k| f64::from(k) / 10.0) {
        for s in (0..14).map(|k| 4.0 * 1.45_f64.powi(k)) {
            let params = Params {
                lobe: lobe_values([s, alpha]),
                ..COMBINED.default_params()
            };
            let lobe: Vec<f64> = picked
                .iter()
                .map(|(c, ..)| (combined.lobe)(&params.lobe, c))
                .collect();
            for eta in [1.1, 1.2, 1.3, 1.45, 1.7, 2.4] {
                let shape: Vec<f64> = lobe
                    .iter()
                    .zip(&picked)
                    .map(|(lobe, (c, ..))| lobe * Fresnel::Exact.reflectance(c.wi_wh.cos, eta))
                    .collect();
                fits.push((l1_error(&picked, &shape), alpha));
            }
        }
    }
    fits
}

/// Error of the best a + b·shape, a and b ≥ 0, by reweighted least squares: near enough to tell lobes apart.
fn l1_error(picked: &[(Cosines, f64, f64)], shape: &[f64]) -> f64 {
    let (mut a, mut b) = (0.0, 1.0);
    for _ in 0..15 {
        let [mut s, mut sx, mut sy, mut sxx, mut sxy] = [1e-300; 5];
        for ((_, f_r, weight), x) in picked.iter().zip(shape) {
            let w = weight / ((f_r - a - b * x).abs() + 1e-3 * f_r);
            s += w;
            sx += w * x;
            sy += w * f_r;
            sxx += w * x * x;
            sxy += w * x * f_r;
        }
        b = (s * sxy - sx * sy) / (s * sxx - sx * sx);
        a = (sy - b * sx) / s;
        if a < 0.0 {
            (a, b) = (0.0, sxy / sxx);
        }
    }
    let cells = || picked.iter().zip(shape);
    let wrong: f64 = cells()
        .map(|((_, f_r, w), x)| w * (f_r - a - b * x).abs())
        .sum();
    wrong / cells().map(|((_, f_r, w), _)| w * f_r).sum::<f64>()
}

fn center(index: usize) -> crate::geom::HalfDiff {
    let (h, d, phi) = Grid::FOLDED.bins(index);
    Grid::FOLDED.center(h, d, phi)
}

fn cosines(index: usize) -> Cosines {
    center(index).cosines()
}
