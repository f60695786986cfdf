//! What the tiles are set to show, as plain data: a file per view, a field of the scene each.

pub mod albedo;
pub mod error_map;
pub mod fits;
pub mod image;
pub mod landscape;
pub mod lobe3d;
pub mod lobes;
pub mod rows;
pub mod scatter;
pub mod slices;
pub mod sphere;
