//! A model with its numbers as text for other programs: a WGSL or a GLSL function to paste, and a Disney `.brdf` file.
//!
//! All of them are put together from the WGSL twins: the functions that this model and this Fresnel factor need, and
//! no others. GLSL is the same text translated word by word. A new model needs nothing here.

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
