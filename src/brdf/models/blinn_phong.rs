//! Blinn-Phong: the cosine between the half vector and the normal.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | ρ_d, k_s | ≥ 0 | diffuse reflectance, specular amplitude |
//! | s | > 0 | specular exponent, of wh·n itself |
//!
//! `f_r = ρ_d/π + ρ_s (s+8)/(8π) (wh·n)^s` [Nielsen14] after [AkenineMoller08]. At grazing angles the highlight is
//! condensed towards the plane of incidence.

use crate::brdf::model::Model;
use crate::brdf::params::{self, Param, Params};
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Blinn-Phong model.
pub static MODEL: Model = Model {
    key: "blinn-phong",
    name: "Blinn-Phong",
    source: "[Nielsen14] after [AkenineMoller08]",
    formula: "(ω_{h}·n)^{s}",
    params: &[params::RHO_D, params::K_S, S, params::ETA],
    lobe,
    wgsl: include_str!("blinn_phong.wgsl"),
    normalization: Some(|s| (s + 8.0) / (8.0 * PI)),
    exponent_ratio: 4.0,
    alpha: Some(1.0),
};

/// Exponent s with four times the range of the other models, so that each of their highlights has its counterpart here.
const S: Param = Param {
    range: (0.04, 4e5),
    domain: (4e-3, 4e7),
    default: 4.0 * params::S.default,
    ..params::S
};

fn lobe(p: &Params, c: &Cosines) -> f64 {
    c.wh_n.pow(p.s)
}
