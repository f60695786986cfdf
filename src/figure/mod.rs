//! Figures as data: a spec and its curves become a [`Drawing`], which the painter and the writers walk. Pure.
//!
//! A new view is a folder that builds a `Drawing`, and a line of the list at the end; a new format is a file that walks a
//! `Drawing`.

pub mod albedo;
pub mod colormap;
pub mod contour;
pub mod cosine;
pub mod disc;
pub mod drawing;
pub mod error_map;
pub mod faults;
pub mod fit_output;
pub mod heatmap;
pub mod image_slice;
pub mod landscape;
pub mod legend;
pub mod lobe3d;
pub mod lobes;
pub mod mark;
mod over_colors;
pub mod page;
pub mod palette;
pub mod panel;
mod placing;
pub mod plot;
mod polyline;
pub mod ranking;
pub mod samples;
pub mod scale;
pub mod scatter;
pub mod shown;
pub mod slices;
pub mod sphere_image;
pub mod subject;
pub mod table;
pub mod text;
pub mod trace;
mod view_list;
pub mod write;

pub use cosine::CosineFactor;
pub use drawing::{Anchor, Drawing, Item, Label, Point};
pub use legend::LegendEntry;
pub use lobes::{LobePlot, LobeSpec};
pub use mark::ProbeMark;
pub use palette::{Ink, Palette, Role};
pub use scale::{Axis, RadialScale};
pub use sphere_image::sphere_image;
pub use subject::{Channel, Look, Source, Subject};
pub use text::RichText;

use albedo::AlbedoSpec;
use disc::DiscSpec;
use error_map::ErrorMapSpec;
use image_slice::ImageSpec;
use landscape::LandscapePanel;
use lobe3d::Lobe3dSpec;
use ranking::RankingSpec;
use scatter::ScatterSpec;
use slices::SliceSpec;
use sphere_image::SphereSpec;

view_list::view_list! {
    /// A lit sphere.
    Sphere(SphereSpec),
    /// Polar lobes in the plane of incidence.
    Lobes(LobeSpec),
    /// f_r over one angle.
    Slices(SliceSpec),
    /// f_r over θh and θd.
    ImageSlice(ImageSpec),
    /// Albedo over θi.
    Albedo(AlbedoSpec),
    /// Lobes in space.
    Lobe3d(Lobe3dSpec),
    /// f_r over all view directions under one light.
    Disc(DiscSpec),
    /// Shares of E over directions.
    ErrorMap(ErrorMapSpec),
    /// Least E over s and α.
    Landscape(LandscapePanel),
    /// Models by two of their quantities.
    Scatter(ScatterSpec),
    /// E of models over materials.
    Ranking(RankingSpec),
}
