//! Ward-Dür: Ward's Gaussian with a normalisation that keeps the albedo up towards grazing.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | a | > 0 | roughness: slope at which the lobe has fallen to 1/e |
//!
//! `lobe = exp(−tan²θh/a²) / (4π a² cosθi cosθo)` [Duer06], with one roughness in place of two.
//!
//! At grazing angles nothing holds back the cosines in the denominator: up to some 80° (with a = 0.2) the albedo stays
//! where it is at normal incidence, as Ward's does not; closer to the horizon it rises above 1 and grows without end,
//! since there is no masking. It is Ward with the opposite fault.

use super::microfacet::{self, divisor};
use crate::brdf::along_phi_d::{AlongPhiD, Azimuth};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Ward-Dür model.
pub static MODEL: Model = Model {
    key: "ward-duer",
    name: "Ward-Dür",
    word: "Ward-Dür",
    source: "[Duer06]",
    formula: "exp(−tan²θ_{h}/a²) / (4π a² (ω_{i}·n)(ω_{o}·n))",
    params: &[microfacet::ROUGHNESS],
    lobe,
    wgsl: include_str!("ward_duer.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Factor(Azimuth::InverseProduct),
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [roughness, ..] = *p;
    let cosines = divisor(c.cos_theta_i) * divisor(c.cos_theta_o);
    microfacet::gaussian_of_tan(roughness, c.wh_n) / (4.0 * PI * roughness * roughness * cosines)
}
