//! What the tiles are set to show, as plain data: a file per view, a field of the scene each.

pub mod albedo;
pub mod background;
pub mod error_map;
pub mod image;
pub mod landscape;
pub mod lobe3d;
pub mod scatter;
pub mod sight;
pub mod slices;

pub use albedo::AlbedoView;
pub use error_map::ErrorMapView;
pub use image::ImageView;
pub use landscape::LandscapeView;
pub use lobe3d::Lobe3dView;
pub use scatter::ScatterView;
pub use sight::Sight;
pub use slices::SlicesView;
