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
