//! E as a function of the shape alone: what the descents and the grid of starts evaluate.

use super::amplitudes::{AmplitudeBounds, AmplitudeUnits, Amplitudes};
use super::descent::Value;
use super::kernels;
use super::lobe_kernel::{LobeKernel, LobeShape, SearchPoint};
use super::options::{Options, SMALLEST_ETA, Variant};
use super::regression::{self, Effort};
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use crate::brdf::{Fresnel, ParamId, Params, params};
use glam::DVec3;

/// Half width of the band in which the sign of a residual is softened for slopes, relative to the model, as a share
/// of the error: narrower than residuals commonly are, or the slopes would be those of another function.
const SOFT_BAND: f64 = 0.05;
const WIDEST_SOFT_BAND: f64 = 0.01;

/// A shape with its amplitudes and the E that they give on some cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// (ln s, α, ln(η − 1)).
    pub point: SearchPoint,
    /// ρ_d/π and k_s.
    pub amplitudes: Amplitudes,
    /// E.
    pub error: f64,
}

/// What a fit may move, and how far, in the variables of the search.
#[derive(Clone, Copy, Debug)]
pub struct SearchSpace {
    /// What is fitted.
    pub variant: Variant,
    /// Bounds of (ln s, α, ln(η − 1)); both alike where held.
    pub bounds: [(f64, f64); 3],
    /// Bounds of the amplitudes, likewise.
    pub limits: AmplitudeBounds,
    /// The units of the amplitudes.
    pub units: AmplitudeUnits,
}

impl SearchSpace {
    /// The space of a variant.
    pub fn new(variant: Variant, options: &Options, units: AmplitudeUnits) -> Self {
        let row = |id| variant.model.param(id);
        let bounds = |id: ParamId, held: Option<f64>, missing: f64| match (held, row(id)) {
            (Some(value), Some(_)) => (value, value),
            (None, Some(row)) => options.bounds_of(row),
            (_, None) => (missing, missing),
        };
        let ratio = variant.model.exponent_ratio;
        let s = bounds(ParamId::S, options.held.s, params::S.default);
        let alpha = variant.model.alpha.unwrap_or(params::ALPHA.default);
        let alpha = bounds(ParamId::Alpha, options.held.alpha, alpha);
        let eta = match variant.fresnel {
            Fresnel::None => (params::ETA.default, params::ETA.default),
            _ => bounds(ParamId::Eta, options.held.eta, params::ETA.default),
        };
        let ln_eta = |eta: f64| (eta.max(SMALLEST_ETA) - 1.0).ln();
        let amplitude = |id: ParamId, held: Option<[f64; 3]>, unit: f64| {
            let (low, high) = bounds(id, None, 0.0);
            std::array::from_fn(|k| match held {
                Some(held) => (held[k] / unit, held[k] / unit),
                None => (low / unit, high / unit),
            })
        };
        Self {
            variant,
            bounds: [
                ((s.0 / ratio).ln(), (s.1 / ratio).ln()),
                alpha,
                (ln_eta(eta.0), ln_eta(eta.1)),
            ],
            limits: AmplitudeBounds {
                diffuse: amplitude(ParamId::RhoD, options.held.rho_d, units.rho_d),
                specular: amplitude(ParamId::KS, options.held.k_s, units.k_s),
            },
            units,
        }
    }

    /// The nearest point within the bounds.
    pub fn clamp(&self, point: SearchPoint) -> SearchPoint {
        std::array::from_fn(|k| point[k].clamp(self.bounds[k].0, self.bounds[k].1))
    }

    /// The parameters of a candidate. Values that are held come out as they went in.
    pub fn params(&self, candidate: &Candidate, options: &Options) -> Params {
        let amplitudes = &candidate.amplitudes;
        let mut params = self.units.with(amplitudes, Params::default());
        let LobeShape { s, alpha, eta } = LobeShape::at(candidate.point);
        params.s = s * self.variant.model.exponent_ratio;
        params.alpha = alpha;
        params.eta = eta;
        // Where the search has not moved from what was given, that comes out to its last digit.
        let given = options.start.over(params);
        let unmoved = LobeShape::of(self.variant, &given).point();
        if unmoved[0] == candidate.point[0] {
            params.s = given.s;
        }
        if unmoved[2] == candidate.point[2] {
            params.eta = given.eta;
        }
        // Rounding of logarithms must not step over a bound or off a held value.
        for row in self
            .variant
            .model
            .params
            .iter()
            .filter(|row| !row.id.is_color())
        {
            let (low, high) = options.bounds_of(row);
            let value = &mut params.get_mut(row.id)[0];
            *value = value.clamp(low, high);
        }
        let held = options.held.over(params);
        for row in self.variant.model.params {
            params.get_mut(row.id).copy_from_slice(held.get(row.id));
        }
        let unused = |id| self.variant.model.param(id).is_none();
        if unused(ParamId::Alpha) {
            params.alpha = params::ALPHA.default;
        }
        if self.variant.fresnel == Fresnel::None {
            params.eta = params::ETA.default;
        }
        params
    }
}

/// Which amplitudes go with a shape.
#[derive(Clone, Copy, Debug)]
pub enum AmplitudeRule {
    /// Fixed at these values.
    Fixed(Amplitudes),
    /// The best ones within bounds, for each shape anew.
    Optimised(AmplitudeBounds),
}

/// Evaluates E at points, keeping what helps the next evaluation.
pub struct Objective<'a> {
    cells: &'a SymmetricCells,
    fresnel: Fresnel,
    follow: AmplitudeRule,
    threads: Threads,
    shapes: Vec<f32>,
    /// The last solution, with R_F(0) there: when η moves, k_s·R_F(0) is what stays.
    warm: Option<(Amplitudes, f64)>,
    /// The best so far.
    pub best: Option<Candidate>,
    /// How many points were evaluated.
    pub evaluations: usize,
}

impl<'a> Objective<'a> {
    /// On some cells, from amplitudes that may be near.
    pub fn new(
        cells: &'a SymmetricCells,
        fresnel: Fresnel,
        follow: AmplitudeRule,
        near: Option<&Candidate>,
        threads: Threads,
    ) -> Self {
        let warm = near.map(|near| (near.amplitudes, normal_reflectance(fresnel, near.point)));
        Self {
            cells,
            fresnel,
            follow,
            threads,
            shapes: Vec::new(),
            warm,
            best: None,
            evaluations: 0,
        }
    }

    /// E and its slopes.
    pub fn value(&mut self, point: SearchPoint) -> Value {
        let lobe = LobeKernel::new(LobeShape::at(point), self.fresnel);
        let amplitudes = self.amplitudes(&lobe, point);
        let error = self.best.map_or(1.0, |best| best.error);
        let band = (SOFT_BAND * error).clamp(1e-7, WIDEST_SOFT_BAND);
        let slopes = kernels::slopes(&lobe, self.cells, &amplitudes, band, self.threads);
        self.take(Candidate {
            point,
            amplitudes,
            error: slopes.error,
        });
        Value {
            error: slopes.error,
            gradient: DVec3::from_array(slopes.gradient),
        }
    }

    /// E alone, for solved amplitudes.
    pub fn error(&mut self, point: SearchPoint) -> Candidate {
        let lobe = LobeKernel::new(LobeShape::at(point), self.fresnel);
        let (amplitudes, errors) = self.solve(&lobe, point);
        let candidate = Candidate {
            point,
            amplitudes,
            error: errors.iter().sum(),
        };
        self.take(candidate);
        candidate
    }

    fn amplitudes(&mut self, lobe: &LobeKernel, point: SearchPoint) -> Amplitudes {
        match self.follow {
            AmplitudeRule::Fixed(amplitudes) => amplitudes,
            AmplitudeRule::Optimised(_) => self.solve(lobe, point).0,
        }
    }

    fn solve(&mut self, lobe: &LobeKernel, point: SearchPoint) -> (Amplitudes, [f64; 3]) {
        let limits = match self.follow {
            AmplitudeRule::Fixed(held) => AmplitudeBounds::holding(&held),
            AmplitudeRule::Optimised(limits) => limits,
        };
        kernels::fill(lobe, self.cells, &mut self.shapes, self.threads);
        let r0 = normal_reflectance(self.fresnel, point);
        let (start, effort) = match self.warm {
            Some((mut warm, before)) => {
                warm.specular = warm.specular.map(|b| b * before / r0);
                let error = self.best.map_or(1.0, |best| best.error);
                (warm, Effort::WARM.near_error(error))
            }
            None => (regression::cold(self.cells, &limits), Effort::COLD),
        };
        let solution = regression::solve(
            self.cells,
            &self.shapes,
            &start,
            &limits,
            effort,
            self.threads,
        );
        self.warm = Some((solution.0, r0));
        solution
    }

    fn take(&mut self, candidate: Candidate) {
        self.evaluations += 1;
        if self.best.is_none_or(|best| candidate.error < best.error) {
            self.best = Some(candidate);
        }
    }
}

fn normal_reflectance(fresnel: Fresnel, point: SearchPoint) -> f64 {
    fresnel.reflectance(1.0, LobeShape::at(point).eta)
}
