//! Style: the look of a figure on paper.

use crate::figure::faults::Faults;
use crate::figure::palette::{Palette, SERIES_COLORS};
use crate::keys;
use serde::{Deserialize, Serialize};

/// Look of a figure on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Style {
    /// Width of the page in millimetres; its height follows from what is on it.
    pub width_mm: f64,
    /// Font size in points.
    pub font_pt: f64,
    /// Width of a curve in points; other lines keep their proportion to it.
    pub line_pt: f64,
    /// Colours of lines and dots.
    pub palette: Inks,
    /// Whether the names of the curves stand below the panels.
    pub legend: bool,
    /// Group of panels of a kind that have the same axis of values.
    pub same_axes: SameAxes,
    /// Whether panels are lettered (a), (b), …
    pub letters: bool,
    /// Pixels to the inch of pictures in it, and of the whole as PNG.
    pub dpi: f64,
    /// Whether the page is left clear instead of white.
    pub transparent: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            width_mm: COLUMNS[0].1,
            font_pt: 8.0,
            line_pt: 1.0,
            palette: Inks::Color,
            legend: true,
            same_axes: SameAxes::Figure,
            letters: false,
            dpi: 300.0,
            transparent: false,
        }
    }
}

/// Widths that journals use, in millimetres.
pub const COLUMNS: [(&str, f64); 2] = [("One column", 85.0), ("Two columns", 178.0)];

/// Group of panels of a kind that have the same axis of values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SameAxes {
    /// All of the figure.
    #[default]
    Figure,
    /// Panels in a row.
    Row,
    /// None: each has its own.
    Panel,
}

/// Groups in the order offered.
pub const SAME_AXES: [SameAxes; 3] = [SameAxes::Figure, SameAxes::Row, SameAxes::Panel];

impl SameAxes {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Figure => "In the figure",
            Self::Row => "In a row",
            Self::Panel => "Each its own",
        }
    }
}

/// Colours of lines and dots on paper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Inks {
    /// Colours of the window in light, told apart by colour-blind people too.
    #[default]
    Color,
    /// Greys that a black and white printer tells apart.
    Grey,
}

/// Inks in the order offered.
pub const INKS: [Inks; 2] = [Inks::Color, Inks::Grey];

impl Inks {
    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Color => "Colour-blind safe",
            Self::Grey => "Greys",
        }
    }

    /// The colours, on white.
    pub fn palette(self) -> Palette {
        let white = Palette {
            background: [255; 3],
            ..Palette::LIGHT
        };
        match self {
            Self::Color => white,
            Self::Grey => Palette {
                accent: [0x40; 3],
                series: GREYS.map(|grey| [grey; 3]),
                foreground: [0; 3],
                muted: [0x50; 3],
                faint: [0xd0; 3],
                ..white
            },
        }
    }
}

/// Neighbours differ most.
const GREYS: [u8; SERIES_COLORS] = [0x00, 0x84, 0x42, 0x94, 0x20, 0x70, 0x58];

/// Limits of what can be asked for: (key, smallest, largest).
const LIMITS: [(&str, f64, f64); 4] = [
    ("width_mm", 20.0, 2000.0),
    ("font_pt", 3.0, 72.0),
    ("line_pt", 0.05, 20.0),
    ("dpi", 30.0, 2400.0),
];

/// The smallest and the largest value of a number of the style, by its key.
pub fn style_limits(key: &str) -> Option<[f64; 2]> {
    let found = LIMITS.iter().find(|(known, ..)| *known == key)?;
    Some([found.1, found.2])
}

impl Style {
    /// Brings the numbers to the nearest that can be asked for.
    pub fn sanitize(&mut self, faults: &mut Faults) {
        let Self {
            width_mm,
            font_pt,
            line_pt,
            dpi,
            ..
        } = self;
        for ((key, low, high), value) in LIMITS.into_iter().zip([width_mm, font_pt, line_pt, dpi]) {
            faults.number(key, value, [low, high]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_out_of_range_is_named() {
        let said = |mut style: Style| {
            let mut faults = Faults::default();
            style.sanitize(&mut faults);
            (style, faults.result())
        };
        assert_eq!(said(Style::default()), (Style::default(), Ok(())));
        let wrong = Style {
            font_pt: f64::NAN,
            ..Style::default()
        };
        let (kept, said) = said(wrong);
        assert_eq!(kept.font_pt, 3.0);
        assert_eq!(said, Err("font_pt is NaN; expected 3 to 72".into()));
    }

    #[test]
    fn a_style_is_read_back_and_a_misspelt_key_is_an_error() {
        let text = serde_json::to_string(&Style::default()).expect("is written");
        let back: Style = serde_json::from_str(&text).expect("is read");
        assert_eq!(back, Style::default());
        let wrong = serde_json::from_str::<Style>(r#"{"widht_mm": 85}"#);
        assert!(
            wrong
                .expect_err("misspelt")
                .to_string()
                .contains("widht_mm")
        );
    }
}
