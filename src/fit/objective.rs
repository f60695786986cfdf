//! E as a function of the shape alone: the objective of the descents and of the grid of starts.

use super::amplitudes::{AmplitudeBounds, AmplitudeUnits, Amplitudes};
use super::descent::Value;
use super::kernels;
use super::lobes::LobeShape;
use super::options::{FitOptions, Variant};
use super::regression::{self, Effort};
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use super::variables::{ETA_VARIABLE, SearchPoint, VARIABLES, value, variable};
use crate::brdf::params::{ETA, K_S, RHO_D};
use crate::brdf::{Brdf, Fresnel, Param};
use crate::geom::Rgb;

/// Half width of the band in which the sign of a residual is softened for gradients, relative to the model, as a share
/// of the error: narrower than residuals commonly are, or the gradient would be that of another function.
const SOFT_BAND: f64 = 0.05;
const WIDEST_SOFT_BAND: f64 = 0.01;

/// A shape with its amplitudes and their E on a set of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Shape as a point of the search.
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
    /// Bounds of the variables, (smallest, largest); both alike where held, and where there is no such variable.
    pub bounds: [(f64, f64); VARIABLES],
    /// Bounds of the amplitudes; both alike where held.
    pub limits: AmplitudeBounds,
    /// Units of the amplitudes.
    pub units: AmplitudeUnits,
}

impl SearchSpace {
    /// Search space of a variant under the options of a fit.
    pub fn new(variant: Variant, options: &FitOptions, units: AmplitudeUnits) -> Self {
        let mut bounds = [(0.0, 0.0); VARIABLES];
        for (k, row) in rows(variant) {
            let (low, high) = match options.held.number(row.id) {
                Some(held) => (held, held),
                None => options.bounds_of(row),
            };
            bounds[k] = (variable(row, low), variable(row, high));
        }
        let amplitude = |row: &Param, held: Option<Rgb>, unit: f64| {
            let (low, high) = options.bounds_of(row);
            std::array::from_fn(|k| match held {
                Some(held) => (held[k] / unit, held[k] / unit),
                None => (low / unit, high / unit),
            })
        };
        Self {
            variant,
            bounds,
            limits: AmplitudeBounds {
                diffuse: amplitude(&RHO_D, options.held.rho_d, units.rho_d),
                specular: amplitude(&K_S, options.held.k_s, units.k_s),
            },
            units,
        }
    }

    /// Point of a BRDF of the variant.
    pub fn point(&self, brdf: &Brdf) -> SearchPoint {
        let mut point = [0.0; VARIABLES];
        for (k, row) in rows(self.variant) {
            // Every row of the variant is one of its BRDF.
            point[k] = variable(row, brdf.number(row.id).unwrap_or(row.default));
        }
        point
    }

    /// The nearest point within the bounds.
    pub fn clamp(&self, point: SearchPoint) -> SearchPoint {
        std::array::from_fn(|k| point[k].clamp(self.bounds[k].0, self.bounds[k].1))
    }

    /// BRDF of a candidate. Values that are held come out as they went in.
    pub fn brdf(&self, candidate: &Candidate, options: &FitOptions) -> Brdf {
        let mut brdf = Brdf::new(self.variant.model, self.variant.fresnel);
        brdf.params = self.units.with(&candidate.amplitudes, brdf.params);
        for (k, row) in rows(self.variant) {
            let found = candidate.point[k];
            // Where the search has not moved from what was given, that comes out to its last digit.
            let given = options.start.number(row.id);
            let unmoved = given.filter(|given| variable(row, *given) == found);
            // Rounding of logarithms must not step over a bound.
            let (low, high) = options.bounds_of(row);
            let value = unmoved
                .unwrap_or_else(|| value(row, found))
                .clamp(low, high);
            brdf.get_mut(row.id).fill(value);
        }
        options.held.over(brdf)
    }
}

/// Rows of a variant's variables with their indices; η only with a Fresnel factor.
pub fn rows(variant: Variant) -> impl Iterator<Item = (usize, &'static Param)> {
    let eta = (variant.fresnel != Fresnel::None).then_some((ETA_VARIABLE, &ETA));
    variant.model.params.iter().enumerate().chain(eta)
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
    variant: Variant,
    rule: AmplitudeRule,
    threads: Threads,
    shapes: Vec<f32>,
    /// Last solution with the height of its shape, the start of the next: when the shape changes, k_s times its height
    /// stays about the same.
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
        variant: Variant,
        rule: AmplitudeRule,
        near: Option<&Candidate>,
        threads: Threads,
    ) -> Self {
        let shape = |near: &Candidate| LobeShape::at(variant, &near.point);
        let warm = near.map(|near| (near.amplitudes, shape(near).height()));
        Self {
            cells,
            variant,
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
        let shape = LobeShape::at(self.variant, &point);
        let amplitudes = match self.rule {
            AmplitudeRule::Fixed(amplitudes) => amplitudes,
            AmplitudeRule::Optimised(_) => self.solve(&shape).0,
        };
        let error = self.best.map_or(1.0, |best| best.error);
        let band = (SOFT_BAND * error).clamp(1e-7, WIDEST_SOFT_BAND);
        let kernel = shape.kernel();
        let slopes = kernels::slopes(&*kernel, self.cells, &amplitudes, band, self.threads);
        self.record(Candidate {
            point,
            amplitudes,
            error: slopes.error,
        });
        Value {
            error: slopes.error,
            gradient: slopes.gradient,
        }
    }

    /// Candidate at a point with solved amplitudes, without gradient.
    pub fn error(&mut self, point: SearchPoint) -> Candidate {
        let (amplitudes, errors) = self.solve(&LobeShape::at(self.variant, &point));
        let candidate = Candidate {
            point,
            amplitudes,
            error: errors.iter().sum(),
        };
        self.record(candidate);
        candidate
    }

    fn solve(&mut self, shape: &LobeShape) -> (Amplitudes, [f64; 3]) {
        let limits = match self.rule {
            AmplitudeRule::Fixed(held) => AmplitudeBounds::holding(&held),
            AmplitudeRule::Optimised(limits) => limits,
        };
        kernels::fill(&*shape.kernel(), self.cells, &mut self.shapes, self.threads);
        let height = shape.height();
        let (start, effort) = match self.warm {
            Some((mut warm, before)) => {
                warm.specular = warm.specular.map(|b| b * before / height);
                let error = self.best.map_or(1.0, |best| best.error);
                (warm, Effort::WARM.near_error(error))
            }
            None => (regression::cold(self.cells, &limits, height), Effort::COLD),
        };
        let solution = regression::solve(
            self.cells,
            &self.shapes,
            &start,
            &limits,
            effort,
            self.threads,
        );
        self.warm = Some((solution.0, height));
        solution
    }

    fn record(&mut self, candidate: Candidate) {
        self.evaluations += 1;
        if self.best.is_none_or(|best| candidate.error < best.error) {
            self.best = Some(candidate);
        }
    }
}
