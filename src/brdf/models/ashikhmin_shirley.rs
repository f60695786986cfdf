//! Ashikhmin-Shirley: a Blinn-Phong highlight that conserves energy, isotropic.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | s | > 0 | specular exponent, of wh·n itself |
//!
//! `lobe = (s+1)/(8π) · (wh·n)^s / ((wi·wh) max(wi·n, wo·n))` [AshikhminShirley00], with one exponent in place of two.
//! The diffuse term is Lambert's, not the paper's.
//!
//! At grazing angles the denominator lifts the condensed highlight of Blinn-Phong: in the mirror direction it grows
//! like 1/cos²θ, without end. The larger cosine, not both, keeps the albedo bounded: it falls slowly towards the
//! horizon, to about a half of its value at normal incidence, since half of the lobe is then below the horizon.

use super::exponent;
use super::microfacet::divisor;
use crate::brdf::along_phi_d::{AlongPhiD, Azimuth};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Ashikhmin-Shirley model.
pub static MODEL: Model = Model {
    key: "ashikhmin-shirley",
    name: "Ashikhmin-Shirley",
    word: "Ashikhmin-Shirley",
    source: "[AshikhminShirley00]",
    formula: "(s+1)/(8π) · (ω_{h}·n)^{s} / ((ω_{i}·ω_{h}) max(ω_{i}·n, ω_{o}·n))",
    params: &[exponent::S_OF_WH],
    lobe,
    wgsl: include_str!("ashikhmin_shirley.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Factor(Azimuth::InverseLarger),
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [s, ..] = *p;
    let larger = divisor(c.cos_theta_i.max(c.cos_theta_o));
    (s + 1.0) / (8.0 * PI) * c.wh_n.pow(s) / (divisor(c.wi_wh.cos) * larger)
}
