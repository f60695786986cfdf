//! GGX: microfacets whose slopes have a long tail, so that the highlight has a halo.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | a | > 0 | roughness: slope at which the share of the facets has fallen to a quarter |
//!
//! `lobe = D(wh) G₁(wi) G₁(wo) / (4 cosθi cosθo)`, `D = a² / (π (cos²θh (a² − 1) + 1)²)`,
//! `G₁ = 2 / (1 + √(1 + a² tan²θ))` [Walter07, eq. 20, 33, 34], shadowing and masking taken as independent.
//!
//! At grazing angles every facet that is turned away hides behind another one, and the masking takes back what the
//! cosines in the denominator give: the lobe stays finite at the horizon, at most 1/a² times D. The highlight leans
//! towards the horizon beyond the mirror direction. The albedo without Fresnel factor stays below 1 and falls a little:
//! light that meets a second facet is lost.

use super::microfacet;
use crate::brdf::along_phi_d::{AlongPhiD, Smith};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the GGX model.
pub static MODEL: Model = Model {
    key: "ggx",
    name: "GGX",
    word: "GGX",
    source: "[Walter07]",
    formula: "a² G(a) / (4π cos^{4}θ_{h} (a² + tan²θ_{h})² cosθ_{i} cosθ_{o})",
    params: &[microfacet::ROUGHNESS],
    lobe,
    wgsl: include_str!("ggx.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Smith(Smith::Ggx),
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [roughness, ..] = *p;
    let cos_h = c.wh_n.cos;
    // cos²(a² − 1) + 1 as a sum of two squares, which does not cancel at the peak.
    let width = roughness * roughness * cos_h * cos_h + microfacet::sin_squared(c.wh_n);
    let root_d = roughness / width;
    root_d * root_d / PI
        * masking_over_two_cosines(roughness, c.cos_theta_i)
        * masking_over_two_cosines(roughness, c.cos_theta_o)
}

/// G₁/(2 cos θ), finite at the horizon.
fn masking_over_two_cosines(roughness: f64, cos_theta: f64) -> f64 {
    let cos = cos_theta.max(0.0);
    let sin2 = (1.0 - cos) * (1.0 + cos);
    1.0 / (cos + (cos * cos + roughness * roughness * sin2).sqrt())
}
