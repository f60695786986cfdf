//! The views: a folder each, with its settings, its ui and what it computes in the background; [`rows`] is their table.

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
