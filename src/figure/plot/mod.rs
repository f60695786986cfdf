//! Plots on straight axes: one or more panels over each other with one x axis, curves and dots in them.
//!
//! A view lays its plot out with [`Plot::new`], then shades, draws the axes, curves, marks, in the order in which they
//! lie over each other.

mod canvas;
mod frame;
mod layout;
mod marks;
mod outline;

pub use frame::PlotFrame;
pub use marks::PlotDot;
pub use outline::{Outline, Panel, Pen};

use super::drawing::{Anchor, Drawing, Item, Label, Point};
use super::legend::{self, LegendEntry};
use super::palette::{Ink, Role};
use super::polyline;
use super::text::RichText;
pub(super) use canvas::PlotCanvas;
use layout::{NUMBER_GAP_EM, PlotLayout};

/// A plot in the making.
pub struct Plot {
    canvas: PlotCanvas,
    plan: PlotLayout,
    x_name: String,
    /// One per panel.
    pub frames: Vec<PlotFrame>,
    /// Places of the subjects' names.
    pub legend: Vec<LegendEntry>,
}

impl Plot {
    /// Lays out `size` points and draws title and legend.
    pub fn new(outline: &Outline, size: [f32; 2]) -> Self {
        let plan = PlotLayout::new(outline, size);
        let mut canvas = PlotCanvas::new(size, plan.font);
        let (title, at) = &plan.title;
        canvas.text(title.clone(), *at, Anchor::LEFT, Role::Muted);
        let mut entries = Vec::new();
        for (index, name, at) in &plan.legend {
            let subject = &outline.subjects[*index];
            let font = canvas.font;
            let (entry, label) =
                legend::draw_entry(&mut canvas.drawing, *index, subject, name, *at, font);
            canvas.placing.place(&mut canvas.drawing, label);
            entries.push(entry);
        }
        for place in &plan.panels {
            if let Some((title, at)) = &place.title {
                canvas.text(title.clone(), *at, Anchor::LEFT, Role::Muted);
            }
        }
        let frames = plan.panels.iter().zip(&outline.panels);
        let frames = frames.map(|(place, panel)| PlotFrame {
            min: [plan.left, place.top],
            max: [plan.right, place.bottom],
            x: outline.x,
            y: panel.axis,
        });
        Self {
            frames: frames.collect(),
            canvas,
            x_name: outline.x_name.clone(),
            plan,
            legend: entries,
        }
    }

    /// Font size in points.
    pub fn font(&self) -> f32 {
        self.plan.font
    }

    /// Shades all panels between two values of x.
    pub fn shade(&mut self, from: f64, to: f64, ink: Ink) {
        for frame in &self.frames {
            let share = |x: f64| frame.x.share(x).clamp(0.0, 1.0);
            if share(from) < share(to) {
                let corner = |x: f64, y: f64| frame.at(frame.x.value(share(x)), y);
                let points = vec![
                    corner(from, 0.0),
                    corner(to, 0.0),
                    corner(to, 1.0),
                    corner(from, 1.0),
                ];
                self.canvas.drawing.fill(points, ink);
            }
        }
    }

    /// Grid, frame, marks and their numbers.
    pub fn axes(&mut self) {
        let grid = Ink::from(Role::Faint);
        let muted = Ink::from(Role::Muted);
        for (frame, place) in self.frames.iter().zip(&self.plan.panels) {
            let [left, top] = frame.min;
            let [right, bottom] = frame.max;
            let drawing = &mut self.canvas.drawing;
            let across = |position: f64| left + (right - left) * position as f32;
            let up = |position: f64| bottom - (bottom - top) * position as f32;
            for tick in &self.plan.x_marks.major {
                let x = across(tick.position);
                drawing.line(vec![[x, top], [x, bottom]], 1.0, grid.faded(0.7));
                drawing.line(vec![[x, bottom], [x, bottom - 5.0]], 1.0, muted.faded(0.8));
            }
            for minor in &self.plan.x_marks.minor {
                let x = across(*minor);
                drawing.line(vec![[x, bottom], [x, bottom - 3.0]], 1.0, muted.faded(0.6));
            }
            for tick in &place.marks.major {
                let y = up(tick.position);
                drawing.line(vec![[left, y], [right, y]], 1.0, grid.faded(0.7));
                drawing.line(vec![[left, y], [left + 5.0, y]], 1.0, muted.faded(0.8));
            }
            for minor in &place.marks.minor {
                let y = up(*minor);
                drawing.line(vec![[left, y], [left + 3.0, y]], 1.0, muted.faded(0.6));
            }
            let outline = vec![[left, top], [left, bottom], [right, bottom]];
            drawing.line(outline, 1.0, muted.faded(0.8));
        }
        self.numbers();
    }

    fn numbers(&mut self) {
        let gap = NUMBER_GAP_EM * self.plan.font;
        for (frame, place) in self.frames.iter().zip(&self.plan.panels) {
            let [_, height] = frame.size();
            // The ends first: the others give way.
            let mut ticks: Vec<_> = place.marks.major.iter().collect();
            ticks.sort_by(|a, b| {
                (b.position - 0.5)
                    .abs()
                    .total_cmp(&(a.position - 0.5).abs())
            });
            for tick in ticks {
                let at = [
                    frame.min[0] - gap,
                    frame.max[1] - height * tick.position as f32,
                ];
                self.canvas
                    .try_text(tick.label.clone(), at, Anchor::RIGHT, Role::Muted);
            }
        }
        let Some(frame) = self.frames.last() else {
            return;
        };
        let (left, width) = (frame.min[0], frame.size()[0]);
        let bottom = frame.max[1];
        for tick in &self.plan.x_marks.major {
            let at = [left + width * tick.position as f32, self.plan.numbers_y];
            self.canvas
                .try_text(tick.label.clone(), at, Anchor::CENTER, Role::Muted);
        }
        if let Some(below) = &self.plan.x_names {
            for (k, name) in below.names.iter().enumerate() {
                let x = frame.x.share((k + 1) as f64);
                if (0.0..=1.0).contains(&x) {
                    let at = [left + width * x as f32, bottom + gap];
                    let (anchor, angle) = if below.upright {
                        (Anchor::RIGHT, -std::f32::consts::FRAC_PI_2)
                    } else {
                        (Anchor::TOP, 0.0)
                    };
                    let label = self
                        .canvas
                        .label(name.clone(), at, anchor, Role::Foreground);
                    let label = Label {
                        size: below.size,
                        angle,
                        ..label
                    };
                    self.canvas.drawing.items.push(Item::Text(label));
                }
            }
        }
        let name = RichText::parse(&self.x_name);
        if self.plan.name_y > self.plan.numbers_y {
            let at = [left + 0.5 * width, self.plan.name_y];
            self.canvas.text(name, at, Anchor::CENTER, Role::Muted);
        } else {
            let lines = [self.plan.numbers_y, bottom - self.plan.font];
            self.canvas
                .name_among_numbers(&name, [left, left + width], lines);
        }
    }

    /// A curve through (x, y) by ascending x, with gaps where there is no y; cut at the ends of the axis.
    pub fn curve(
        &mut self,
        panel: usize,
        samples: impl Iterator<Item = (f64, Option<f64>)>,
        pen: Pen,
    ) {
        let Some(frame) = self.frames.get(panel) else {
            return;
        };
        let samples = samples.map(|(x, y)| (x, y.map(|y| frame.y.share(y))));
        for points in polyline::runs(samples, |x, share| frame.at(x, share)) {
            self.canvas.run(points, pen);
        }
    }

    /// A line from side to side at a value of y, if that is shown.
    pub fn level(&mut self, panel: usize, y: f64, pen: Pen) {
        if let Some(frame) = self.frames.get(panel) {
            let share = frame.y.share(y);
            if (0.0..=1.0).contains(&share) {
                let [left, right] = [0.0, 1.0].map(|end| frame.at(frame.x.value(end), share));
                self.canvas.run(vec![left, right], pen);
            }
        }
    }

    /// A line from top to bottom of all panels at a value of x, if that is shown.
    pub fn upright(&mut self, x: f64, pen: Pen) {
        for frame in &self.frames {
            if (0.0..=1.0).contains(&frame.x.share(x)) {
                let line: Vec<Point> = [0.0, 1.0].map(|end| frame.at(x, end)).to_vec();
                self.canvas.run(line, pen);
            }
        }
    }

    /// The picture and the legend's places.
    pub fn finish(self) -> (Drawing, Vec<LegendEntry>) {
        (self.canvas.drawing, self.legend)
    }
}

#[cfg(test)]
pub(super) mod tests;
