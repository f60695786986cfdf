//! Blinn-Phong: the cosine between the half vector and the normal.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | s | > 0 | specular exponent, of wh·n itself |
//!
//! `f_r = ρ_d/π + ρ_s (s+8)/(8π) (wh·n)^s` [Nielsen14] after [AkenineMoller08]. At grazing angles the highlight is
//! condensed towards the plane of incidence.

use super::exponent;
use crate::brdf::along_phi_d::{AlongPhiD, PowerBase, RowAngles};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Blinn-Phong model.
pub static MODEL: Model = Model {
    key: "blinn-phong",
    name: "Blinn-Phong",
    word: "Blinn-Phong",
    source: "[Nielsen14] after [AkenineMoller08]",
    formula: "(ω_{h}·n)^{s}",
    params: &[exponent::S_OF_WH],
    lobe,
    wgsl: include_str!("blinn_phong.wgsl"),
    normalization: Some(|p| (p[0] + 8.0) / (8.0 * PI)),
    // (wh·n)^s as a power of (wh·n)⁴, the base that the combined model has at α = 1.
    along_phi_d: AlongPhiD::Power {
        exponent: 0.25,
        base,
    },
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [s, ..] = *p;
    c.wh_n.pow(s)
}

fn base(_: &LobeValues, row: &RowAngles) -> PowerBase {
    PowerBase {
        x: row.mirror_versine(),
        blend: [0.0, row.versine4_h()],
        slope: [0.0; 3],
    }
}
