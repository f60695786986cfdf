//! Directional albedo over θi: how much of the light from one direction comes back, measured and modelled.

mod panel;

pub use panel::KnownAlbedos;

use super::drawing::{Drawing, Point};
use super::legend::LegendEntry;
use super::mark::ProbeMark;
use super::palette::{Ink, Role};
use super::plot::{Outline, Panel, Pen, Plot, PlotFrame};
use super::samples::{self, Sample};
use super::scale::{Axis, RadialScale, Steps, nice_limit};
use super::subject::{Channel, Look, Source, Subject};
use super::text::RichText;
use crate::brdf;
use crate::geom::limits::UNRELIABLE_THETA_DEG;
use crate::geom::{Rgb, degrees};
use crate::measured;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;
use std::ops::ControlFlow;

/// Directional albedo at one angle of incidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlbedoPoint {
    /// Angle of incidence in radians.
    pub theta_i: f64,
    /// ∫ f_r cos θo dωo, over what has a value.
    pub rgb: Rgb,
    /// The share of ∫ cos θo dωo that has a value, in [0, 1]; 1 of a model.
    pub measured: f64,
}

/// The angles of incidence at which albedos are computed, in radians: closer where they change most.
pub fn angles() -> Vec<f64> {
    let steps = [(0, 60, 4), (60, 80, 2), (80, 90, 1)];
    steps
        .into_iter()
        .flat_map(|(from, to, step)| (from..to).step_by(step))
        .map(|degrees| f64::from(degrees).to_radians())
        .collect()
}

/// The albedo of a source at one angle. Takes milliseconds.
pub fn point(source: &Source, theta_i: f64) -> AlbedoPoint {
    let (rgb, measured) = match source {
        Source::Model(brdf) => (brdf::albedo(brdf, theta_i), 1.0),
        Source::Measured(table, lookup) => {
            let found = measured::albedo::albedo(table, *lookup, theta_i);
            (found.rgb, found.measured)
        }
        Source::Function(f_r) => {
            let found = measured::albedo::reflectance(theta_i, |wi, wo| f_r(wi, wo));
            (found.rgb, found.measured)
        }
    };
    AlbedoPoint {
        theta_i,
        rgb,
        measured,
    }
}

/// The albedos of a source at [`angles`]; `step` hears after each one, and may stop it.
pub fn curve(
    source: &Source,
    mut step: impl FnMut() -> ControlFlow<()>,
) -> Option<Vec<AlbedoPoint>> {
    let mut points = Vec::new();
    for theta_i in angles() {
        points.push(point(source, theta_i));
        if step().is_break() {
            return None;
        }
    }
    Some(points)
}

/// The albedos of a subject, where they are known.
#[derive(Clone, Copy, Debug, Default)]
pub struct AlbedoCurve<'a> {
    /// Samples of the curve, by ascending θi.
    pub points: &'a [AlbedoPoint],
    /// Whether they are of other parameters than the subject's, and drawn paler.
    pub old: bool,
}

/// Settings of a plot of albedos.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct AlbedoSpec {
    /// Colour channel that is plotted.
    pub channel: Channel,
    /// The part of θi that is seen, in radians; all of it without.
    #[serde(with = "degrees")]
    pub window: Option<[f64; 2]>,
    /// The ends of the axis of albedos; from the curves without.
    pub limits: Option<[f64; 2]>,
    /// θi under the probe, in radians.
    #[serde(skip)]
    pub probe: Option<ProbeMark>,
}

/// A plot of albedos.
#[derive(Clone, Debug)]
pub struct AlbedoPlot {
    /// The picture.
    pub drawing: Drawing,
    /// Map between values and points of the drawing: x in degrees.
    pub frame: PlotFrame,
    /// Places of the subjects' names.
    pub legend: Vec<LegendEntry>,
}

impl AlbedoPlot {
    /// Plots the curves of the subjects that are not hidden into `size` points. `curves` are in the order of the
    /// subjects; one without points is not computed yet.
    pub fn new(
        spec: &AlbedoSpec,
        subjects: &[Subject],
        curves: &[AlbedoCurve],
        size: [f32; 2],
    ) -> Self {
        let shown: Vec<ShownCurve> = subjects
            .iter()
            .zip(curves)
            .filter(|(subject, curve)| !subject.hidden && !curve.points.is_empty())
            .map(|(subject, curve)| ShownCurve::new(spec.channel, subject, curve))
            .collect();
        let [low, high] = spec
            .window
            .filter(|[low, high]| low < high)
            .unwrap_or([0.0, FRAC_PI_2])
            .map(f64::to_degrees);
        let what = "albedo ∫ f_{r} cos θ_{o} dω_{o}";
        let channel = spec.channel.name();
        let outline = Outline {
            title: vec![
                format!("directional {what}, {channel}, linear scale"),
                format!("{what}, {channel}, linear"),
                format!("albedo, {channel}, linear"),
            ],
            subjects,
            x: Axis::between(RadialScale::Linear, low, high),
            x_steps: Steps::Degrees,
            x_names: Vec::new(),
            x_name: "θ_{i} [°]".into(),
            panels: vec![Panel {
                axis: axis(spec, &shown),
                height: 1.0,
                title: Vec::new(),
            }],
        };
        let mut plot = Plot::new(&outline, size);
        plot.shade(
            UNRELIABLE_THETA_DEG,
            90.0,
            Ink::from(Role::Faint).faded(0.45),
        );
        plot.axes();
        plot.level(
            0,
            1.0,
            Pen {
                dash: Some([2.0, 3.0]),
                ..Pen::thin(Role::Foreground.into())
            },
        );
        draw_curves(&mut plot, &shown);
        draw_probe(&mut plot, spec, &shown);
        let text = RichText::literal(&format!("> {UNRELIABLE_THETA_DEG}°"));
        plot.note(0, UNRELIABLE_THETA_DEG, 90.0, &text, Role::Muted);
        if shown.is_empty() {
            let waits = curves.iter().zip(subjects).any(|(_, s)| !s.hidden);
            plot.say(
                0,
                match waits {
                    true => &["Computing the albedo…"],
                    false => &["Open a material to see its albedo.", "Nothing to show."],
                },
            );
        }
        let frame = plot.frames[0];
        let (drawing, legend) = plot.finish();
        Self {
            drawing,
            frame,
            legend,
        }
    }

    /// θi in radians at a point of the plot.
    pub fn theta_i_at(&self, point: Point) -> Option<f64> {
        self.frame.locate(point).map(|[x, _]| x.to_radians())
    }
}

/// A subject with its numbers: x in degrees.
struct ShownCurve<'a> {
    subject: &'a Subject,
    old: bool,
    values: Vec<Sample>,
    /// The measured share.
    share: Vec<Sample>,
}

impl<'a> ShownCurve<'a> {
    fn new(channel: Channel, subject: &'a Subject, curve: &AlbedoCurve) -> Self {
        let sample = |point: &AlbedoPoint, value: Option<f64>| Sample {
            x: point.theta_i.to_degrees(),
            value: value.filter(|x| x.is_finite()),
        };
        let value = |point: &AlbedoPoint| {
            let known = point.measured > 0.0;
            sample(point, known.then(|| channel.of(point.rgb)))
        };
        let points = curve.points.iter();
        Self {
            subject,
            old: curve.old,
            values: points.clone().map(value).collect(),
            share: points
                .map(|point| sample(point, Some(point.measured)))
                .collect(),
        }
    }

    fn pen(&self) -> Pen {
        let pen = Pen::of(self.subject, true);
        let strength = if self.old { 0.4 } else { 1.0 };
        Pen {
            ink: pen.ink.faded(strength),
            ..pen
        }
    }

    fn line<'b>(
        &self,
        samples: &'b [Sample],
    ) -> impl Iterator<Item = (f64, Option<f64>)> + use<'b> {
        samples.iter().map(|sample| (sample.x, sample.value))
    }

    /// The part of the curve above 1, its ends on 1, if there is one; and the angles in degrees between which it is.
    fn above_one(&self) -> Option<(Vec<Sample>, [f64; 2])> {
        let mut part: Vec<Sample> = Vec::new();
        let mut ends: Option<[f64; 2]> = None;
        for pair in self.values.windows(2) {
            let (Some(a), Some(b)) = (pair[0].value, pair[1].value) else {
                continue;
            };
            if a.max(b) <= 1.0 {
                continue;
            }
            let crossing = pair[0].x + (1.0 - a) / (b - a) * (pair[1].x - pair[0].x);
            let from = if a > 1.0 { pair[0].x } else { crossing };
            let to = if b > 1.0 { pair[1].x } else { crossing };
            let gap = part.last().is_some_and(|last| last.x < from - 1e-9);
            if gap {
                part.push(Sample {
                    x: from,
                    value: None,
                });
            }
            for (x, value) in [(from, a.max(1.0)), (to, b.max(1.0))] {
                let value = Some(value);
                part.push(Sample { x, value });
            }
            ends = Some([ends.map_or(from, |ends| ends[0]), to]);
        }
        ends.map(|ends| (part, ends))
    }
}

fn axis(spec: &AlbedoSpec, shown: &[ShownCurve]) -> Axis {
    if let Some([low, high]) = spec.limits {
        return Axis::between(RadialScale::Linear, low, high);
    }
    let most = shown
        .iter()
        .flat_map(|shown| samples::values(&shown.values))
        .fold(0.0, f64::max);
    // A little room over the line at 1.
    let limit = if most <= 1.0 { 1.1 } else { nice_limit(most) };
    Axis::between(RadialScale::Linear, 0.0, limit)
}

fn draw_curves(plot: &mut Plot, shown: &[ShownCurve]) {
    let mut order: Vec<&ShownCurve> = shown.iter().collect();
    order.sort_by_key(|shown| shown.subject.look);
    let excess: Vec<_> = order.iter().map(|shown| shown.above_one()).collect();
    for (shown, excess) in order.iter().zip(&excess) {
        if let Some((part, _)) = excess {
            let pen = Pen {
                width: 7.0,
                dash: None,
                ink: Ink::from(Role::Accent).faded(0.45),
            };
            plot.curve(0, shown.line(part), pen);
        }
    }
    for shown in &order {
        if shown.subject.look == Look::Measured {
            let pen = Pen {
                dash: Some([1.5, 2.5]),
                ..Pen::thin(Ink::from(Role::Muted).faded(0.9))
            };
            plot.curve(0, shown.line(&shown.share), pen);
        }
    }
    for shown in &order {
        plot.curve(0, shown.line(&shown.values), shown.pen());
    }
    for (shown, excess) in order.iter().zip(&excess) {
        if let Some((part, [from, to])) = excess {
            let range = format!("θ_{{i}} = {from:.0}°…{to:.0}°");
            let label = &shown.subject.label;
            let full = format!("{label} exceeds 1 at {range}");
            let middle = 0.5 * (from + to);
            let places: Vec<(f64, f64)> = [*from, middle, *to]
                .into_iter()
                .filter_map(|x| Some((x, samples::value_at(part, x)?)))
                .collect();
            let texts = [full, format!("exceeds 1 at {range}"), "> 1".into()];
            let texts = texts.map(|text| RichText::parse(&text));
            for text in &texts {
                let mut places = places.iter();
                if places.any(|(x, y)| plot.tag(0, *x, *y, text, Role::Accent)) {
                    break;
                }
            }
        }
    }
    let measured = order
        .iter()
        .find(|shown| shown.subject.look == Look::Measured);
    if let Some(shown) = measured {
        let name = RichText::literal("measured share");
        for x in [20.0, 8.0, 36.0, 60.0] {
            let at = samples::value_at(&shown.share, x);
            if at.is_some_and(|y| plot.tag(0, x, y, &name, Role::Muted)) {
                break;
            }
        }
    }
}

fn draw_probe(plot: &mut Plot, spec: &AlbedoSpec, shown: &[ShownCurve]) {
    let Some(ProbeMark { at, exact }) = spec.probe else {
        return;
    };
    let x = at.to_degrees();
    let pen = Pen {
        dash: Some([2.0, 3.0]),
        ..Pen::thin(Ink::from(Role::Muted).faded(0.9))
    };
    plot.upright(x, pen);
    for shown in shown {
        if let Some(value) = samples::value_at(&shown.values, x) {
            let role = Role::Series(shown.subject.series);
            plot.probe(0, x, value, role, exact);
        }
    }
}

#[cfg(test)]
mod tests;
