//! The combined model: between Phong and Blinn-Phong.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | ρ_d, k_s | ≥ 0 | diffuse reflectance, specular amplitude |
//! | s | > 0 | specular exponent |
//! | α | [0, 1] | 0 is Phong, 1 is Blinn-Phong with exponent 4s |
//!
//! `f_r = ρ_d/π + k_s ((1−α)(wr·wo) + α(wh·n)^4)^s` [Nielsen14]. The fourth power gives both cosines the same
//! curvature at the peak under normal incidence, where wh turns half as far as wo, so that α changes the
//! highlight at grazing angles and leaves the one seen from above.

use crate::brdf::model::Model;
use crate::brdf::params::{self, Params};
use crate::geom::{Cosine, Cosines};

/// Row of the combined model.
pub static MODEL: Model = Model {
    key: "combined",
    name: "Combined",
    source: "[Nielsen14], the poster's new model",
    formula: "((1 − α)(ω_{r}·ω_{o}) + α(ω_{h}·n)^{4})^{s}",
    params: &[
        params::RHO_D,
        params::K_S,
        params::S,
        params::ALPHA,
        params::ETA,
    ],
    lobe,
    wgsl: include_str!("combined.wgsl"),
    normalization: None,
    exponent_ratio: 1.0,
    alpha: None,
};

fn lobe(p: &Params, c: &Cosines) -> f64 {
    Cosine {
        cos: (1.0 - p.alpha) * c.wr_wo.cos + p.alpha * c.wh_n.cos.powi(4),
        versine: (1.0 - p.alpha) * c.wr_wo.versine + p.alpha * versine_pow4(c.wh_n.versine),
    }
    .pow(p.s)
}

/// 1 − cos⁴ from 1 − cos, without cancellation.
fn versine_pow4(x: f64) -> f64 {
    x * (4.0 - x * (6.0 - x * (4.0 - x)))
}
