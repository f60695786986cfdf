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

    /// The name of an axis among its numbers, on their line: as far right as they leave it room, else above the right end of
    /// the axis.
    pub fn name_among_numbers(
        &mut self,
        text: &RichText,
        [from, to]: [f32; 2],
        [y, above]: [f32; 2],
    ) {
        // A name must not read as a factor of the number beside it.
        let (gap, width) = (self.font, self.font * text.width_em());
        let mut right = to;
        while right - width >= from {
            let label = self.label(text.clone(), [right, y], Anchor::RIGHT, Role::Muted);
            if self.placing.try_place_apart(&mut self.drawing, label, gap) {
                return;
            }
            right -= 0.25 * self.font;
        }
        let mut label = self.label(text.clone(), [to, above], Anchor::RIGHT, Role::Muted);
        label.halo = true;
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
