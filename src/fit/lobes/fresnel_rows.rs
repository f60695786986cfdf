//! The Fresnel factor per bin of θd.

use super::differences::{STEP, log_slope};
use super::{ANGLES, LobeShape};
use crate::measured::grid::THETA_D_BINS;

/// R_F per bin of θd, on which alone it depends.
pub struct FresnelRows {
    /// R_F per bin of θd.
    pub value: [f64; THETA_D_BINS],
    /// ∂ ln R_F / ∂ ln(η − 1) per bin of θd.
    pub slope: [f64; THETA_D_BINS],
}

impl FresnelRows {
    /// R_F of a shape.
    pub fn new(shape: &LobeShape) -> Self {
        let reflectance =
            |d: usize, eta: f64| shape.fresnel.reflectance(ANGLES.theta_d[d].cos, eta);
        // A difference in ln(η − 1) is right for any row of FRESNELS.
        let moved = [-STEP, STEP].map(|step| 1.0 + (shape.eta - 1.0) * step.exp());
        let slope = |d: usize| log_slope(moved.map(|eta| reflectance(d, eta)));
        Self {
            value: std::array::from_fn(|d| reflectance(d, shape.eta)),
            slope: std::array::from_fn(slope),
        }
    }
}
