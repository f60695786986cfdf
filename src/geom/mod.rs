//! Directions, half/difference angles, colour, and the lit sphere as numbers. Pure: no egui, wgpu, files, threads or clock.
//!
//! Directions live in the local frame of the surface, z = n, and are unit vectors. Angles are radians.
//! `x.wgsl` beside `x.rs` is its twin on the GPU: the same functions under the same names.

pub mod color;
pub mod cosines;
pub mod degrees;
pub mod directions;
pub mod half_diff;
pub mod limits;
pub mod sight;
pub mod sphere;
pub mod sphere_error;

pub use cosines::{Cosine, Cosines};
pub use directions::{direction, mirror};
pub use half_diff::HalfDiff;

/// Red, green and blue values; linear unless a name says otherwise.
pub type Rgb = [f64; 3];
