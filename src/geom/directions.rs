//! Directions in the local frame of the surface.

use glam::DVec3;

/// The surface normal n.
pub const NORMAL: DVec3 = DVec3::Z;

/// The unit vector at polar angle `theta` from the normal and azimuth `phi`, both in radians.
pub fn direction(theta: f64, phi: f64) -> DVec3 {
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    DVec3::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
}

/// The mirror direction `wr = 2 (wi·n) n − wi`.
pub fn mirror(wi: DVec3) -> DVec3 {
    DVec3::new(-wi.x, -wi.y, wi.z)
}

/// Polar angle from the normal, in [0, π] radians; accurate at the pole, where `acos` is not.
pub fn theta(w: DVec3) -> f64 {
    w.x.hypot(w.y).atan2(w.z)
}

/// Azimuth in [0, 2π) radians; 0 at the pole.
pub fn phi(w: DVec3) -> f64 {
    wrap(w.y.atan2(w.x), std::f64::consts::TAU)
}

/// `angle` taken modulo `period` into [0, `period`), also where rounding would give `period` itself.
pub fn wrap(angle: f64, period: f64) -> f64 {
    let wrapped = angle.rem_euclid(period);
    if wrapped < period { wrapped } else { 0.0 }
}

/// The direction of a vector, itself to the last bit where it has length 1; `None` where it has none, below 1e-6 or from 1e6
/// on.
pub fn unit(v: DVec3) -> Option<DVec3> {
    match v.length() {
        length if (length - 1.0).abs() < 1e-12 => Some(v),
        length if (1e-6..1e6).contains(&length) => Some(v / length),
        _ => None,
    }
}

/// Length below which a sum of unit vectors has no direction: it is the rounding of sines and cosines.
pub(super) const ROUNDING: f64 = 1e-12;

/// Whether wo = −wi up to rounding, so that there is no half vector.
pub(super) fn opposite(wi: DVec3, wo: DVec3) -> bool {
    (wi + wo).length_squared() < ROUNDING * ROUNDING
}

/// The half vector of (wi, wo); the normal where wi = −wo, the limit of pairs that graze from opposite sides.
pub fn half_vector(wi: DVec3, wo: DVec3) -> DVec3 {
    if opposite(wi, wo) {
        NORMAL
    } else {
        (wi + wo).normalize()
    }
}
