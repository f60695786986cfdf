//! The cosines between a pair of directions and the normal that the models are functions of.

use super::directions::{NORMAL, half_vector, mirror};
use glam::DVec3;

/// A cosine clamped at 0, with its versine 1 − cos beside it.
///
/// A glossy lobe lies where the cosine rounds to 1: with s = 100,000 a cosine in f32 is off by 1 % of the lobe, its
/// versine by 0.001 %. Where the cosine is small it is the other way round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cosine {
    /// max(cos, 0), in [0, 1].
    pub cos: f64,
    /// 1 − cos, in [0, 1].
    pub versine: f64,
}

impl Cosine {
    /// Cosine of the angle between unit vectors; the versine from their chord: |a − b|² = 2 − 2 a·b.
    fn between(a: DVec3, b: DVec3) -> Self {
        Self {
            cos: a.dot(b).max(0.0),
            versine: (0.5 * (a - b).length_squared()).min(1.0),
        }
    }

    /// Cosine of an angle in [0, π/2] radians.
    pub fn of(angle: f64) -> Self {
        Self {
            cos: angle.cos().max(0.0),
            versine: (2.0 * (0.5 * angle).sin().powi(2)).min(1.0),
        }
    }

    /// cos^exponent for exponent > 0; from the versine where that is below ½, from the cosine elsewhere.
    pub fn pow(self, exponent: f64) -> f64 {
        let ln = if self.versine < 0.5 {
            (-self.versine).ln_1p()
        } else {
            self.cos.ln()
        };
        (exponent * ln).exp()
    }
}

/// Cosines of (wi, wo) that a reflection model is a function of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cosines {
    /// wi·n, not clamped: negative below the horizon.
    pub cos_theta_i: f64,
    /// wo·n, not clamped: negative below the horizon.
    pub cos_theta_o: f64,
    /// wr·wo, clamped at 0.
    pub wr_wo: Cosine,
    /// wh·n, clamped at 0.
    pub wh_n: Cosine,
    /// wi·wh = cos θd, clamped at 0.
    pub wi_wh: Cosine,
}

impl Cosines {
    /// The cosines of the unit vectors `wi` and `wo`.
    pub fn from_directions(wi: DVec3, wo: DVec3) -> Self {
        let wh = half_vector(wi, wo);
        Self {
            cos_theta_i: wi.z,
            cos_theta_o: wo.z,
            wr_wo: Cosine::between(mirror(wi), wo),
            wh_n: Cosine::between(wh, NORMAL),
            wi_wh: Cosine::between(wi, wh),
        }
    }

    /// Whether both directions are on the upper side of the surface, the horizon included: a BRDF has a value.
    pub fn above_horizon(&self) -> bool {
        self.cos_theta_i >= 0.0 && self.cos_theta_o >= 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::direction;

    #[test]
    fn versines_are_one_minus_the_clamped_cosine() {
        for (theta_i, theta_o, phi_o) in [
            (0.3, 0.9, 2.0),
            (1.5, 1.5, 3.1),
            (0.0, 0.0, 0.0),
            (1.2, 1.4, 0.1),
        ] {
            let (wi, wo) = (direction(theta_i, 0.0), direction(theta_o, phi_o));
            let c = Cosines::from_directions(wi, wo);
            let wr = 2.0 * wi.dot(NORMAL) * NORMAL - wi;
            assert!((1.0 - c.wr_wo.versine - c.wr_wo.cos).abs() < 1e-15);
            assert!((c.wr_wo.cos - wr.dot(wo).max(0.0)).abs() < 1e-15);
            assert!((1.0 - c.wh_n.versine - (wi + wo).normalize().z).abs() < 1e-15);
            assert!((1.0 - c.wh_n.versine - c.wh_n.cos).abs() < 1e-15);
            assert!((1.0 - c.wi_wh.versine - wi.dot((wi + wo).normalize())).abs() < 1e-15);
            assert!((1.0 - c.wi_wh.versine - c.wi_wh.cos).abs() < 1e-15);
        }
    }

    #[test]
    fn powers_equal_powers_of_the_cosine() {
        for cos in [1.0, 0.999, 0.5, 0.01] {
            for exponent in [0.1, 1.0, 50.0] {
                let a = Cosine {
                    cos,
                    versine: 1.0 - cos,
                }
                .pow(exponent);
                let b = f64::powf(cos, exponent);
                assert!(
                    (a - b).abs() <= 1e-12 * b.abs(),
                    "{cos}^{exponent}: {a} {b}"
                );
            }
        }
        let right_angle = Cosine {
            cos: 0.0,
            versine: 1.0,
        };
        assert_eq!(right_angle.pow(0.1), 0.0);
    }
}
