//! Löw smooth: what scattering by small bumps on a smooth surface leaves around the mirror direction.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | B | > 0 | sharpness: 1/√B is the distance at which the peak begins to fall |
//! | C | > 0 | falloff: the tail goes like distance^(−2C) |
//!
//! `lobe = (1 + B |D_p|²)^(−C)`, where D_p is the tangential part of wi + wo [Low12, eq. 10, 12]; the paper's A is part
//! of k_s. There the Fresnel factor takes `cosθ = √(1 − |tangential part of wi − wo|²/4)` (eq. 14), here θd as in all
//! models; in the mirror direction the two are the same.
//!
//! At grazing angles the lobe has the same shape in projection at every angle of incidence, 1 in the mirror direction:
//! on the sphere it stretches along the plane of incidence towards the horizon, as polished surfaces do. It never leans
//! and never grows; only the Fresnel factor lifts it. The albedo falls to about a half, since the horizon cuts the
//! lobe.

use super::microfacet::{abc_falloff, sin_squared};
use crate::brdf::along_phi_d::{AlongPhiD, Azimuth};
use crate::brdf::model::Model;
use crate::brdf::params::{AtBound, LobeValues, Param, ParamId, Scale, Starts};
use crate::geom::Cosines;

/// Row of the smooth model of Löw et al.
pub static MODEL: Model = Model {
    key: "low-smooth",
    name: "Löw smooth",
    word: "Löw smooth",
    source: "[Low12]",
    formula: "(1 + B|D_{p}|²)^{−C}",
    params: &[B, C],
    lobe,
    wgsl: include_str!("low_smooth.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Factor(Azimuth::Constant),
    contains: &[],
};

/// Row of the sharpness B.
pub(super) const B: Param = Param {
    id: ParamId("b"),
    symbol: "B",
    name: "sharpness",
    unit: "",
    range: (1.0, 1e7),
    domain: (1e-3, 1e9),
    bounds: (1.0, 1e7),
    at_bounds: [AtBound::Unknown; 2],
    starts: Starts::PerDecade(2.0),
    default: 25.0,
    scale: Scale::Log {
        smallest_exponent: 0,
    },
    help: "The larger, the narrower the peak of the highlight.",
};

/// Row of the falloff C.
pub(super) const C: Param = Param {
    id: ParamId("c"),
    symbol: "C",
    name: "falloff",
    unit: "",
    range: (0.01, 10.0),
    domain: (1e-3, 100.0),
    bounds: (0.01, 10.0),
    at_bounds: [AtBound::Unknown; 2],
    starts: Starts::At(&[0.1, 0.5, 1.5, 5.0]),
    default: 1.2,
    scale: Scale::Log {
        smallest_exponent: -2,
    },
    help: "The larger, the shorter the tail of the highlight.",
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [b, falloff, ..] = *p;
    // wi + wo is 2 cosθd long and points to wh.
    let deviation = 4.0 * c.wi_wh.cos * c.wi_wh.cos * sin_squared(c.wh_n);
    abc_falloff(b, falloff, deviation)
}
