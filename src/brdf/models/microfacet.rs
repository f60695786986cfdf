//! Pieces that several models share: roughness, Beckmann's distribution, V-grooves, the ABC falloff.
//!
//! Microfacets are small mirrors; only those whose normal is wh send light from wi to wo. A microfacet model is their
//! density D, times the share G of them that is neither shadowed nor masked, over 4 cosθi cosθo [Walter07, eq. 20].
//! G and the cosines go to 0 together at the horizon, so they are computed as one, which stays finite where their ratio
//! does.

use crate::brdf::params::{AtBound, Param, ParamId, Scale, Starts};
use crate::geom::{Cosine, Cosines};
use std::f64::consts::PI;

/// Smallest cosine that a formula divides by.
const SMALLEST_COSINE: f64 = 1e-6;

/// Row of the roughness a.
pub(super) const ROUGHNESS: Param = Param {
    id: ParamId("roughness"),
    symbol: "a",
    name: "roughness",
    unit: "",
    range: (1e-3, 1.0),
    domain: (1e-4, 10.0),
    bounds: (1e-3, 1.0),
    at_bounds: [AtBound::Unknown; 2],
    starts: Starts::PerDecade(5.0),
    default: 0.1,
    scale: Scale::Log {
        smallest_exponent: -3,
    },
    help: "Spread of the slopes of the surface: the larger, the wider the highlight.",
};

/// A cosine that a formula may divide by.
pub(super) fn divisor(cos: f64) -> f64 {
    cos.max(SMALLEST_COSINE)
}

/// sin²θ from the versine: 1 − cos² would round a needle away.
pub(super) fn sin_squared(x: Cosine) -> f64 {
    x.versine * (2.0 - x.versine)
}

/// exp(−tan²θ/a²), the Gaussian of the slope.
pub(super) fn gaussian_of_tan(roughness: f64, x: Cosine) -> f64 {
    let scale = divisor(x.cos) * roughness;
    (-sin_squared(x) / (scale * scale)).exp()
}

/// Beckmann's D = exp(−tan²θh/a²) / (π a² cos⁴θh) [Walter07, eq. 25], in 1/sr.
pub(super) fn beckmann_d(roughness: f64, wh_n: Cosine) -> f64 {
    let cos = divisor(wh_n.cos);
    let scale = roughness * cos * cos;
    gaussian_of_tan(roughness, wh_n) / (PI * scale * scale)
}

/// G/(cos θi cos θo) of V-grooves, G = min(1, 2 cosθh cosθi/cosθd, 2 cosθh cosθo/cosθd) [CookTorrance82].
pub(super) fn vgroove_over_cosines(c: &Cosines) -> f64 {
    let (cos_i, cos_o) = (divisor(c.cos_theta_i), divisor(c.cos_theta_o));
    let open = 1.0 / (cos_i * cos_o);
    let blocked = 2.0 * c.wh_n.cos / (divisor(c.wi_wh.cos) * cos_i.max(cos_o));
    open.min(blocked)
}

/// (1 + b x)^(−c), the falloff of the ABC model [Low12], for x ≥ 0.
pub(super) fn abc_falloff(b: f64, c: f64, x: f64) -> f64 {
    (-c * (b * x).ln_1p()).exp()
}
