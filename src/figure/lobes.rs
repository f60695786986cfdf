//! Polar lobes in the plane of incidence: f_r over θo for several θi, measured and modelled.
//!
//! The light comes from the left: wi is at −θi, the mirror direction at +θi. θo is signed, positive to the right.

mod backdrop;
mod draw;
mod frame;
mod layout;
mod traces;

pub use frame::LobeFrame;
pub use traces::{Sample, Trace};

use super::drawing::{Drawing, Point};
use super::scale::{Axis, RadialScale, nice_limit};
use crate::geom::{Rgb, color::luminance};
use glam::DVec3;

/// Angles of incidence that are drawn are kept below this, so that wi stays above the horizon.
pub const MAX_THETA_I: f64 = 89.5 * std::f64::consts::PI / 180.0;

/// What of a colour is plotted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Channel {
    /// Relative luminance with the Rec. 709 primaries.
    #[default]
    Luminance,
    /// Red.
    R,
    /// Green.
    G,
    /// Blue.
    B,
}

/// All channels in the order offered.
pub const CHANNELS: [Channel; 4] = [Channel::Luminance, Channel::R, Channel::G, Channel::B];

impl Channel {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        match self {
            Self::Luminance => "luminance",
            Self::R => "r",
            Self::G => "g",
            Self::B => "b",
        }
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Luminance => "luminance",
            Self::R => "red",
            Self::G => "green",
            Self::B => "blue",
        }
    }

    /// The channel whose key this is.
    pub fn by_key(key: &str) -> Option<Self> {
        CHANNELS.into_iter().find(|channel| channel.key() == key)
    }

    /// Its value in linear RGB.
    pub fn of(self, rgb: Rgb) -> f64 {
        match self {
            Self::Luminance => luminance(rgb),
            Self::R => rgb[0],
            Self::G => rgb[1],
            Self::B => rgb[2],
        }
    }
}

/// What a lobe plot shows of its curves.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeSpec {
    /// Angles of incidence in radians, in [0, π/2].
    pub theta_i: Vec<f64>,
    /// Which of them is drawn strong, with its vectors.
    pub active: usize,
    /// How values become radii.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi, which gives the radiance under a light of unit strength.
    pub with_cosine: bool,
    /// What of the colours is plotted.
    pub channel: Channel,
    /// Whether solid curves are shown.
    pub show_measured: bool,
    /// Whether dashed curves are shown.
    pub show_model: bool,
    /// The view direction under the probe: signed θo in radians.
    pub probe_theta_o: Option<f64>,
    /// The value at the rim, in 1/sr; from the curves without it.
    pub limit: Option<f64>,
}

impl Default for LobeSpec {
    fn default() -> Self {
        Self {
            theta_i: [30.0, 60.0, 80.0].map(f64::to_radians).to_vec(),
            active: 1,
            scale: RadialScale::default(),
            with_cosine: false,
            channel: Channel::default(),
            show_measured: true,
            show_model: true,
            probe_theta_o: None,
            limit: None,
        }
    }
}

/// How the lines of a curve look; in the order in which they are drawn over each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Look {
    /// Solid.
    Measured,
    /// A fit beside the model, thinner: dotted, or with long dashes.
    Beside {
        /// Which of the two.
        long: bool,
    },
    /// Dashed.
    Model,
}

impl Look {
    /// Dash and gap in points; `None` for solid.
    pub fn dash(self) -> Option<[f32; 2]> {
        match self {
            Self::Measured => None,
            Self::Model => Some([6.0, 3.5]),
            Self::Beside { long: false } => Some([1.6, 2.8]),
            Self::Beside { long: true } => Some([12.0, 4.0]),
        }
    }

    /// Width of an active lobe's line in points.
    pub fn width(self) -> f32 {
        match self {
            Self::Measured | Self::Model => 2.0,
            Self::Beside { .. } => 1.6,
        }
    }
}

/// A BRDF to plot.
pub struct Curve<'a> {
    /// Its name in the legend.
    pub label: String,
    /// Measurement or model.
    pub look: Look,
    /// The material it belongs to, which gives the colour; of a fit beside it, its own
    /// [`super::palette::companion`].
    pub series: usize,
    /// f_r of (wi, wo) in 1/sr; `None` where nothing was measured.
    pub f_r: &'a dyn Fn(DVec3, DVec3) -> Option<Rgb>,
}

impl LobeSpec {
    /// What is plotted of `curve` at these angles in radians (θo signed); `None` where it has no finite value.
    pub fn value(&self, curve: &Curve, theta_i: f64, theta_o: f64) -> Option<f64> {
        let wi = DVec3::new(-theta_i.sin(), 0.0, theta_i.cos());
        let wo = DVec3::new(theta_o.sin(), 0.0, theta_o.cos());
        let cosine = if self.with_cosine { wi.z } else { 1.0 };
        let value = cosine * self.channel.of((curve.f_r)(wi, wo)?);
        value.is_finite().then_some(value)
    }

    /// Whether a curve is to be shown.
    pub fn shows(&self, curve: &Curve) -> bool {
        if curve.look != Look::Measured {
            self.show_model
        } else {
            self.show_measured
        }
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
}

/// A point of a trace that the pointer is near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Position of the curve in the list that was plotted.
    pub curve: usize,
    /// Position of θi in the spec.
    pub lobe: usize,
    /// Signed θo in radians.
    pub theta_o: f64,
    /// What is plotted there.
    pub value: f64,
    /// Where that is in the drawing.
    pub point: Point,
}

impl LobePlot {
    /// Plots the curves that the spec shows into `size` points.
    pub fn new(spec: &LobeSpec, curves: &[Curve], size: [f32; 2]) -> Self {
        let traces = traces::trace_all(spec, curves);
        let axis = axis_for(spec, &traces);
        let plan = layout::Plan::new(spec, curves, size);
        let frame = LobeFrame {
            origin: plan.origin,
            radius: plan.radius,
            axis,
            theta_i: spec.theta_i.clone(),
        };
        let drawing = draw::draw(spec, curves, &traces, &frame, &plan, size);
        Self {
            drawing,
            frame,
            traces,
        }
    }

    /// The drawn value nearest to `point` in the direction of `point`, if one is within `reach` points.
    pub fn hit(&self, point: Point, reach: f32) -> Option<Hit> {
        let (theta_o, _) = self.frame.locate(point)?;
        self.traces
            .iter()
            .filter_map(|trace| {
                let value = trace.value_at(theta_o)?;
                Some(Hit {
                    curve: trace.curve,
                    lobe: trace.lobe,
                    theta_o,
                    value,
                    point: self.frame.point(theta_o, value),
                })
            })
            .map(|hit| (distance(hit.point, point), hit))
            .filter(|(distance, _)| *distance <= reach)
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, hit)| hit)
    }
}

/// One axis for all curves, from what is drawn or as the spec says.
fn axis_for(spec: &LobeSpec, traces: &[Trace]) -> Axis {
    let values = || traces.iter().flat_map(Trace::values);
    let limit = spec
        .limit
        .unwrap_or_else(|| nice_limit(values().fold(0.0, f64::max)));
    let smallest = values().filter(|x| *x > 0.0).min_by(f64::total_cmp);
    Axis::new(spec.scale, limit, smallest)
}

fn distance(a: Point, b: Point) -> f32 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[cfg(test)]
mod tests;
