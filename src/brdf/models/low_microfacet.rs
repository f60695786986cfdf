//! Löw microfacet: V-grooves whose slopes fall off as the ABC model has it, not normalised.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | B | > 0 | sharpness: 1/B is the 1 − cosθh at which the peak begins to fall |
//! | C | > 0 | falloff: the tail goes like (1 − cosθh)^(−C) |
//!
//! `lobe = (1 + B (1 − cosθh))^(−C) · G / (cosθi cosθo)` with the G of Cook-Torrance [Low12, eq. 15]; the paper's A is
//! part of k_s. The values of A in the paper's fits go with this lobe over π.
//!
//! At grazing angles it does as Cook-Torrance does: the lobe grows like 1/cos²θ in the mirror direction, with an edge
//! where the grooves begin to hide their walls. Its tail, a power and not a Gaussian, reaches further up from the
//! horizon.

use super::low_smooth;
use super::microfacet::{abc_falloff, vgroove_over_cosines};
use crate::brdf::along_phi_d::{AlongPhiD, Azimuth};
use crate::brdf::model::Model;
use crate::brdf::params::{LobeValues, Param};
use crate::geom::Cosines;

/// Row of the microfacet model of Löw et al.
pub static MODEL: Model = Model {
    key: "low-microfacet",
    name: "Löw microfacet",
    word: "Löw microfacet",
    source: "[Low12]",
    formula: "(1 + B(1 − ω_{h}·n))^{−C} G / ((ω_{i}·n)(ω_{o}·n))",
    params: &[B, low_smooth::C],
    lobe,
    wgsl: include_str!("low_microfacet.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Factor(Azimuth::VGroove),
    contains: &[],
};

/// Sharpness with eight times the default of the smooth model: |D_p|² is 8 (1 − cosθh) at normal incidence.
const B: Param = Param {
    default: 8.0 * low_smooth::B.default,
    ..low_smooth::B
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [b, falloff, ..] = *p;
    abc_falloff(b, falloff, c.wh_n.versine) * vgroove_over_cosines(c)
}
