//! Beckmann: microfacets whose slopes are spread like a Gaussian, with Smith's masking.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | a | > 0 | roughness: √2 times the standard deviation of the slope along a line |
//!
//! `lobe = D(wh) G₁(wi) G₁(wo) / (4 cosθi cosθo)`, `D = exp(−tan²θh/a²) / (π a² cos⁴θh)`, and with `b = 1/(a tanθ)`
//! `G₁ = (3.535 b + 2.181 b²) / (1 + 2.276 b + 2.577 b²)` for b < 1.6, else 1 [Walter07, eq. 20, 25, 27]: a rational
//! form of Smith's masking, off by less than 0.35 %.
//!
//! At grazing angles it does as GGX does: masking takes back what the cosines in the denominator give, and the lobe is
//! finite at the horizon. The tail is shorter, so the highlight ends sooner; its peak leans further beyond the mirror
//! direction, and reaches the horizon at smaller angles of incidence than that of GGX with the same a.

use super::microfacet;
use crate::brdf::along_phi_d::{AlongPhiD, Smith};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;

/// Row of the Beckmann model.
pub static MODEL: Model = Model {
    key: "beckmann",
    name: "Beckmann",
    word: "Beckmann",
    source: "[Walter07]",
    formula: "exp(−tan²θ_{h}/a²) G(a) / (4π a² cos^{4}θ_{h} cosθ_{i} cosθ_{o})",
    params: &[microfacet::ROUGHNESS],
    lobe,
    wgsl: include_str!("beckmann.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Smith(Smith::Beckmann),
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [roughness, ..] = *p;
    0.25 * microfacet::beckmann_d(roughness, c.wh_n)
        * masking_over_cosine(roughness, c.cos_theta_i)
        * masking_over_cosine(roughness, c.cos_theta_o)
}

/// G₁/cos θ, finite at the horizon: b/cos θ is 1/(a sin θ).
fn masking_over_cosine(roughness: f64, cos_theta: f64) -> f64 {
    let cos = cos_theta.max(0.0);
    let scale = roughness * ((1.0 - cos) * (1.0 + cos)).sqrt();
    if cos >= 1.6 * scale {
        return 1.0 / cos;
    }
    let b = cos / scale;
    (3.535 + 2.181 * b) / (scale * (1.0 + b * (2.276 + 2.577 * b)))
}
