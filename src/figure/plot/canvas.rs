//! A drawing in the making: lines with a pen, texts that keep out of each other's way.

use super::outline::Pen;
use crate::figure::drawing::{Anchor, Drawing, Item, Label, Point};
use crate::figure::palette::Role;
use crate::figure::placing::Placing;
use crate::figure::polyline::thinned;
use crate::figure::text::RichText;

/// A drawing and its texts.
pub struct PlotCanvas {
    pub drawing: Drawing,
    pub placing: Placing,
    /// Size of all texts in points.
    pub font: f32,
}

impl PlotCanvas {
    pub fn new(size: [f32; 2], font: f32) -> Self {
        Self {
            drawing: Drawing::new(size),
            placing: Placing::default(),
            font,
        }
    }

    /// A text in the size of the canvas, without a halo.
    pub fn label(&self, text: RichText, pos: Point, anchor: Anchor, role: Role) -> Label {
        Label::new(text, pos, anchor, self.font, role)
    }

    /// A text that has a place of its own.
    pub fn text(&mut self, text: RichText, pos: Point, anchor: Anchor, role: Role) {
        let label = self.label(text, pos, anchor, role);
        self.placing.place(&mut self.drawing, label);
    }

    /// The name of an axis: numbers keep half a letter off its left end.
    pub fn axis_name(&mut self, text: RichText, pos: Point, anchor: Anchor) {
        let label = self.label(text, pos, anchor, Role::Muted);
        let [min, max] = label.bounds();
        let left = [min[0], 0.5 * (min[1] + max[1])];
        self.placing.keep_free(left, 0.5 * label.size);
        self.placing.place(&mut self.drawing, label);
    }

    /// A text where there is room; says whether there was.
    pub fn try_text(&mut self, text: RichText, pos: Point, anchor: Anchor, role: Role) -> bool {
        let label = self.label(text, pos, anchor, role);
        self.placing.try_place(&mut self.drawing, label)
    }

    /// A piece of a curve; a lone point as a dot.
    pub fn run(&mut self, points: Vec<Point>, pen: Pen) {
        if let [lone] = points[..] {
            self.drawing.items.push(Item::Dot {
                center: lone,
                radius: 0.5 * pen.width,
                ink: pen.ink,
                outline: None,
            });
        }
        self.drawing
            .dashed_line(thinned(points), pen.width, pen.dash, pen.ink);
    }
}
