//! Ward: a Gaussian of the slope of the half vector, isotropic.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | a | > 0 | roughness: slope at which the lobe has fallen to 1/e |
//!
//! `lobe = exp(−tan²θh/a²) / (4π a² √(cosθi cosθo))` [Ward92], with one roughness in place of two.
//!
//! At grazing angles the root in the denominator lifts the highlight less than the facets of a surface would: the
//! albedo falls far below its value at normal incidence, and the material looks too dark towards the horizon. Right at
//! the horizon the root makes the lobe grow without end all the same. Ward-Dür is the repair.

use super::microfacet::{self, divisor};
use crate::brdf::along_phi_d::{AlongPhiD, Azimuth};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Ward model.
pub static MODEL: Model = Model {
    key: "ward",
    name: "Ward",
    word: "Ward",
    source: "[Ward92]",
    formula: "exp(−tan²θ_{h}/a²) / (4π a² √((ω_{i}·n)(ω_{o}·n)))",
    params: &[microfacet::ROUGHNESS],
    lobe,
    wgsl: include_str!("ward.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Factor(Azimuth::InverseRoot),
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [roughness, ..] = *p;
    let cosines = divisor(c.cos_theta_i) * divisor(c.cos_theta_o);
    microfacet::gaussian_of_tan(roughness, c.wh_n)
        / (4.0 * PI * roughness * roughness * cosines.sqrt())
}
