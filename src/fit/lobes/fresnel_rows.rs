//! The Fresnel factor per bin of θd.

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
        // A central difference in ln(η − 1): good to 1e-8, and right for any row of FRESNELS.
        const STEP: f64 = 1e-4;
        let moved = |by: f64| 1.0 + (shape.eta - 1.0) * by.exp();
        let slope = |d: usize| {
            let (low, high) = (reflectance(d, moved(-STEP)), reflectance(d, moved(STEP)));
            (high / low).ln() / (2.0 * STEP)
        };
        Self {
            value: std::array::from_fn(|d| reflectance(d, shape.eta)),
            slope: std::array::from_fn(slope),
        }
    }
}
