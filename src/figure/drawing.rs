//! A drawing: lines, fills and text in points, y down, with colours as roles. Screen and paper walk the same one.

use super::text::RichText;

/// Position in points from the upper left corner, y down.
pub type Point = [f32; 2];

/// What a colour is for. A [`Palette`] says what it looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Text and vectors.
    Foreground,
    /// Labels of axes.
    Muted,
    /// Grids and shades.
    Faint,
    /// The ground, for halos.
    Background,
    /// The probe.
    Accent,
    /// The data set with this number.
    Series(usize),
}

/// A role with an opacity in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ink {
    /// What for.
    pub role: Role,
    /// How much.
    pub opacity: f32,
}

impl Role {
    /// Fully opaque.
    pub fn ink(self) -> Ink {
        self.with_opacity(1.0)
    }

    /// With an opacity.
    pub fn with_opacity(self, opacity: f32) -> Ink {
        Ink {
            role: self,
            opacity,
        }
    }
}

/// Where a text stands relative to its position: 0 is left or top, 0.5 the middle, 1 right or bottom.
pub type Anchor = [f32; 2];

/// A part of a drawing, in painting order.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// An open polyline.
    Line {
        /// At least two.
        points: Vec<Point>,
        /// In points.
        width: f32,
        /// Dashed or solid.
        dashed: bool,
        /// Colour.
        ink: Ink,
    },
    /// A convex polygon.
    Fill {
        /// At least three.
        points: Vec<Point>,
        /// Colour.
        ink: Ink,
    },
    /// A disc.
    Dot {
        /// Its centre.
        center: Point,
        /// In points.
        radius: f32,
        /// Colour.
        ink: Ink,
    },
    /// A line of text.
    Text {
        /// Where the anchor is.
        position: Point,
        /// Which part of the text is there.
        anchor: Anchor,
        /// Font size in points.
        size: f32,
        /// What it says.
        text: RichText,
        /// Colour.
        ink: Ink,
        /// Whether the ground is painted behind it, so that lines do not run through.
        halo: bool,
    },
}

/// A finished drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Width and height in points.
    pub size: [f32; 2],
    /// Back to front.
    pub items: Vec<Item>,
}

impl Drawing {
    /// Adds a polyline; one with fewer than two points is nothing.
    pub fn line(&mut self, points: Vec<Point>, width: f32, ink: Ink) {
        self.stroke(points, width, false, ink);
    }

    /// Adds a polyline that may be dashed.
    pub fn stroke(&mut self, points: Vec<Point>, width: f32, dashed: bool, ink: Ink) {
        if points.len() > 1 {
            self.items.push(Item::Line {
                points,
                width,
                dashed,
                ink,
            });
        }
    }

    /// Adds a text.
    pub fn text(&mut self, position: Point, anchor: Anchor, size: f32, markup: &str, ink: Ink) {
        self.push_text(position, anchor, size, markup, ink, false);
    }

    /// Adds a text with the ground behind it.
    pub fn text_on_ground(
        &mut self,
        position: Point,
        anchor: Anchor,
        size: f32,
        markup: &str,
        ink: Ink,
    ) {
        self.push_text(position, anchor, size, markup, ink, true);
    }

    fn push_text(
        &mut self,
        position: Point,
        anchor: Anchor,
        size: f32,
        markup: &str,
        ink: Ink,
        halo: bool,
    ) {
        self.items.push(Item::Text {
            position,
            anchor,
            size,
            text: RichText::parse(markup),
            ink,
            halo,
        });
    }
}

/// The colours of the roles, as 8-bit sRGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Text and vectors.
    pub foreground: [u8; 3],
    /// Labels of axes.
    pub muted: [u8; 3],
    /// Grids and shades.
    pub faint: [u8; 3],
    /// The ground.
    pub background: [u8; 3],
    /// The probe.
    pub accent: [u8; 3],
    /// Data sets, told apart also by colour-blind people (after Okabe and Ito), taken in turn.
    pub series: [[u8; 3]; 7],
}

/// For a light window.
pub const LIGHT: Palette = Palette {
    foreground: [30, 30, 34],
    muted: [96, 96, 102],
    faint: [150, 150, 158],
    background: [248, 248, 248],
    accent: [200, 30, 90],
    series: [
        [0, 104, 168],
        [196, 84, 0],
        [0, 128, 94],
        [178, 84, 140],
        [140, 108, 0],
        [20, 130, 185],
        [70, 70, 76],
    ],
};

/// For a dark window.
pub const DARK: Palette = Palette {
    foreground: [232, 232, 236],
    muted: [160, 160, 168],
    faint: [110, 110, 118],
    background: [27, 27, 27],
    accent: [255, 110, 160],
    series: [
        [86, 180, 233],
        [240, 150, 40],
        [40, 190, 140],
        [220, 140, 190],
        [240, 228, 66],
        [120, 160, 255],
        [200, 200, 206],
    ],
};

impl Palette {
    /// The colour of a role.
    pub fn color(&self, role: Role) -> [u8; 3] {
        match role {
            Role::Foreground => self.foreground,
            Role::Muted => self.muted,
            Role::Faint => self.faint,
            Role::Background => self.background,
            Role::Accent => self.accent,
            Role::Series(index) => self.series[index % self.series.len()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::color::{luminance, srgb_decode};

    /// Contrast ratio after WCAG.
    fn contrast(a: [u8; 3], b: [u8; 3]) -> f64 {
        let y = |c: [u8; 3]| luminance(c.map(|x| srgb_decode(f64::from(x) / 255.0))) + 0.05;
        let (a, b) = (y(a), y(b));
        a.max(b) / a.min(b)
    }

    #[test]
    fn every_series_and_label_can_be_read() {
        for palette in [LIGHT, DARK] {
            for color in palette.series.into_iter().chain([
                palette.foreground,
                palette.muted,
                palette.accent,
            ]) {
                assert!(
                    contrast(color, palette.background) > 3.0,
                    "{color:?} on {:?}",
                    palette.background
                );
            }
        }
        assert!(
            contrast(LIGHT.series[4], DARK.series[4]) > 2.0,
            "the measure can tell colours apart"
        );
    }
}
