//! Drawings as files: SVG, PDF and pixels. Bytes come out; nothing is read but the font that is compiled in.
//!
//! ```text
//! Paper (Drawing, Palette, ground) ──▶ svg ──▶ pixels ──▶ PNG
//!                                  └─▶ pdf
//! ```
//!
//! Text is placed by the same metrics ([`font`]) in all of them, so that no format differs from another. The same paper
//! gives the same bytes.

pub mod font;
pub mod pdf;
pub mod raster;
pub mod recipe;
pub mod svg;

use super::drawing::Drawing;
use super::palette::Palette;
use font::FallbackFont;

/// A drawing with what it is printed on.
#[derive(Clone, Debug, PartialEq)]
pub struct Paper {
    /// Drawing in points of print: 72 to the inch.
    pub drawing: Drawing,
    /// Colours of the roles.
    pub palette: Palette,
    /// sRGB of the page; transparent without.
    pub ground: Option<[u8; 3]>,
    /// Fonts that stand in for letters that the font of figures lacks.
    pub fallback: Vec<FallbackFont>,
    /// One line for whoever looks at the file's properties or has it read out.
    pub title: String,
    /// The spec that draws it again, as text for the metadata; none without.
    pub recipe: Option<String>,
}

/// Points of print in a millimetre.
pub const POINTS_PER_MM: f64 = 72.0 / 25.4;

/// Creator that is named in a file.
pub(crate) const CREATOR: &str = concat!("Grazing ", env!("CARGO_PKG_VERSION"));

#[cfg(test)]
mod tests;
