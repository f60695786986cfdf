//! Polar lobes in the plane of incidence: f_r over the signed θo for several θi.
//!
//! The light comes from the left and the mirror direction is on the right: wi stands at −θi, and θo is positive to
//! the right. What is measured is solid and the model dashed; where f has no value there is a gap.

mod frame;
mod scaffold;

pub use frame::LobeFrame;

use super::drawing::{Drawing, Ink, Point, Role};
use super::scale::RadialScale;
use crate::geom::color::luminance;
use crate::geom::{Rgb, direction};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};

/// What is shown of RGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Channel {
    /// Rec. 709 luminance.
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
    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Luminance => "luminance",
            Self::R => "red",
            Self::G => "green",
            Self::B => "blue",
        }
    }

    /// The shown number of a colour.
    pub fn of(self, rgb: Rgb) -> f64 {
        match self {
            Self::Luminance => luminance(rgb),
            Self::R => rgb[0],
            Self::G => rgb[1],
            Self::B => rgb[2],
        }
    }
}

/// What to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeSpec {
    /// Angles of incidence in radians.
    pub theta_i: Vec<f64>,
    /// The one whose vectors are drawn.
    pub active: usize,
    /// Radius per value.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi.
    pub with_cosine: bool,
    /// Which channel.
    pub channel: Channel,
    /// Where the probe is, signed, in radians.
    pub probe_theta_o: Option<f64>,
    /// Value at the rim; `None` takes it from the data.
    pub limit: Option<f64>,
}

impl Default for LobeSpec {
    fn default() -> Self {
        Self {
            theta_i: vec![FRAC_PI_2 / 2.0],
            active: 0,
            scale: RadialScale::Linear,
            with_cosine: false,
            channel: Channel::Luminance,
            probe_theta_o: None,
            limit: None,
        }
    }
}

/// A data set.
pub struct Curve<'a> {
    /// Name in the legend.
    pub label: String,
    /// Dashed for a model.
    pub dashed: bool,
    /// Number of its colour.
    pub series: usize,
    /// f_r in 1/sr; `None` where there is no value.
    pub f_r: &'a dyn Fn(DVec3, DVec3) -> Option<Rgb>,
}

/// The drawing, and where things are in it.
#[derive(Clone, Debug, PartialEq)]
pub struct LobePlot {
    /// What to paint.
    pub drawing: Drawing,
    /// Between points of the drawing and angles.
    pub frame: LobeFrame,
}

/// Signed θo in radians and the shown value there.
type Sample = (f64, Option<f64>);

impl LobePlot {
    /// Draws the curves into `size` points.
    pub fn new(spec: &LobeSpec, curves: &[Curve<'_>], size: [f32; 2]) -> Self {
        let lobes: Vec<Vec<Vec<Sample>>> = curves
            .iter()
            .map(|curve| {
                spec.theta_i
                    .iter()
                    .map(|theta_i| sample(spec, curve, *theta_i))
                    .collect()
            })
            .collect();
        let peak = lobes
            .iter()
            .flatten()
            .flatten()
            .filter_map(|(_, value)| *value)
            .fold(0.0, f64::max);
        let limit = spec.limit.unwrap_or_else(|| spec.scale.limit(peak));
        let frame = LobeFrame::new(size, spec.scale, limit, spec.theta_i.clone());
        let mut drawing = Drawing {
            size,
            items: Vec::new(),
        };
        scaffold::draw_ground(&mut drawing, &frame, spec);
        // The active angle last, over the others.
        let mut order: Vec<usize> = (0..spec.theta_i.len())
            .filter(|index| *index != spec.active)
            .collect();
        order.extend((spec.active < spec.theta_i.len()).then_some(spec.active));
        for index in order {
            for (curve, lobes) in curves.iter().zip(&lobes) {
                draw_lobe(
                    &mut drawing,
                    &frame,
                    curve,
                    &lobes[index],
                    index == spec.active,
                );
            }
        }
        scaffold::draw_vectors(&mut drawing, &frame, spec);
        if spec.theta_i.len() > 1 {
            scaffold::draw_lobe_names(&mut drawing, &frame, spec, &lobes);
        }
        scaffold::draw_legend(&mut drawing, curves);
        Self { drawing, frame }
    }
}

/// Half the steps of the even sampling of θo: every quarter degree.
const HALF_STEPS: i32 = 360;

/// The places where a lobe is sampled: evenly, and ever denser towards the mirror direction, where a lobe may be
/// narrower than a step.
fn places(theta_i: f64) -> Vec<f64> {
    let mut places: Vec<f64> = (-HALF_STEPS..=HALF_STEPS)
        .map(|k| FRAC_PI_2 * f64::from(k) / f64::from(HALF_STEPS))
        .collect();
    let near = (0..40).map(|k| 2f64.to_radians() * 0.8f64.powi(k));
    places.extend(
        near.flat_map(|offset| [theta_i - offset, theta_i + offset])
            .filter(|theta| theta.abs() < FRAC_PI_2),
    );
    places.push(theta_i);
    places.sort_by(f64::total_cmp);
    places
}

fn sample(spec: &LobeSpec, curve: &Curve<'_>, theta_i: f64) -> Vec<Sample> {
    let wi = direction(theta_i, PI);
    let factor = if spec.with_cosine { theta_i.cos() } else { 1.0 };
    places(theta_i)
        .into_iter()
        .map(|theta_o| {
            // At ±90° exactly, rounding puts wo a hair below the horizon.
            let inside = theta_o.clamp(-FRAC_PI_2 + 1e-9, FRAC_PI_2 - 1e-9);
            let value =
                (curve.f_r)(wi, direction(inside, 0.0)).map(|rgb| factor * spec.channel.of(rgb));
            (theta_o, value.filter(|value| value.is_finite()))
        })
        .collect()
}

fn draw_lobe(
    drawing: &mut Drawing,
    frame: &LobeFrame,
    curve: &Curve<'_>,
    lobe: &[Sample],
    active: bool,
) {
    let (width, opacity) = if active { (2.0, 1.0) } else { (1.25, 0.55) };
    let ink: Ink = Role::Series(curve.series).with_opacity(opacity);
    let mut run: Vec<Point> = Vec::new();
    for (theta_o, value) in lobe {
        match value {
            Some(value) => run.push(frame.point(*theta_o, *value)),
            None => drawing.stroke(std::mem::take(&mut run), width, curve.dashed, ink),
        }
    }
    drawing.stroke(run, width, curve.dashed, ink);
}

#[cfg(test)]
mod tests;
