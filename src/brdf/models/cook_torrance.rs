//! Cook-Torrance: microfacets with Beckmann's slopes that lie in V-shaped grooves.
//!
//! | parameter | range | meaning |
//! |---|---|---|
//! | m | > 0 | roughness: root mean square slope of the grooves |
//!
//! `lobe = D(wh) G / (4 cosθi cosθo)`, `D = exp(−tan²θh/m²) / (π m² cos⁴θh)`,
//! `G = min(1, 2 cosθh cosθi/cosθd, 2 cosθh cosθo/cosθd)` [CookTorrance82], as fitted by [Ngan05]. The paper has 1/π in
//! place of 1/4 and no π in D: its lobe is 4 times this one, so that its k_s is a quarter of k_s here.
//!
//! At grazing angles a groove begins to hide its own walls only from a certain angle on: up to there G is 1 and the
//! cosines in the denominator lift the highlight, from there on G falls, with an edge in between that can be seen.
//! In the mirror direction the lobe grows like 1/cos²θ, without end, since a flat facet is never hidden in its groove;
//! the albedo stays below 1 all the same, since that peak becomes narrow.

use super::microfacet;
use crate::brdf::along_phi_d::{AlongPhiD, Azimuth};
use crate::brdf::model::Model;
use crate::brdf::params::{LobeValues, Param};
use crate::geom::Cosines;

/// Row of the Cook-Torrance model.
pub static MODEL: Model = Model {
    key: "cook-torrance",
    name: "Cook-Torrance",
    word: "Cook-Torrance",
    source: "[CookTorrance82], as fitted by [Ngan05]",
    formula: "exp(−tan²θ_{h}/m²) G / (4π m² cos^{4}θ_{h} cosθ_{i} cosθ_{o})",
    params: &[ROUGHNESS],
    lobe,
    wgsl: include_str!("cook_torrance.wgsl"),
    normalization: None,
    along_phi_d: AlongPhiD::Factor(Azimuth::VGroove),
    contains: &[],
};

/// The roughness under the symbol of the source.
const ROUGHNESS: Param = Param {
    symbol: "m",
    ..microfacet::ROUGHNESS
};

fn lobe(p: &LobeValues, c: &Cosines) -> f64 {
    let [roughness, ..] = *p;
    0.25 * microfacet::beckmann_d(roughness, c.wh_n) * microfacet::vgroove_over_cosines(c)
}
