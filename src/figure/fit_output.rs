//! Results of fitting, as a panel takes them.

use super::landscape::terrain::Terrain;
use crate::geom::Rgb;

/// Results of fitting that a panel shows and that drawing does not compute.
#[derive(Clone, Debug, PartialEq)]
pub enum FitOutput {
    /// Terrain of a landscape panel.
    Landscape {
        /// E in percent.
        terrain: Terrain,
        /// The best (s, α) and its E in percent.
        best: Option<([f64; 2], f64)>,
    },
    /// Shares of an error map.
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
