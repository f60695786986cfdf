//! The upper hemisphere on a disc, seen from above.

use crate::geom::direction;
use crate::geom::directions::{phi, theta};
use crate::keys;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Law from θ to the distance from the middle of a disc of radius 1, whose rim is the horizon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DiscProjection {
    /// Distance in proportion to θ.
    #[default]
    Linear,
    /// √2 sin(θ/2): equal solid angles have equal areas (Lambert's azimuthal projection).
    EqualArea,
}

/// All projections in the order offered.
pub const PROJECTIONS: [DiscProjection; 2] = [DiscProjection::Linear, DiscProjection::EqualArea];

impl DiscProjection {
    /// Name in files.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "θo linear",
            Self::EqualArea => "Equal area",
        }
    }

    /// Distance from the middle at θ in [0, π/2] radians; 1 at the horizon.
    pub fn radius(self, theta: f64) -> f64 {
        match self {
            Self::Linear => theta / FRAC_PI_2,
            Self::EqualArea => SQRT_2 * (0.5 * theta).sin(),
        }
    }

    /// θ in radians at a distance in [0, 1] from the middle.
    pub fn theta(self, radius: f64) -> f64 {
        match self {
            Self::Linear => radius * FRAC_PI_2,
            Self::EqualArea => 2.0 * (radius / SQRT_2).asin(),
        }
    }

    /// The place of a direction, x to the right along φ = 0 and y upwards along φ = 90°.
    pub fn place(self, w: DVec3) -> [f64; 2] {
        let (sin, cos) = phi(w).sin_cos();
        let radius = self.radius(theta(w).min(FRAC_PI_2));
        [radius * cos, radius * sin]
    }

    /// The direction at a place; `None` outside the disc.
    pub fn direction(self, [x, y]: [f64; 2]) -> Option<DVec3> {
        let radius = x.hypot(y);
        (radius <= 1.0).then(|| {
            let w = direction(self.theta(radius), y.atan2(x));
            // Rounding must not put the rim below the horizon.
            w.with_z(w.z.max(0.0))
        })
    }
}
