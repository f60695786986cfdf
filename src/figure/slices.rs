//! Slices: f_r over one angle with the others fixed, measured and modelled, with what is between the two below.
//!
//! In a slice over θo the light comes from the left: wi is at −θi, the mirror direction at +θi.

mod curves;
mod draw;
mod panel;
mod spec;

pub use curves::{ResidualTrace, SliceTrace};
pub use spec::{OVERS, Over, RESIDUALS, Residual, SliceSpec};

use super::drawing::{Drawing, Point};
use super::legend::LegendEntry;
use super::plot::PlotFrame;
use super::subject::Subject;

/// A plot of slices: the picture, where things are in it, and the numbers behind it.
#[derive(Clone, Debug)]
pub struct SlicePlot {
    /// The picture.
    pub drawing: Drawing,
    /// Map between values and points of the drawing: x in degrees, y in 1/sr.
    pub frame: PlotFrame,
    /// Map between values and points of the panel of residuals below, if there are any.
    pub strip: Option<PlotFrame>,
    /// Curves as numbers, within the window.
    pub traces: Vec<SliceTrace>,
    /// The residuals as numbers.
    pub residuals: Vec<ResidualTrace>,
    /// Places of the subjects' names.
    pub legend: Vec<LegendEntry>,
}

impl SlicePlot {
    /// Plots the subjects that are not hidden into `size` points.
    pub fn new(spec: &SliceSpec, subjects: &[Subject], size: [f32; 2]) -> Self {
        draw::draw(spec, subjects, size)
    }

    /// The angle in radians at a point of the curves or of the residuals.
    pub fn x_at(&self, point: Point) -> Option<f64> {
        let frames = [Some(self.frame), self.strip];
        let mut found = frames
            .into_iter()
            .flatten()
            .filter_map(|frame| frame.locate(point));
        found.next().map(|[x, _]| x.to_radians())
    }
}

#[cfg(test)]
mod tests;
