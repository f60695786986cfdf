//! Subjects of a plot, whose f_r it shows, and their look: measurements, models and fits.

use crate::brdf::{Brdf, Model};
use crate::geom::{Rgb, color::luminance};
use crate::keys;
use crate::measured::Table;
use crate::measured::lookup::Lookup;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// Channel of a colour that is plotted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Channel {
    /// Relative luminance with the Rec. 709 primaries.
    #[default]
    Luminance,
    /// Red.
    R,
    /// Green.
    G,
    /// Blue.
    B,
}

/// All channels in the order offered.
pub const CHANNELS: [Channel; 4] = [Channel::Luminance, Channel::R, Channel::G, Channel::B];

impl Channel {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Luminance => "luminance",
            Self::R => "red",
            Self::G => "green",
            Self::B => "blue",
        }
    }

    /// The channel whose key this is.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }

    /// Value of a linear RGB colour in this channel.
    pub fn of(self, rgb: Rgb) -> f64 {
        match self {
            Self::Luminance => luminance(rgb),
            Self::R => rgb[0],
            Self::G => rgb[1],
            Self::B => rgb[2],
        }
    }
}

/// f_r of (wi, wo) in 1/sr; `None` where it has no value.
pub type Function = dyn Fn(DVec3, DVec3) -> Option<Rgb> + Send + Sync;

/// Source of the values of a subject. Cheap to copy.
#[derive(Clone)]
pub enum Source {
    /// A measured table.
    Measured(Arc<Table>, Lookup),
    /// A model with its parameters.
    Model(Brdf),
    /// Anything else.
    Function(Arc<Function>),
}

impl Source {
    /// f_r of (wi, wo) in 1/sr; `None` below the horizon and where nothing was measured.
    pub fn f_r(&self, wi: DVec3, wo: DVec3) -> Option<Rgb> {
        match self {
            Self::Measured(table, lookup) => table.lookup(wi, wo, *lookup),
            Self::Model(brdf) => brdf.f_r(wi, wo),
            Self::Function(function) => function(wi, wo),
        }
    }
}

impl PartialEq for Source {
    /// Tables and functions are equal where they are the same one in memory.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Measured(a, by), Self::Measured(b, other_by)) => {
                Arc::ptr_eq(a, b) && by == other_by
            }
            (Self::Model(a), Self::Model(b)) => a == b,
            (Self::Function(a), Self::Function(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

impl fmt::Debug for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Measured(table, lookup) => {
                write!(f, "Measured({} valid, {lookup:?})", table.valid_count())
            }
            Self::Model(brdf) => write!(f, "Model({brdf:?})"),
            Self::Function(_) => write!(f, "Function"),
        }
    }
}

/// Look of the lines of a subject; in the order in which they are drawn over each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Look {
    /// Solid.
    Measured,
    /// A fit beside the model, thinner: dotted, or with long dashes.
    Beside {
        /// Whether the dashes are long, which tells two kinds of models apart.
        long: bool,
    },
    /// One of several models over the first measurement, in a colour of its own: dashed.
    Dashed,
    /// Dashed.
    Model,
}

impl Look {
    /// Dash and gap in points; `None` for solid.
    pub fn dash(self) -> Option<[f32; 2]> {
        match self {
            Self::Measured => None,
            Self::Model | Self::Dashed => Some([6.0, 3.5]),
            Self::Beside { long: false } => Some([1.6, 2.8]),
            Self::Beside { long: true } => Some([12.0, 4.0]),
        }
    }

    /// Width of a line in points.
    pub fn width(self) -> f32 {
        match self {
            Self::Measured | Self::Model | Self::Dashed => 2.0,
            Self::Beside { .. } => 1.6,
        }
    }
}

/// Hues that differ clearly from each other and from the first, which is that of the data.
const HUES: [usize; 4] = [1, 2, 3, 4];
/// Dashes that models of one hue are told apart by.
const DASHES: [Look; 3] = [
    Look::Model,
    Look::Beside { long: false },
    Look::Beside { long: true },
];

/// The colour and the look of a model's curve where several models are over one material, whose series is 0: no two models
/// have the same of both.
pub fn model_line(model: &Model) -> (usize, Look) {
    let index = model.index();
    let dash = DASHES[index / HUES.len() % DASHES.len()];
    (HUES[index % HUES.len()], dash)
}

/// A BRDF to plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// Name in the legend.
    pub label: String,
    /// Measurement or model.
    pub look: Look,
    /// The material it belongs to, which gives the colour; of a fit beside it, its own
    /// [`super::palette::companion`].
    pub series: usize,
    /// Whether only its name in the legend is shown, greyed.
    pub hidden: bool,
    /// Source of the values.
    pub source: Source,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::{MODELS, PHONG_FAMILY};
    use crate::figure::palette::SERIES_COLORS;

    /// Pairs of lines that look the same.
    fn alike(lines: &[(usize, Look)]) -> usize {
        let seen = |(series, look): &(usize, Look)| (series % SERIES_COLORS, *look);
        let pairs = lines.iter().enumerate();
        pairs
            .map(|(k, line)| lines[..k].iter().filter(|other| seen(other) == seen(line)))
            .map(Iterator::count)
            .sum()
    }

    #[test]
    fn lines_of_all_models_and_of_the_data_can_be_told_apart() {
        let mut lines: Vec<_> = MODELS.iter().map(|model| model_line(model)).collect();
        lines.push((0, Look::Measured));
        assert_eq!(alike(&lines), 0);
        // Planted: colours alone come again.
        let colors: Vec<_> = (0..MODELS.len()).map(|k| (1 + k, Look::Model)).collect();
        assert!(alike(&colors) > 0);
        // As every poster has had them.
        let family = PHONG_FAMILY.iter().map(|model| model_line(model));
        assert!(family.eq((1..=3).map(|series| (series, Look::Model))));
    }
}
