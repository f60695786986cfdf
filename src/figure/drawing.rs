//! A drawing as data: lines, fills, dots and text in points, y downwards from the upper left corner.
//!
//! The painter on screen and the writers of files walk the same items, in order, later over earlier. Colours are
//! roles until a [`super::Palette`] resolves them.

use super::palette::Ink;
use super::text::RichText;
use std::sync::Arc;

/// A position in points, x to the right and y down.
pub type Point = [f32; 2];

/// A picture of a known size.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Width and height in points. Items stay inside.
    pub size: [f32; 2],
    /// Painted in this order.
    pub items: Vec<Item>,
}

/// One thing that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// An open polyline.
    Line {
        /// Corners of the line; at least two.
        points: Vec<Point>,
        /// Width in points.
        width: f32,
        /// Lengths of dash and gap in points; solid without.
        dash: Option<[f32; 2]>,
        /// Colour of the line.
        ink: Ink,
    },
    /// A filled convex polygon.
    Fill {
        /// Corners of the polygon, in either sense.
        points: Vec<Point>,
        /// Fill colour.
        ink: Ink,
    },
    /// A filled circle.
    Dot {
        /// Middle of the disc.
        center: Point,
        /// Radius in points, up to the middle of the outline.
        radius: f32,
        /// Colour of the inside.
        ink: Ink,
        /// Width in points and colour of its rim, if any.
        outline: Option<(f32, Ink)>,
    },
    /// One line of text.
    Text(Label),
    /// A picture made of pixels.
    Image(Picture),
}

/// A picture made of pixels, and where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Upper left corner.
    pub min: Point,
    /// Lower right corner.
    pub max: Point,
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Four bytes per pixel from the upper left, row by row: sRGB and opacity, not multiplied.
    pub rgba: Arc<[u8]>,
    /// Whether pixels run into one another where they are drawn larger, or have edges.
    pub smooth: bool,
}

impl Picture {
    /// Whether there are pixels, and as many as it says.
    pub fn is_whole(&self) -> bool {
        !self.rgba.is_empty() && self.rgba.len() == 4 * self.width * self.height
    }
}

/// One line of text and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Words of the label.
    pub text: RichText,
    /// Position of the anchor in points.
    pub pos: Point,
    /// The part of the text that is at `pos`, and that it turns about.
    pub anchor: Anchor,
    /// Clockwise turn in radians.
    pub angle: f32,
    /// Font size in points.
    pub size: f32,
    /// Colour of the letters.
    pub ink: Ink,
    /// Whether lines behind it are covered with a patch of the background.
    pub halo: bool,
}

/// Part of a text that is at its position: `x` and `y` are 0 at its left and top, 0.5 in its middle, 1 at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Share of the width, from left (0) to right (1).
    pub x: f32,
    /// Share of the height, from top (0) to bottom (1).
    pub y: f32,
}

impl Anchor {
    /// The middle of the text.
    pub const CENTER: Self = Self { x: 0.5, y: 0.5 };
    /// The middle of its left end.
    pub const LEFT: Self = Self { x: 0.0, y: 0.5 };
    /// The middle of its right end.
    pub const RIGHT: Self = Self { x: 1.0, y: 0.5 };
    /// The middle of its top.
    pub const TOP: Self = Self { x: 0.5, y: 0.0 };

    /// The part of the text that is nearest to what it names, if that is in the direction (`dx`, `dy`) from it:
    /// text outside a circle stands on its side.
    pub fn towards(dx: f32, dy: f32) -> Self {
        Self {
            x: 0.5 + 0.5 * dx,
            y: 0.5 + 0.5 * dy,
        }
    }
}

/// Font size of a plot in points: grows with the plot, within what is easy to read.
pub fn font_size([width, height]: [f32; 2]) -> f32 {
    (width.min(1.4 * height) / 38.0).clamp(SMALLEST_FONT, LARGEST_FONT)
}

/// Font size of small plots in points.
pub const SMALLEST_FONT: f32 = 9.5;
/// Font size of large plots in points.
pub const LARGEST_FONT: f32 = 14.0;

/// Height of a line of text in units of its font size.
pub const LINE_HEIGHT: f32 = 1.25;

impl Label {
    /// A level text without a halo; its size is in points.
    pub fn new(text: RichText, pos: Point, anchor: Anchor, size: f32, ink: impl Into<Ink>) -> Self {
        Self {
            text,
            pos,
            anchor,
            angle: 0.0,
            size,
            ink: ink.into(),
            halo: false,
        }
    }

    /// Estimated bounding box (upper left, lower right) of the text before it is turned.
    pub fn bounds(&self) -> [Point; 2] {
        let (w, h) = (self.size * self.text.width_em(), self.size * LINE_HEIGHT);
        let min = [
            self.pos[0] - self.anchor.x * w,
            self.pos[1] - self.anchor.y * h,
        ];
        [min, [min[0] + w, min[1] + h]]
    }
}

impl Drawing {
    /// An empty drawing.
    pub fn new(size: [f32; 2]) -> Self {
        Self {
            size,
            items: Vec::new(),
        }
    }

    /// Adds a solid polyline; nothing if it has fewer than two points.
    pub fn line(&mut self, points: Vec<Point>, width: f32, ink: Ink) {
        self.dashed_line(points, width, None, ink);
    }

    /// Adds a polyline, dashed where `dash` says so; nothing if it has fewer than two points.
    pub fn dashed_line(
        &mut self,
        points: Vec<Point>,
        width: f32,
        dash: Option<[f32; 2]>,
        ink: Ink,
    ) {
        if points.len() >= 2 {
            self.items.push(Item::Line {
                points,
                width,
                dash,
                ink,
            });
        }
    }

    /// Adds a convex polygon.
    pub fn fill(&mut self, points: Vec<Point>, ink: Ink) {
        self.items.push(Item::Fill { points, ink });
    }

    /// Adds a line with a filled head at `tip`, `head` points long.
    pub fn arrow(&mut self, tail: Point, tip: Point, width: f32, head: f32, ink: Ink) {
        let (dx, dy) = (tip[0] - tail[0], tip[1] - tail[1]);
        let length = dx.hypot(dy);
        if length <= head {
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let base = [tip[0] - head * ux, tip[1] - head * uy];
        let half = 0.36 * head;
        self.line(vec![tail, base], width, ink);
        self.fill(
            vec![
                tip,
                [base[0] - half * uy, base[1] + half * ux],
                [base[0] + half * uy, base[1] - half * ux],
            ],
            ink,
        );
    }

    /// Labels of the drawing, in order.
    pub fn labels(&self) -> impl Iterator<Item = &Label> {
        self.items.iter().filter_map(|item| match item {
            Item::Text(label) => Some(label),
            _ => None,
        })
    }
}
