//! The kernels against the formulas in f64 and against differences.

use super::amplitudes::Amplitudes;
use super::kernels;
use super::lobe_kernel::{LobeKernel, LobeShape};
use super::options::NO_LIMIT;
use super::threads::Threads;
use super::*;
use crate::brdf::fresnel::FRESNELS;
use crate::brdf::{Fresnel, MODELS, Params};
use crate::measured::{Grid, SAMPLES};

fn problem() -> Problem {
    Problem::new(&SAMPLES[0].synthesize(), Weight::Cosine, NO_LIMIT).expect("is measured")
}

/// Largest difference between the lobe of the kernel and that of the model, over the cells of a sample.
fn worst(problem: &Problem, variant: Variant, params: Params, shape: LobeShape) -> f64 {
    let cells = &problem.coarse;
    let mut shapes = Vec::new();
    kernels::fill(
        &LobeKernel::new(shape, variant.fresnel),
        cells,
        &mut shapes,
        Threads::One,
    );
    let brdf = variant.with(params);
    let mut worst = 0.0_f64;
    for row in &cells.rows {
        let count = row.blocks * simd::LANES;
        let found = &shapes[row.first_block * simd::LANES..][..count];
        for (found, cos2) in found.iter().zip(cells.cos2_of(row)) {
            let mut center = Grid::FOLDED.center(row.theta_h, row.theta_d, 0);
            center.phi_d = f64::from(*cos2).sqrt().acos();
            let exact = brdf.specular_shape(&center.cosines());
            worst = worst.max((f64::from(*found) - exact).abs());
        }
    }
    worst
}

#[test]
fn the_kernel_is_every_model_with_every_fresnel_factor() {
    let problem = problem();
    for model in MODELS {
        for fresnel in FRESNELS {
            let variant = Variant { model, fresnel };
            for (s, alpha, eta) in [
                (0.4, 0.0, 1.3),
                (1.0, 1.0, 2.5),
                (37.0, 0.3, 1.5),
                (3000.0, 0.7, 1.01),
                (1e5, 0.5, 40.0),
            ] {
                let params = Params {
                    s,
                    alpha,
                    eta,
                    ..Params::default()
                };
                let shape = LobeShape::of(variant, &params);
                // A small power is steep where the cosine is 0: f32 holds no versine between 1 - 6e-8 and 1.
                let limit = if s <= 1.0 { 1e-2 } else { 3e-6 };
                let off = worst(&problem, variant, params, shape);
                assert!(
                    off < limit,
                    "{} {} {params:?}: {off}",
                    model.key,
                    fresnel.key()
                );
                // A planted error: an exponent that is off by a thousandth.
                let planted = LobeShape {
                    s: 1.001 * shape.s,
                    ..shape
                };
                assert!(s <= 1.0 || worst(&problem, variant, params, planted) > 1e-5);
            }
        }
    }
}

#[test]
fn slopes_are_those_of_the_error() {
    let problem = problem();
    let cells = &problem.medium;
    let amplitudes = Amplitudes {
        diffuse: [0.3, 0.2, 0.1],
        specular: [3.0, 2.0, 1.0],
    };
    for (s, alpha, eta) in [
        (0.4, 0.5, 1.5),
        (1.6, 0.9, 1.3),
        (10.0, 0.1, 2.0),
        (300.0, 0.3, 1.1),
    ] {
        let point = LobeShape { s, alpha, eta }.point();
        let lobe = |point| LobeKernel::new(LobeShape::at(point), Fresnel::Exact);
        let error = |point| kernels::error(&lobe(point), cells, &amplitudes, Threads::One);
        let slopes = kernels::slopes(&lobe(point), cells, &amplitudes, 0.005, Threads::One);
        assert!((slopes.error - error(point)).abs() < 1e-6 * slopes.error);
        for k in 0..3 {
            let moved = |by: f64| {
                let mut point = point;
                point[k] += by;
                error(point)
            };
            let difference = (moved(1e-2) - moved(-1e-2)) / 2e-2;
            let found = slopes.gradient[k];
            let close = |found: f64| (found - difference).abs() < 3e-3 * difference.abs() + 1e-6;
            assert!(close(found), "{s} {alpha} {eta}, {k}: {found} {difference}");
            assert!(!close(1.01 * found + 1e-5), "a planted error passes");
        }
    }
}
