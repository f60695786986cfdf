//! Annotations in a plot: dots, names beside them, sentences.

use super::Plot;
use crate::figure::drawing::{Anchor, Item, Point};
use crate::figure::mark::probe_dot;
use crate::figure::palette::{Ink, Role};
use crate::figure::text::RichText;

/// A dot with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotDot {
    /// Value on the horizontal axis.
    pub x: f64,
    /// Value on the vertical axis.
    pub y: f64,
    /// Radius in points.
    pub radius: f32,
    /// Fill colour.
    pub ink: Ink,
    /// Beside it, where there is room.
    pub name: RichText,
}

impl Plot {
    /// Dots inside a panel, the first ones over the others and named first. Gives back where each one is.
    pub fn dots(&mut self, panel: usize, spots: &[PlotDot]) -> Vec<Option<Point>> {
        let Some(frame) = self.frames.get(panel).copied() else {
            return vec![None; spots.len()];
        };
        let places: Vec<Option<Point>> = spots
            .iter()
            .map(|spot| {
                frame
                    .shows(spot.x, spot.y)
                    .then(|| frame.point(spot.x, spot.y))
            })
            .collect();
        for (spot, place) in spots.iter().zip(&places).rev() {
            if let Some(center) = place {
                self.canvas.placing.keep_free(*center, spot.radius);
                self.canvas.drawing.items.push(Item::Dot {
                    center: *center,
                    radius: spot.radius,
                    ink: spot.ink,
                    outline: Some((1.0, Role::Background.into())),
                });
            }
        }
        for (spot, place) in spots.iter().zip(&places) {
            if let Some(center) = place {
                self.name(panel, *center, spot.radius, &spot.name, Role::Foreground);
            }
        }
        places
    }

    /// The dot of the probe at a pair of values, if that is shown.
    pub fn probe(&mut self, panel: usize, x: f64, y: f64, role: Role, exact: bool) {
        if let Some(frame) = self.frames.get(panel)
            && frame.shows(x, y)
        {
            let dot = probe_dot(frame.point(x, y), role, exact);
            self.canvas.drawing.items.push(dot);
        }
    }

    /// A name beside a pair of values, inside the panel, where there is room.
    pub fn tag(&mut self, panel: usize, x: f64, y: f64, name: &RichText, role: Role) -> bool {
        let Some(frame) = self.frames.get(panel) else {
            return false;
        };
        let at = frame.at(x, frame.y.share(y).clamp(0.0, 1.0));
        self.name(panel, at, 1.0, name, role)
    }

    /// A name beside a point: above it, then on the sides, below at last.
    fn name(&mut self, panel: usize, at: Point, radius: f32, name: &RichText, role: Role) -> bool {
        let (Some(frame), false) = (self.frames.get(panel).copied(), name.runs.is_empty()) else {
            return false;
        };
        let gap = radius + 0.3 * self.canvas.font;
        for turn_deg in [0.0, 90.0, -90.0, 45.0, -45.0, 135.0, -135.0, 180.0_f32] {
            let (sin, cos) = turn_deg.to_radians().sin_cos();
            let pos = [at[0] + gap * sin, at[1] - gap * cos];
            let anchor = Anchor::towards(-sin, cos);
            let mut label = self.canvas.label(name.clone(), pos, anchor, role);
            label.halo = true;
            let [min, max] = label.bounds();
            if frame.contains(min)
                && frame.contains(max)
                && self
                    .canvas
                    .placing
                    .try_place(&mut self.canvas.drawing, label)
            {
                return true;
            }
        }
        false
    }

    /// A text in the upper corner of a panel between two values of x, if there is room for it.
    pub fn note(&mut self, panel: usize, from: f64, to: f64, text: &RichText, role: Role) {
        let Some(frame) = self.frames.get(panel) else {
            return;
        };
        let across = |x: f64| {
            let share = frame.x.share(x).clamp(0.0, 1.0);
            frame.min[0] + frame.size()[0] * share as f32
        };
        let size = 0.85 * self.canvas.font;
        let (left, right) = (across(from), across(to));
        if right - left < size * (text.width_em() + 0.4) {
            return;
        }
        let pos = [0.5 * (left + right), frame.min[1] + 0.25 * size];
        let mut label = self.canvas.label(text.clone(), pos, Anchor::TOP, role);
        label.size = size;
        self.canvas
            .placing
            .try_place(&mut self.canvas.drawing, label);
    }

    /// The first of these sentences that fits, in the middle of a panel in place of curves.
    pub fn say(&mut self, panel: usize, sentences: &[&str]) {
        let Some(frame) = self.frames.get(panel) else {
            return;
        };
        let [width, height] = frame.size();
        let room = 0.95 * width / self.canvas.font;
        let texts = sentences.iter().map(|sentence| RichText::parse(sentence));
        let Some(text) = texts.clone().find(|text| text.width_em() <= room) else {
            return;
        };
        let at = [frame.min[0] + 0.5 * width, frame.min[1] + 0.5 * height];
        let mut label = self.canvas.label(text, at, Anchor::CENTER, Role::Muted);
        label.halo = true;
        self.canvas
            .placing
            .try_place(&mut self.canvas.drawing, label);
    }
}
