//! Lafortune: Phong with the mirror direction stretched along the normal, isotropic, one lobe.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | s | > 0 | specular exponent |
//! | c_z | ≥ 0 | weight of the normal components against the tangential ones, −1; 1 is Phong |
//!
//! `lobe = (max(0, c_z cosθi cosθo − (wi·wo)_t) / max(1, c_z))^s` [Lafortune97, eq. 4], where t is the tangential part
//! and C_x = C_y = −1: another factor on all three only scales k_s. The divisor is that of [Ngan05], it keeps the lobe
//! at most 1.
//!
//! At grazing angles the normal components vanish and the tangential ones decide. The lobe points to
//! tanθ = tanθi/c_z: with c_z < 1 it leans towards the horizon, off the mirror direction, and grows from c_z^s seen
//! from above to 1 at grazing, which is the grazing intensity that Phong lacks. With c_z > 1 it leans towards the
//! normal and dies out.

use super::microfacet::sin_squared;
use super::{exponent, phong};
use crate::brdf::along_phi_d::{AlongPhiD, PowerBase, RowAngles};
use crate::brdf::model::{Contained, Model};
use crate::brdf::params::{AtBound, LobeValues, Param, ParamId, Scale, Starts};
use crate::geom::{Cosine, Cosines};
use std::f64::consts::PI;

/// Row of the Lafortune model.
pub static MODEL: Model = Model {
    key: "lafortune",
    name: "Lafortune",
    word: "Lafortune",
    source: "[Lafortune97]",
    formula: "((c_{z}(ω_{i}·n)(ω_{o}·n) − (ω_{i}·ω_{o})_{t}) / max(1, c_{z}))^{s}",
    params: &[exponent::S, C_Z],
    lobe,
    wgsl: include_str!("lafortune.wgsl"),
    // [Ngan05]
    normalization: Some(|p| (p[0] + 2.0) / (2.0 * PI)),
    along_phi_d: AlongPhiD::Power {
        exponent: 1.0,
        base,
    },
    contains: &[Contained {
        model: &phong::MODEL,
        factors: &[1.0],
        fixed: &[1.0],
    }],
};

/// Row of the normal weight c_z.
const C_Z: Param = Param {
    id: ParamId("c_z"),
    symbol: "c_{z}",
    name: "normal weight",
    unit: "",
    range: (0.0, 2.0),
    domain: (0.0, 10.0),
    bounds: (0.0, 10.0),
    at_bounds: [
        AtBound::Means("c_z went to 0: the lobe depends on the tangential components alone."),
        AtBound::Unknown,
    ],
    starts: Starts::At(&[0.4, 0.7, 1.0, 1.5]),
    default: 1.0,
    scale: Scale::Linear,
    help: "1 is Phong; below 1 the lobe leans towards the horizon and grows there, above 1 towards the normal.",
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [s, c_z, ..] = *p;
    // c_z cosθi cosθo − (wi·wo)_t is wr·wo + (c_z − 1) cosθi cosθo; 1 minus it comes from versines, for needles.
    let product = c.cos_theta_i.max(0.0) * c.cos_theta_o.max(0.0);
    let excess = c_z - 1.0;
    let base = if excess <= 0.0 {
        Cosine {
            cos: (c.wr_wo.cos + excess * product).max(0.0),
            versine: (c.wr_wo.versine - excess * product).min(1.0),
        }
    } else {
        let sin2_d = sin_squared(c.wi_wh);
        // wr·wo below 0 is clamped in its Cosine, but counts here.
        let wr_wo = if c.wr_wo.cos > 0.0 {
            c.wr_wo
        } else {
            let cos = 2.0 * product - 1.0 + 2.0 * sin2_d;
            Cosine {
                cos,
                versine: 1.0 - cos,
            }
        };
        // 1 − cosθi cosθo, since wr·wo = 2 cosθi cosθo − cos 2θd.
        let rest = 0.5 * wr_wo.versine + sin2_d;
        Cosine {
            cos: ((wr_wo.cos + excess * product) / c_z).max(0.0),
            versine: ((wr_wo.versine + excess * rest) / c_z).clamp(0.0, 1.0),
        }
    };
    base.pow(s)
}

fn base(p: &LobeValues, row: &RowAngles) -> PowerBase {
    let [_, c_z, ..] = *p;
    let mirror = row.mirror_versine();
    let product = row.product();
    let excess = c_z - 1.0;
    if excess <= 0.0 {
        return PowerBase {
            x: [
                mirror[0] - excess * product[0],
                mirror[1] + excess * product[1],
            ],
            blend: [1.0, 0.0],
            slope: [0.0, -product[0], product[1]],
        };
    }
    // 1 − cosθi cosθo is half the versine of wr·wo, plus sin²θd.
    let rest = [0.5 * mirror[0] + row.sin2_d, 0.5 * mirror[1]];
    let x = [0, 1].map(|k| (mirror[k] + excess * rest[k]) / c_z);
    PowerBase {
        x,
        blend: [1.0, 0.0],
        slope: [-1.0 / c_z, rest[0] / c_z, rest[1] / c_z],
    }
}
