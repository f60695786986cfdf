//! Phong: the cosine between the mirror direction and the viewer.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | ρ_d, k_s | ≥ 0 | diffuse reflectance, specular amplitude |
//! | s | > 0 | specular exponent |
//!
//! `f_r = ρ_d/π + ρ_s (s+2)/(2π) (wr·wo)^s` [Nielsen14] after [AkenineMoller08]. At grazing angles the highlight
//! stretches into a broad band.

use crate::brdf::model::Model;
use crate::brdf::params::{self, Params};
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Phong model.
pub static MODEL: Model = Model {
    key: "phong",
    name: "Phong",
    source: "[Nielsen14] after [AkenineMoller08]",
    formula: "(ω_{r}·ω_{o})^{s}",
    params: &[params::RHO_D, params::K_S, params::S, params::ETA],
    lobe,
    wgsl: include_str!("phong.wgsl"),
    normalization: Some(|s| (s + 2.0) / (2.0 * PI)),
    exponent_ratio: 1.0,
    alpha: Some(0.0),
};

fn lobe(p: &Params, c: &Cosines) -> f64 {
    c.wr_wo.pow(p.s)
}
