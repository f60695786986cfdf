//! Reflection models: `f_r = ρ_d/π + k_s · R_F(wi·wh, η) · lobe`, in 1/sr, without the cosine. Pure.
//!
//! A [`Model`] is a row of [`MODELS`]: its parameters drive sliders, bounds, uniforms, file formats and tests.
//! A new model is a file `models/x.rs`, its twin `models/x.wgsl` and a row. Twins write out the type of every `let` and `var`, since
//! [`codegen`] makes GLSL of them, and take their parameters one by one in the order of the row.

pub mod albedo;
pub mod along_phi_d;
pub mod codegen;
pub mod fresnel;
pub mod json;
mod look;
mod model;
mod models;
pub mod params;
pub mod wgsl;

pub use albedo::albedo;
pub use fresnel::Fresnel;
pub use model::{Brdf, Contained, Model};
pub use models::{BLINN_PHONG, COMBINED, MODELS, PHONG, PHONG_FAMILY};
pub use models::{all_params, param_by_key};
pub use params::{LobeValues, Param, ParamId, Params};

#[cfg(test)]
mod tests;
