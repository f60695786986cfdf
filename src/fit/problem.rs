//! Data of a fit: a table, a weight and a grazing limit, arranged for passes.

use super::amplitudes::{AmplitudeBounds, AmplitudeUnits, Amplitudes};
use super::error::ProblemError;
use super::exact_l1;
use super::kernels;
use super::lobes::LobeShape;
use super::objective::SearchSpace;
use super::options::{FitOptions, Variant, Weight};
use super::outcome::Errors;
use super::regression::{self, Effort};
use super::simd::LANES;
use super::symmetric_cells::{Sampling, SymmetricCells};
use super::threads::Threads;
use crate::brdf::Brdf;
use crate::geom::limits::GRAZING_THETA;
use crate::measured::Table;
use std::f64::consts::FRAC_PI_2;

/// Table, weight and grazing limit over which the error of a model is measured.
///
/// Holds a copy of the valid f_r in the order of the passes, about 14 MB for the usual grid, and two small samples of
/// it for searching.
#[derive(Clone, Debug)]
pub struct Problem {
    /// All cells that count.
    pub(super) all: SymmetricCells,
    /// Sample of about one cell in sixteen.
    pub(super) medium: SymmetricCells,
    /// Sample of about one cell in sixty.
    pub(super) coarse: SymmetricCells,
    /// Whether the limit is at least [`GRAZING_THETA`], so that grazing cells can count.
    pub(super) grazing: bool,
}

const MEDIUM: Sampling = Sampling {
    theta_d: 30,
    phi_d: 2 * LANES,
};
const COARSE: Sampling = Sampling {
    theta_d: 15,
    phi_d: LANES,
};

impl Problem {
    /// Arranges a table for fitting. `limit` is the grazing limit in radians: cells with θi or θo above it do not
    /// count, and [`super::options::NO_LIMIT`] leaves none out that is above the horizon.
    ///
    /// # Errors
    /// No cell counts, or all that count are 0.
    pub fn new(table: &Table, weight: Weight, limit: f64) -> Result<Self, ProblemError> {
        let limit = limit.clamp(0.0, FRAC_PI_2);
        let all = SymmetricCells::new(table, weight, limit, None)?;
        // A sample may miss what little there is.
        let sample = |sampling| {
            SymmetricCells::new(table, weight, limit, Some(sampling))
                .unwrap_or_else(|_| all.clone())
        };
        Ok(Self {
            medium: sample(MEDIUM),
            coarse: sample(COARSE),
            grazing: limit >= GRAZING_THETA,
            all,
        })
    }

    /// E of a model over all cells; one pass.
    pub fn error(&self, brdf: &Brdf) -> f64 {
        let (shape, amplitudes) = self.parts(brdf);
        kernels::error(&*shape.kernel(), &self.all, &amplitudes, Threads::Many)
    }

    /// E of a model in total and in parts; one pass.
    pub fn errors(&self, brdf: &Brdf) -> Errors {
        let (shape, amplitudes) = self.parts(brdf);
        let all = &self.all;
        let parts = kernels::parts(&*shape.kernel(), all, &amplitudes, Threads::Many);
        Errors {
            total: parts.channels.iter().sum(),
            grazing: (self.grazing && all.grazing_energy > 0.0)
                .then(|| parts.grazing / all.grazing_energy),
            channels: std::array::from_fn(|k| parts.channels[k] / all.energy[k]),
        }
    }

    /// Model with the best ρ_d and k_s within their default bounds for its shape: stage 1.
    pub fn with_best_amplitudes(&self, brdf: &Brdf) -> Brdf {
        let space = SearchSpace::new(Variant::from(brdf), &FitOptions::default(), self.units());
        let amplitudes = best_amplitudes(self, brdf, &space.limits);
        let params = space.units.with(&amplitudes, brdf.params);
        Brdf { params, ..*brdf }
    }

    /// Number of bytes of f_r that a pass over all cells reads.
    pub fn bytes(&self) -> usize {
        self.all.bytes()
    }

    pub(super) fn units(&self) -> AmplitudeUnits {
        AmplitudeUnits::new(self.all.scale)
    }

    pub(super) fn parts(&self, brdf: &Brdf) -> (LobeShape, Amplitudes) {
        let shape = LobeShape {
            model: brdf.model,
            fresnel: brdf.fresnel,
            lobe: brdf.params.lobe,
            eta: brdf.params.eta,
        };
        (shape, self.units().amplitudes(&brdf.params))
    }
}

/// Best amplitudes within limits for the shape of a model, whatever its own are: stage 1 alone.
fn best_amplitudes(problem: &Problem, brdf: &Brdf, limits: &AmplitudeBounds) -> Amplitudes {
    let all = &problem.all;
    let (shape, _) = problem.parts(brdf);
    let shapes = kernels::shapes(&*shape.kernel(), all);
    let start = regression::cold(all, limits, shape.height());
    let effort = Effort {
        band: Effort::COLD.band,
        ..Effort::CLOSE
    };
    let (near, _) = regression::solve(all, &shapes, &start, limits, effort, Threads::Many);
    exact_l1::solve(all, &shapes, &near, limits)
}
