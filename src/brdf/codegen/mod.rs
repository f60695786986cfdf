//! Export of a model with its parameters as text for other programs: a WGSL or a GLSL function to paste, and a Disney
//! `.brdf` file.
//!
//! Each is put together from the WGSL twins: the functions that this model and this Fresnel factor need, and no others.
//! GLSL is the same text translated token by token. A new model needs nothing here.

mod disney;
mod glsl;
mod items;
mod parts;
mod wgsl;

pub use disney::disney;
pub use glsl::glsl;
pub use wgsl::wgsl;

#[cfg(test)]
mod tests;
