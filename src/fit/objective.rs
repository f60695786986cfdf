//! E as a function of the shape alone: the objective of the descents and of the grid of starts.

use super::amplitudes::{AmplitudeBounds, AmplitudeUnits, Amplitudes};
use super::descent::Value;
use super::kernels;
use super::lobe_kernel::{LobeKernel, LobeShape, SearchPoint};
use super::options::{FitOptions, SMALLEST_ETA, Variant};
use super::regression::{self, Effort};
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use crate::brdf::{Fresnel, ParamId, Params, params};
use glam::DVec3;

/// Half width of the band in which the sign of a residual is softened for gradients, relative to the model, as a share
/// of the error: narrower than residuals commonly are, or the gradient would be that of another function.
const SOFT_BAND: f64 = 0.05;
const WIDEST_SOFT_BAND: f64 = 0.01;

/// A shape with its amplitudes and their E on a set of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Shape as a point of the search: (ln s, α, ln(η − 1)).
    pub point: SearchPoint,
    /// Amplitudes ρ_d/π and k_s.
    pub amplitudes: Amplitudes,
    /// E on the cells of the objective.
    pub error: f64,
}

/// Search space of a fit: a variant with bounds of its variables.
#[derive(Clone, Copy, Debug)]
pub struct SearchSpace {
    /// Model and Fresnel factor that are fitted.
    pub variant: Variant,
    /// Bounds of (ln s, α, ln(η − 1)), (smallest, largest); both alike where held.
    pub bounds: [(f64, f64); 3],
    /// Bounds of the amplitudes; both alike where held.
    pub limits: AmplitudeBounds,
    /// Units of the amplitudes.
    pub units: AmplitudeUnits,
}

impl SearchSpace {
    /// Search space of a variant under the options of a fit.
    pub fn new(variant: Variant, options: &FitOptions, units: AmplitudeUnits) -> Self {
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

    /// Parameters of a candidate. Values that are held come out as they went in.
    pub fn params(&self, candidate: &Candidate, options: &FitOptions) -> Params {
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

/// Rule for the amplitudes of a shape.
#[derive(Clone, Copy, Debug)]
pub enum AmplitudeRule {
    /// Amplitudes fixed at these values.
    Fixed(Amplitudes),
    /// Amplitudes that minimise E within these bounds, solved for each shape anew.
    Optimised(AmplitudeBounds),
}

/// Evaluator of E at points of the search, with the state that speeds up the next evaluation.
pub struct Objective<'a> {
    cells: &'a SymmetricCells,
    fresnel: Fresnel,
    rule: AmplitudeRule,
    threads: Threads,
    shapes: Vec<f32>,
    /// Last solution with its R_F(0), the start of the next: when η moves, k_s·R_F(0) stays about the same.
    warm: Option<(Amplitudes, f64)>,
    /// Candidate with the smallest E so far.
    pub best: Option<Candidate>,
    /// Number of points evaluated.
    pub evaluations: usize,
}

impl<'a> Objective<'a> {
    /// Objective on a set of cells; `near` is a candidate whose amplitudes are a good start.
    pub fn new(
        cells: &'a SymmetricCells,
        fresnel: Fresnel,
        rule: AmplitudeRule,
        near: Option<&Candidate>,
        threads: Threads,
    ) -> Self {
        let warm = near.map(|near| (near.amplitudes, normal_reflectance(fresnel, near.point)));
        Self {
            cells,
            fresnel,
            rule,
            threads,
            shapes: Vec::new(),
            warm,
            best: None,
            evaluations: 0,
        }
    }

    /// E and its gradient at a point.
    pub fn value(&mut self, point: SearchPoint) -> Value {
        let lobe = LobeKernel::new(LobeShape::at(point), self.fresnel);
        let amplitudes = self.amplitudes(&lobe, point);
        let error = self.best.map_or(1.0, |best| best.error);
        let band = (SOFT_BAND * error).clamp(1e-7, WIDEST_SOFT_BAND);
        let slopes = kernels::slopes(&lobe, self.cells, &amplitudes, band, self.threads);
        self.record(Candidate {
            point,
            amplitudes,
            error: slopes.error,
        });
        Value {
            error: slopes.error,
            gradient: DVec3::from_array(slopes.gradient),
        }
    }

    /// Candidate at a point with solved amplitudes, without gradient.
    pub fn error(&mut self, point: SearchPoint) -> Candidate {
        let lobe = LobeKernel::new(LobeShape::at(point), self.fresnel);
        let (amplitudes, errors) = self.solve(&lobe, point);
        let candidate = Candidate {
            point,
            amplitudes,
            error: errors.iter().sum(),
        };
        self.record(candidate);
        candidate
    }

    fn amplitudes(&mut self, lobe: &LobeKernel, point: SearchPoint) -> Amplitudes {
        match self.rule {
            AmplitudeRule::Fixed(amplitudes) => amplitudes,
            AmplitudeRule::Optimised(_) => self.solve(lobe, point).0,
        }
    }

    fn solve(&mut self, lobe: &LobeKernel, point: SearchPoint) -> (Amplitudes, [f64; 3]) {
        let limits = match self.rule {
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

    fn record(&mut self, candidate: Candidate) {
        self.evaluations += 1;
        if self.best.is_none_or(|best| candidate.error < best.error) {
            self.best = Some(candidate);
        }
    }
}

fn normal_reflectance(fresnel: Fresnel, point: SearchPoint) -> f64 {
    fresnel.reflectance(1.0, LobeShape::at(point).eta)
}
