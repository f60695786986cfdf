//! Polar lobes in the plane of incidence: f_r over θo for several θi, measured and modelled.
//!
//! The light comes from the left: wi is at −θi, the mirror direction at +θi. θo is signed, positive to the right.

mod axis;
mod backdrop;
mod draw;
mod frame;
mod layout;
mod panel;
mod spec;
mod traces;

pub use frame::LobeFrame;
pub use spec::{LOBE_SCALES, LobeScale, LobeSpec};
pub use traces::Trace;

use super::drawing::Drawing;
use super::legend::LegendEntry;
use super::subject::Subject;

/// A lobe plot: the picture, where things are in it, and the numbers behind it.
#[derive(Clone, Debug)]
pub struct LobePlot {
    /// The picture.
    pub drawing: Drawing,
    /// Map between angles, values and points of the drawing.
    pub frame: LobeFrame,
    /// Curves as numbers, for hovering and for tables.
    pub traces: Vec<Trace>,
    /// Places of the subjects' names.
    pub legend: Vec<LegendEntry>,
}

impl LobePlot {
    /// Plots the subjects that are not hidden into `size` points.
    pub fn new(spec: &LobeSpec, subjects: &[Subject], size: [f32; 2]) -> Self {
        let traces = traces::trace_all(spec, subjects);
        let axis = axis::axis_for(spec, subjects, &traces);
        let plan = layout::LobeLayout::new(spec, axis.scale, subjects, size);
        let frame = LobeFrame {
            origin: plan.origin,
            radius: plan.radius,
            axis,
            theta_i: spec.theta_i.clone(),
        };
        let (drawing, legend) = draw::draw(spec, subjects, &traces, &frame, &plan, size);
        Self {
            drawing,
            frame,
            traces,
            legend,
        }
    }
}

#[cfg(test)]
mod tests;
