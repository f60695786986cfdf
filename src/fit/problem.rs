//! The data of a fit: a table, a weight and a grazing limit, arranged for passes.

use super::engine;
use super::lanes::LANES;
use super::objective::Space;
use super::options::{GRAZING, Options, Variant, Weight};
use super::outcome::Errors;
use super::passes::{self, Amplitudes};
use super::shape::{Lobe, Shape, Threads};
use super::sites::{Sampling, Sites};
use super::units::Units;
use crate::brdf::Brdf;
use crate::measured::Table;
use std::f64::consts::FRAC_PI_2;

/// A table, a weight and a grazing limit: what the error of a model is measured on.
///
/// Holds a copy of the valid f_r in the order of the passes, about 14 MB for the usual grid, and two small samples of
/// it for searching.
#[derive(Clone, Debug)]
pub struct Problem {
    /// All cells.
    pub(super) all: Sites,
    /// About one in sixteen.
    pub(super) medium: Sites,
    /// About one in sixty.
    pub(super) coarse: Sites,
    /// Whether the limit leaves grazing cells.
    pub(super) grazing: bool,
}

/// Why there is nothing to fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProblemError {
    /// No cell counts.
    #[error("no cell is measured within the grazing limit; raise the limit")]
    NoCells,
    /// Σ w f is 0.
    #[error("every measured value within the grazing limit is 0; there is nothing to fit")]
    Black,
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
    /// If no cell counts or all are 0.
    pub fn new(table: &Table, weight: Weight, limit: f64) -> Result<Self, ProblemError> {
        let limit = limit.clamp(0.0, FRAC_PI_2);
        let all = Sites::new(table, weight, limit, None)?;
        // A sample may miss what little there is.
        let sample = |sampling| {
            Sites::new(table, weight, limit, Some(sampling)).unwrap_or_else(|_| all.clone())
        };
        Ok(Self {
            medium: sample(MEDIUM),
            coarse: sample(COARSE),
            grazing: limit >= GRAZING,
            all,
        })
    }

    /// E of a model over all cells; one pass.
    pub fn error(&self, brdf: &Brdf) -> f64 {
        let (lobe, amplitudes) = self.parts(brdf);
        passes::error(&lobe, &self.all, &amplitudes, Threads::Many)
    }

    /// E of a model in total and in parts; one pass.
    pub fn errors(&self, brdf: &Brdf) -> Errors {
        let (lobe, amplitudes) = self.parts(brdf);
        let all = &self.all;
        let parts = passes::parts(&lobe, all, &amplitudes, Threads::Many);
        Errors {
            total: parts.channels.iter().sum(),
            grazing: (self.grazing && all.grazing_share > 0.0)
                .then(|| parts.grazing / all.grazing_share),
            channels: std::array::from_fn(|k| parts.channels[k] / all.shares[k]),
        }
    }

    /// The model with the best ρ_d and k_s within their default bounds for its (s, α, η): stage 1.
    pub fn with_best_amplitudes(&self, brdf: &Brdf) -> Brdf {
        let space = Space::new(Variant::from(brdf), &Options::default(), self.units());
        let amplitudes = engine::best_amplitudes(self, brdf, &space.limits);
        let params = space.units.with(&amplitudes, brdf.params);
        Brdf { params, ..*brdf }
    }

    /// Bytes of f_r that a pass over all cells reads.
    pub fn bytes(&self) -> usize {
        self.all.bytes()
    }

    pub(super) fn units(&self) -> Units {
        Units::new(self.all.scale)
    }

    pub(super) fn parts(&self, brdf: &Brdf) -> (Lobe, Amplitudes) {
        let shape = Shape::of(Variant::from(brdf), &brdf.params);
        let amplitudes = self.units().amplitudes(&brdf.params);
        (Lobe::new(shape, brdf.fresnel), amplitudes)
    }
}
