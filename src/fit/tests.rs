//! The kernels of all models against the formulas in f64 and against differences.

use super::amplitudes::Amplitudes;
use super::kernels;
use super::lobes::{LobeKernel, LobeShape};
use super::options::NO_LIMIT;
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use super::variables::{ETA_VARIABLE, VARIABLES, value, variable};
use super::*;
use crate::brdf::along_phi_d::AlongPhiD;
use crate::brdf::fresnel::FRESNELS;
use crate::brdf::{Brdf, MODELS, Model};
use crate::measured::{Grid, SAMPLES};

fn problem() -> Problem {
    Problem::new(&SAMPLES[0].synthesize(), Weight::Cosine, NO_LIMIT).expect("is measured")
}

/// Values of the lobe's parameters at shares of the ranges of their sliders.
fn at_shares(model: &Model, shares: [f64; 2]) -> crate::brdf::LobeValues {
    let mut lobe = model.default_lobe();
    for ((row, to), share) in model.params.iter().zip(&mut lobe).zip(shares) {
        let ends = [row.range.0, row.range.1].map(|end| variable(row, end));
        *to = value(row, ends[0] + share * (ends[1] - ends[0]));
    }
    lobe
}

const SHARES: [[f64; 2]; 5] = [[0.2, 0.1], [0.35, 1.0], [0.5, 0.3], [0.75, 0.7], [1.0, 0.5]];

/// Largest distance between a kernel's shapes and those of the model's lobe over the cells of a sample, in what f32 leaves.
fn worst(cells: &SymmetricCells, kernel: &dyn LobeKernel, shape: &LobeShape) -> f64 {
    let mut shapes = Vec::new();
    kernels::fill(kernel, cells, &mut shapes, Threads::One);
    let mut brdf = Brdf::new(shape.model, shape.fresnel);
    (brdf.params.lobe, brdf.params.eta) = (shape.lobe, shape.eta);
    let mut pairs = Vec::new();
    for row in &cells.rows {
        let count = row.blocks * simd::LANES;
        let found = &shapes[row.first_block * simd::LANES..][..count];
        for (found, cos2) in found.iter().zip(cells.cos2_of(row)) {
            let mut center = Grid::FOLDED.center(row.theta_h, row.theta_d, 0);
            center.phi_d = f64::from(*cos2).sqrt().acos();
            let exact = brdf.specular_shape(&center.cosines());
            pairs.push((f64::from(*found), exact));
        }
    }
    let largest = pairs.iter().fold(0.0, |a, pair| f64::max(a, pair.1));
    let off = |(found, exact): &(f64, f64)| (found - exact).abs() / (3e-4 * exact + 3e-6 * largest);
    pairs.iter().map(off).fold(0.0, f64::max)
}

/// Whether a lobe is a small power of its base: it is steep where the base is 0.
fn is_steep(model: &Model, lobe: crate::brdf::LobeValues) -> bool {
    match model.along_phi_d {
        AlongPhiD::Power { exponent, .. } => exponent * lobe[0] <= 1.0,
        _ => false,
    }
}

#[test]
fn every_kernel_is_its_model_with_every_fresnel_factor() {
    let problem = problem();
    let cells = &problem.coarse;
    for model in MODELS {
        for (fresnel, eta) in FRESNELS.into_iter().zip([1.3, 1.01, 40.0]) {
            for shares in SHARES {
                let lobe = at_shares(model, shares);
                let shape = LobeShape {
                    model,
                    fresnel,
                    lobe,
                    eta,
                };
                // f32 holds no versine between 1 - 6e-8 and 1.
                let steep = is_steep(model, lobe);
                let limit = if steep { 3e3 } else { 1.0 };
                for (kernel, name) in [(shape.kernel(), "fast"), (shape.cellwise(), "cell by cell")]
                {
                    let off = worst(cells, &*kernel, &shape);
                    assert!(
                        off < limit,
                        "{} {} {lobe:?} {name}: {off}",
                        model.key,
                        fresnel.key()
                    );
                }
                // A planted error: a first parameter that is off by a tenth.
                let mut planted = shape;
                planted.lobe[0] *= 1.1;
                let off = worst(cells, &*planted.kernel(), &shape);
                assert!(steep || off > 1.0, "{} {lobe:?}: planted {off}", model.key);
            }
        }
    }
}

#[test]
fn slopes_are_those_of_the_error() {
    let problem = problem();
    let cells = &problem.medium;
    for model in MODELS {
        let variant = Variant {
            model,
            fresnel: crate::brdf::Fresnel::Exact,
        };
        for shares in &SHARES[..4] {
            let mut brdf = variant.defaults();
            brdf.params.lobe = at_shares(model, *shares);
            let space = super::objective::SearchSpace::new(
                variant,
                &FitOptions::default(),
                problem.units(),
            );
            let point = space.point(&brdf);
            let shape = |point| LobeShape::at(variant, &point);
            let height = shape(point).height();
            let amplitudes = Amplitudes {
                diffuse: [0.3, 0.2, 0.1],
                specular: [0.2, 0.1, 0.05].map(|b| b / height),
            };
            let error =
                |point| kernels::error(&*shape(point).kernel(), cells, &amplitudes, Threads::One);
            let of = |kernel: Box<dyn LobeKernel>| {
                kernels::slopes(&*kernel, cells, &amplitudes, 0.005, Threads::One)
            };
            let (fast, slow) = (of(shape(point).kernel()), of(shape(point).cellwise()));
            assert!((fast.error - error(point)).abs() < 1e-6 * fast.error);
            let free = (0..model.params.len()).chain([ETA_VARIABLE]);
            for k in 0..VARIABLES {
                let found = fast.gradient[k];
                if !free.clone().any(|free| free == k) {
                    assert_eq!(found, 0.0);
                    continue;
                }
                let moved = |by: f64| {
                    let mut point = point;
                    point[k] += by;
                    error(point)
                };
                let difference = (moved(5e-3) - moved(-5e-3)) / 1e-2;
                let share = if is_steep(model, brdf.params.lobe) {
                    0.25
                } else {
                    1e-2
                };
                let close =
                    |found: f64| (found - difference).abs() < share * difference.abs() + 1e-5;
                assert!(
                    close(found),
                    "{} {shares:?}, {k}: {found} {difference}",
                    model.key
                );
                assert!(
                    close(slow.gradient[k]),
                    "{} {shares:?}, {k}: {:?} {difference}",
                    model.key,
                    slow.gradient
                );
                assert!(
                    difference.abs() < 2e-3 || !close((1.0 + 5.0 * share) * found),
                    "a planted error passes"
                );
            }
        }
    }
}
