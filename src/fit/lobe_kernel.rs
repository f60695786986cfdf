//! Specular shape R_F · lobe of a variant, row by row.
//!
//! Phong and Blinn-Phong are the combined model at α = 0 and α = 1, as their rows in [`crate::brdf::MODELS`] say, so
//! one kernel serves all. A model outside this family needs a kernel of its own here.

use super::options::{SMALLEST_ETA, Variant};
use super::symmetric_cells::CellRow;
use crate::brdf::{Fresnel, Params};
use crate::measured::Grid;
use crate::measured::grid::{THETA_D_BINS, THETA_H_BINS};
use std::sync::LazyLock;

/// Variables of the search: (ln s, α, ln(η − 1)). In these a step means about the same anywhere.
pub type SearchPoint = [f64; 3];

/// Parameters of a specular shape: s of the combined model, α, η.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeShape {
    /// Exponent s of the combined model.
    pub s: f64,
    /// Blend α: 0 for Phong, 1 for Blinn-Phong.
    pub alpha: f64,
    /// Relative index of refraction η.
    pub eta: f64,
}

impl LobeShape {
    /// Shape of a variant with these parameters.
    pub fn of(variant: Variant, params: &Params) -> Self {
        Self {
            s: params.s / variant.model.exponent_ratio,
            alpha: variant.model.alpha.unwrap_or(params.alpha),
            eta: params.eta,
        }
    }

    /// Variables of the search at this shape.
    pub fn point(&self) -> SearchPoint {
        [
            self.s.ln(),
            self.alpha,
            (self.eta - 1.0).max(SMALLEST_ETA - 1.0).ln(),
        ]
    }

    /// Shape at a point of the search.
    pub fn at(point: SearchPoint) -> Self {
        Self {
            s: point[0].exp(),
            alpha: point[1],
            eta: 1.0 + point[2].exp(),
        }
    }
}

/// Functions of the grid's angles that every lobe needs, per bin.
#[derive(Debug)]
struct GridAngles {
    /// 2 sin²θh per bin.
    twice_sin2_h: [f64; THETA_H_BINS],
    /// 1 − cos⁴θh per bin.
    versine4_h: [f64; THETA_H_BINS],
    /// cos θd per bin.
    cos_d: [f64; THETA_D_BINS],
    /// (cos²θd, sin²θd) per bin.
    squares_d: [(f64, f64); THETA_D_BINS],
}

static ANGLES: LazyLock<GridAngles> = LazyLock::new(|| {
    let grid = Grid::FOLDED;
    let theta_h = |h: usize| grid.center(h, 0, 0).theta_h;
    let theta_d = |d: usize| grid.center(0, d, 0).theta_d;
    let sin2_h = |h: usize| theta_h(h).sin().powi(2);
    GridAngles {
        twice_sin2_h: std::array::from_fn(|h| 2.0 * sin2_h(h)),
        // 1 − cos⁴ = sin² (1 + cos²)
        versine4_h: std::array::from_fn(|h| sin2_h(h) * (1.0 + theta_h(h).cos().powi(2))),
        cos_d: std::array::from_fn(|d| theta_d(d).cos()),
        squares_d: std::array::from_fn(|d| (theta_d(d).cos().powi(2), theta_d(d).sin().powi(2))),
    }
});

/// A specular shape with its values per bin, ready for passes.
#[derive(Clone, Debug)]
pub struct LobeKernel {
    shape: LobeShape,
    angles: &'static GridAngles,
    /// R_F per bin of θd.
    fresnel: [f64; THETA_D_BINS],
    /// ∂ ln R_F / ∂ ln(η − 1) per bin of θd.
    fresnel_slope: [f64; THETA_D_BINS],
}

/// Coefficients of a lobe along a row of cells of fixed (θh, θd).
#[derive(Clone, Copy, Debug)]
pub struct RowCoefficients {
    /// Coefficients of 1 − wr·wo = `versine[0] + versine[1] · cos²φd`.
    pub versine: [f32; 2],
    /// 1 − α
    pub phong: f32,
    /// α (1 − cos⁴θh)
    pub blinn: f32,
    /// 1 − cos⁴θh
    pub versine4: f32,
    /// Exponent s of the combined model.
    pub s: f32,
    /// R_F
    pub fresnel: f32,
    /// ∂ ln R_F / ∂ ln(η − 1)
    pub fresnel_slope: f64,
}

impl LobeKernel {
    /// Kernel of a shape with a Fresnel factor.
    pub fn new(shape: LobeShape, fresnel: Fresnel) -> Self {
        let angles = &*ANGLES;
        let reflectance = |d: usize, eta: f64| fresnel.reflectance(angles.cos_d[d], eta);
        // A central difference in ln(η − 1): good to 1e-8, and right for any row of FRESNELS.
        const STEP: f64 = 1e-4;
        let moved = |by: f64| 1.0 + (shape.eta - 1.0) * by.exp();
        let slope = |d: usize| {
            let (low, high) = (reflectance(d, moved(-STEP)), reflectance(d, moved(STEP)));
            (high / low).ln() / (2.0 * STEP)
        };
        Self {
            shape,
            angles,
            fresnel: std::array::from_fn(|d| reflectance(d, shape.eta)),
            fresnel_slope: std::array::from_fn(slope),
        }
    }

    /// Coefficients of the lobe along a row.
    #[inline]
    pub fn row(&self, row: &CellRow) -> RowCoefficients {
        let twice_sin2_h = self.angles.twice_sin2_h[row.theta_h];
        let versine4 = self.angles.versine4_h[row.theta_h];
        let (cos2_d, sin2_d) = self.angles.squares_d[row.theta_d];
        RowCoefficients {
            versine: [
                (twice_sin2_h * cos2_d) as f32,
                (twice_sin2_h * sin2_d) as f32,
            ],
            phong: (1.0 - self.shape.alpha) as f32,
            blinn: (self.shape.alpha * versine4) as f32,
            versine4: versine4 as f32,
            s: self.shape.s as f32,
            fresnel: self.fresnel[row.theta_d] as f32,
            fresnel_slope: self.fresnel_slope[row.theta_d],
        }
    }
}
