//! The models: a file with the lobe and its row for each, beside its WGSL twin.

mod ashikhmin_shirley;
mod beckmann;
mod blinn_phong;
mod combined;
mod cook_torrance;
mod exponent;
mod ggx;
mod lafortune;
mod low_microfacet;
mod low_smooth;
mod microfacet;
mod phong;
mod ward;
mod ward_duer;

use super::model::Model;
use super::params::{ETA, K_S, Param, ParamId, RHO_D};
use std::sync::LazyLock;

pub use blinn_phong::MODEL as BLINN_PHONG;
pub use combined::MODEL as COMBINED;
pub use phong::MODEL as PHONG;

/// All models, in the order in which they are offered: the Phong family first.
pub static MODELS: &[&Model] = &[
    &PHONG,
    &BLINN_PHONG,
    &COMBINED,
    &lafortune::MODEL,
    &ashikhmin_shirley::MODEL,
    &ggx::MODEL,
    &beckmann::MODEL,
    &cook_torrance::MODEL,
    &ward::MODEL,
    &ward_duer::MODEL,
    &low_smooth::MODEL,
    &low_microfacet::MODEL,
];

/// The models of the poster [Nielsen14].
pub static PHONG_FAMILY: &[&Model] = &[&PHONG, &BLINN_PHONG, &COMBINED];

impl Model {
    /// The model with this `key`.
    pub fn by_key(key: &str) -> Option<&'static Self> {
        MODELS.iter().copied().find(|model| model.key == key)
    }

    /// Index in [`MODELS`], which is the model's number on the GPU.
    pub fn index(&self) -> usize {
        MODELS.iter().position(|model| *model == self).unwrap_or(0)
    }
}

/// Rows of all parameters of all models: ρ_d, k_s, those of the lobes in the order in which models first have them, η.
///
/// Where several models have a parameter, its row is that of the first of them; ranges of others may differ.
pub fn all_params() -> impl Iterator<Item = &'static Param> + Clone {
    static ROWS: LazyLock<Vec<&'static Param>> = LazyLock::new(|| {
        let mut rows = vec![&RHO_D, &K_S];
        for row in MODELS.iter().flat_map(|model| model.params) {
            if !rows.iter().any(|known| known.id == row.id) {
                rows.push(row);
            }
        }
        rows.push(&ETA);
        rows
    });
    ROWS.iter().copied()
}

/// Identity of the parameter with this key; `None` where no model has such a parameter.
pub fn param_by_key(key: &str) -> Option<ParamId> {
    all_params().find(|row| row.key() == key).map(|row| row.id)
}
