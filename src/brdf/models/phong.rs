//! Phong: the cosine between the mirror direction and the viewer.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | s | > 0 | specular exponent |
//!
//! `f_r = ρ_d/π + ρ_s (s+2)/(2π) (wr·wo)^s` [Nielsen14] after [AkenineMoller08]. At grazing angles the highlight
//! stretches into a broad band.

use super::exponent;
use crate::brdf::along_phi_d::{AlongPhiD, PowerBase, RowAngles};
use crate::brdf::model::Model;
use crate::brdf::params::LobeValues;
use crate::geom::Cosines;
use std::f64::consts::PI;

/// Row of the Phong model.
pub static MODEL: Model = Model {
    key: "phong",
    name: "Phong",
    word: "Phong",
    source: "[Nielsen14] after [AkenineMoller08]",
    formula: "(ω_{r}·ω_{o})^{s}",
    params: &[exponent::S],
    lobe,
    wgsl: include_str!("phong.wgsl"),
    normalization: Some(|p| (p[0] + 2.0) / (2.0 * PI)),
    along_phi_d: AlongPhiD::Power {
        exponent: 1.0,
        base,
    },
    contains: &[],
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [s, ..] = *p;
    c.wr_wo.pow(s)
}

fn base(_: &LobeValues, row: &RowAngles) -> PowerBase {
    PowerBase {
        x: row.mirror_versine(),
        blend: [1.0, 0.0],
        slope: [0.0; 3],
    }
}
