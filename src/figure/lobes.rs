//! Polar lobes in the plane of incidence: f_r over θo for several θi, measured and modelled.
//!
//! The light comes from the left: wi is at −θi, the mirror direction at +θi. θo is signed, positive to the right.

mod backdrop;
mod draw;
mod frame;
mod layout;
mod traces;

pub use frame::LobeFrame;
pub use traces::Trace;

use super::drawing::{Drawing, Point};
use super::legend::LegendEntry;
use super::mark::Mark;
use super::scale::{Axis, RadialScale, nice_limit};
use super::subject::{Channel, Subject};
use crate::geom::degrees;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Angles of incidence that are drawn are kept below this, so that wi stays above the horizon.
pub const MAX_THETA_I: f64 = 89.5 * std::f64::consts::PI / 180.0;

/// What a lobe plot shows of its curves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LobeSpec {
    /// Angles of incidence in radians, in [0, π/2].
    #[serde(with = "degrees")]
    pub theta_i: Vec<f64>,
    /// Which of them is drawn strong, with its vectors.
    pub active: usize,
    /// How values become radii.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi, which gives the radiance under a light of unit strength.
    pub with_cosine: bool,
    /// What of the colours is plotted.
    pub channel: Channel,
    /// The view direction under the probe: signed θo in radians.
    #[serde(skip)]
    pub probe: Option<Mark>,
    /// The values in the middle and at the rim, in 1/sr; from the curves without.
    pub limits: Option<[f64; 2]>,
    /// Whether it is for paper: nothing to take hold of, no lobe before the others.
    pub still: bool,
}

impl Default for LobeSpec {
    fn default() -> Self {
        Self {
            theta_i: [30.0, 60.0, 80.0].map(f64::to_radians).to_vec(),
            active: 1,
            scale: RadialScale::default(),
            with_cosine: false,
            channel: Channel::default(),
            probe: None,
            limits: None,
            still: false,
        }
    }
}

impl LobeSpec {
    /// Whether a lobe is drawn strong.
    pub(super) fn is_strong(&self, lobe: usize) -> bool {
        self.still || lobe == self.active
    }

    /// What is plotted of `subject` at these angles in radians (θo signed); `None` where it has no finite value.
    pub fn value(&self, subject: &Subject, theta_i: f64, theta_o: f64) -> Option<f64> {
        let wi = DVec3::new(-theta_i.sin(), 0.0, theta_i.cos());
        let wo = DVec3::new(theta_o.sin(), 0.0, theta_o.cos());
        let cosine = if self.with_cosine { wi.z } else { 1.0 };
        let value = cosine * self.channel.of(subject.source.f_r(wi, wo)?);
        value.is_finite().then_some(value)
    }
}

/// A lobe plot: the picture, where things are in it, and the numbers behind it.
#[derive(Clone, Debug)]
pub struct LobePlot {
    /// The picture.
    pub drawing: Drawing,
    /// Where angles and values are in it.
    pub frame: LobeFrame,
    /// What is drawn as numbers, for hovering and for tables.
    pub traces: Vec<Trace>,
    /// Where the names of the subjects are.
    pub legend: Vec<LegendEntry>,
}

impl LobePlot {
    /// Plots the subjects that are not hidden into `size` points.
    pub fn new(spec: &LobeSpec, subjects: &[Subject], size: [f32; 2]) -> Self {
        let traces = traces::trace_all(spec, subjects);
        let axis = axis_for(spec, &traces);
        let plan = layout::Plan::new(spec, subjects, size);
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

/// One axis for all curves, from what is drawn or as the spec says.
fn axis_for(spec: &LobeSpec, traces: &[Trace]) -> Axis {
    let values = || traces.iter().flat_map(Trace::values);
    if let Some([low, high]) = spec.limits {
        return Axis::between(spec.scale, low, high);
    }
    let limit = nice_limit(values().fold(0.0, f64::max));
    let smallest = values().filter(|x| *x > 0.0).min_by(f64::total_cmp);
    Axis::new(spec.scale, limit, smallest)
}

fn distance(a: Point, b: Point) -> f32 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[cfg(test)]
mod tests;
