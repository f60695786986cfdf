//! The models: a file with the lobe and its row for each, beside its WGSL twin.

mod blinn_phong;
mod combined;
mod exponent;
mod phong;

use super::model::Model;

pub use blinn_phong::MODEL as BLINN_PHONG;
pub use combined::MODEL as COMBINED;
pub use phong::MODEL as PHONG;

/// All models, in the order in which they are offered.
pub static MODELS: &[&Model] = &[&PHONG, &BLINN_PHONG, &COMBINED];

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
