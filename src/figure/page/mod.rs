//! Figures for papers: a page of panels as data, and from it a drawing and the numbers in it.
//!
//! ```text
//! PageSpec (rows, views, style) + subjects + Made ── draw ──▶ Page: Paper, a Table per panel
//! ```
//!
//! A panel is the same drawing that the window shows, at the size at which its text has the wanted font size.

mod draw;
mod lock;
mod panel;
mod place;
mod spec;
mod sphere;
mod style;

pub use draw::{Page, draw};
pub use spec::{
    ErrorMapSpec, LandscapePanel, Lobe3dSpec, PageSpec, PanelSpec, RowSpec, SphereShow, SphereSpec,
    ViewSpec,
};
pub use sphere::only_sphere;
pub use style::{COLUMNS, INKS, Inks, SAME_AXES, SameAxes, Style};

use super::landscape::Terrain;
use crate::geom::Rgb;

/// What a panel shows and drawing cannot compute: results of fitting.
#[derive(Clone, Debug, PartialEq)]
pub enum Made {
    /// Of a landscape.
    Landscape {
        /// E in percent.
        terrain: Terrain,
        /// The best (s, α) and its E in percent.
        best: Option<([f64; 2], f64)>,
    },
    /// Of an error map.
    ErrorMap {
        /// Parts of E in rows from the smallest angle upwards; `None` where no cell counts.
        parts: Vec<Option<f64>>,
        /// Parts in a row.
        columns: usize,
        /// E.
        total: f64,
        /// E per channel.
        channels: Rgb,
    },
}

#[cfg(test)]
mod tests;
