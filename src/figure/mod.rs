//! What is drawn, as data: a spec and its curves become a [`Drawing`], which the painter and the writers walk. Pure.
//!
//! A new figure is a file that builds a `Drawing`; a new format is a file that walks one.

pub mod albedo;
pub mod colormap;
pub mod contour;
pub mod drawing;
pub mod error_map;
pub mod heatmap;
pub mod image_slice;
pub mod landscape;
pub mod legend;
pub mod lobe3d;
pub mod lobes;
pub mod mark;
pub mod page;
pub mod palette;
mod placing;
pub mod plot;
mod polyline;
pub mod samples;
pub mod scale;
pub mod scatter;
pub mod slices;
pub mod sphere_image;
pub mod subject;
pub mod table;
pub mod text;
pub mod trace;
pub mod write;

pub use drawing::{Anchor, Drawing, Item, Label, Point};
pub use legend::LegendEntry;
pub use lobes::{LobePlot, LobeSpec};
pub use mark::Mark;
pub use palette::{Ink, Palette, Role};
pub use scale::{Axis, RadialScale};
pub use sphere_image::sphere_image;
pub use subject::{Channel, Look, Source, Subject};
pub use text::RichText;
