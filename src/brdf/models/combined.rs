//! The combined model: between Phong and Blinn-Phong.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | s | > 0 | specular exponent |
//! | α | [0, 1] | 0 is Phong, 1 is Blinn-Phong with exponent 4s |
//!
//! `f_r = ρ_d/π + k_s ((1−α)(wr·wo) + α(wh·n)^4)^s` [Nielsen14]. The fourth power gives both cosines the same
//! curvature at the peak under normal incidence, where wh turns half as far as wo, so that α changes the
//! highlight at grazing angles and leaves the one seen from above.

use super::{blinn_phong, exponent, phong};
use crate::brdf::along_phi_d::{AlongPhiD, PowerBase, RowAngles};
use crate::brdf::model::{Contained, Model};
use crate::brdf::params::{AtBound, LobeValues, Param, ParamId, Scale, Starts};
use crate::geom::{Cosine, Cosines};

/// Row of the combined model.
pub static MODEL: Model = Model {
    key: "combined",
    name: "Combined",
    word: "combined",
    source: "[Nielsen14], the poster's new model",
    formula: "((1 − α)(ω_{r}·ω_{o}) + α(ω_{h}·n)^{4})^{s}",
    params: &[exponent::S, ALPHA],
    lobe,
    wgsl: include_str!("combined.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Power {
        exponent: 1.0,
        base,
    },
    contains: &[
        Contained {
            model: &phong::MODEL,
            factors: &[1.0],
            fixed: &[0.0],
        },
        Contained {
            model: &blinn_phong::MODEL,
            factors: &[0.25],
            fixed: &[1.0],
        },
    ],
};

/// Row of the lobe blend α.
const ALPHA: Param = Param {
    id: ParamId("alpha"),
    symbol: "α",
    name: "lobe blend",
    unit: "",
    range: (0.0, 1.0),
    domain: (0.0, 1.0),
    bounds: (0.0, 1.0),
    // They are models of their own.
    at_bounds: [AtBound::Fine; 2],
    starts: Starts::At(&[0.0, 0.5, 1.0]),
    default: 0.5,
    scale: Scale::Linear,
    help: "0 is Phong, 1 is Blinn-Phong with the exponent 4s.",
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [s, alpha, ..] = *p;
    Cosine {
        cos: (1.0 - alpha) * c.wr_wo.cos + alpha * c.wh_n.cos.powi(4),
        versine: (1.0 - alpha) * c.wr_wo.versine + alpha * versine_pow4(c.wh_n.versine),
    }
    .pow(s)
}

/// 1 − cos⁴ from 1 − cos, without cancellation.
fn versine_pow4(x: f64) -> f64 {
    x * (4.0 - x * (6.0 - x * (4.0 - x)))
}

fn base(p: &LobeValues, row: &RowAngles) -> PowerBase {
    let [_, alpha, ..] = *p;
    let versine4_h = row.versine4_h();
    PowerBase {
        x: row.mirror_versine(),
        blend: [1.0 - alpha, alpha * versine4_h],
        slope: [-1.0, versine4_h, 0.0],
    }
}
