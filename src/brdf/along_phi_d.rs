//! How a lobe varies with φd while θh and θd stay: what a fit uses to evaluate it on a whole row of cells at once.
//!
//! With c = cos² φd, along such a row
//!
//! - `cos θi cos θo = cos²θh cos²θd − sin²θh sin²θd · c` and `1 − wr·wo = 2 sin²θh (cos²θd + sin²θd · c)`,
//! - `cos θi, cos θo = cos θh cos θd ∓ sin θh sin θd √c`,
//!
//! so that every lobe is a number of the row times a function of c.

use super::params::LobeValues;

/// How a lobe varies with φd while θh and θd stay.
#[derive(Clone, Copy, Debug)]
pub enum AlongPhiD {
    /// In no way that is known: a fit evaluates the lobe cell by cell in f64, which is slow.
    Unknown,
    /// As a factor that no parameter changes.
    Factor(Azimuth),
    /// As masking and shadowing with the roughness that is the lobe's first parameter.
    Smith(Smith),
    /// As a power of a base: lobe = base^(`exponent` · first parameter), and at most one more parameter.
    Power {
        /// Multiple of the first parameter that the base is raised to.
        exponent: f64,
        /// The base along a row.
        base: fn(&LobeValues, &RowAngles) -> PowerBase,
    },
}

/// Squared sines and cosines of the θh and θd of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowAngles {
    /// cos² θh
    pub cos2_h: f64,
    /// sin² θh
    pub sin2_h: f64,
    /// cos² θd
    pub cos2_d: f64,
    /// sin² θd
    pub sin2_d: f64,
}

impl RowAngles {
    /// Squares of the sines and cosines of angles in radians.
    pub fn new(theta_h: f64, theta_d: f64) -> Self {
        Self {
            cos2_h: theta_h.cos().powi(2),
            sin2_h: theta_h.sin().powi(2),
            cos2_d: theta_d.cos().powi(2),
            sin2_d: theta_d.sin().powi(2),
        }
    }

    /// Coefficients of cos θi cos θo = `product[0] − product[1] · c`.
    pub fn product(&self) -> [f64; 2] {
        [self.cos2_h * self.cos2_d, self.sin2_h * self.sin2_d]
    }

    /// Coefficients of 1 − wr·wo = `versine[0] + versine[1] · c`, before the clamp of wr·wo at 0.
    pub fn mirror_versine(&self) -> [f64; 2] {
        let twice = 2.0 * self.sin2_h;
        [twice * self.cos2_d, twice * self.sin2_d]
    }

    /// 1 − cos⁴ θh.
    pub fn versine4_h(&self) -> f64 {
        // 1 − cos⁴ = sin² (1 + cos²)
        self.sin2_h * (1.0 + self.cos2_h)
    }
}

/// Base of a power along a row, by its versine 1 − base = `blend[0] · x + blend[1]` with x = min(`x[0] + x[1] · c`, 1).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PowerBase {
    /// Coefficients of x.
    pub x: [f64; 2],
    /// Coefficients of the versine.
    pub blend: [f64; 2],
    /// Coefficients of the versine's slope in the second parameter: `slope[0] · x + slope[1] + slope[2] · c`.
    pub slope: [f64; 3],
}

/// A function of cos θi, cos θo, θh and θd that no parameter changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Azimuth {
    /// 1
    Constant,
    /// 1 / √(cos θi cos θo)
    InverseRoot,
    /// 1 / (cos θi cos θo)
    InverseProduct,
    /// 1 / max(cos θi, cos θo)
    InverseLarger,
    /// G / (cos θi cos θo) with the masking of V-grooves, G = min(1, 2 cos θh cos θo / cos θd, 2 cos θh cos θi / cos θd).
    VGroove,
}

/// Masking and shadowing of Smith, separable: G₁(θi) G₁(θo) / (cos θi cos θo), a function of the roughness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Smith {
    /// G₁ of GGX.
    Ggx,
    /// G₁ of Beckmann, in the rational form of [Walter07].
    Beckmann,
}
