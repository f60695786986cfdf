//! The axes of a plot of slices, and the order in which all is drawn.

use super::SlicePlot;
use super::curves::{self, ResidualTrace, SliceTrace};
use super::spec::{Over, Residual, SliceSpec};
use crate::figure::cosine::CosineFactor;
use crate::figure::mark::ProbeMark;
use crate::figure::palette::{Ink, Role};
use crate::figure::plot::{Outline, Panel, Pen, Plot};
use crate::figure::samples;
use crate::figure::scale::{Axis, RadialScale, Steps, nice_limit};
use crate::figure::subject::Subject;
use crate::figure::text::RichText;
use crate::geom::limits::UNRELIABLE_THETA_DEG;

/// Fewest and most decades of a logarithmic axis that is laid out from the curves.
const DECADES: (i32, i32) = (1, 8);

pub(super) fn draw(spec: &SliceSpec, subjects: &[Subject], size: [f32; 2]) -> SlicePlot {
    // The frame is a little narrower: samples are not farther apart than its points.
    let traces = curves::trace_all(spec, subjects, size[0]);
    let residuals = curves::residuals(spec, subjects, &traces);
    let [low, high] = spec.seen().map(f64::to_degrees);
    let mut panels = vec![Panel {
        axis: value_axis(spec, &traces),
        height: 2.6,
        title: Vec::new(),
    }];
    if spec.residual != Residual::None {
        panels.push(strip(spec, &residuals));
    }
    let outline = Outline {
        title: title(spec),
        subjects,
        x: Axis::between(RadialScale::Linear, low, high),
        x_steps: Steps::Degrees,
        x_names: Vec::new(),
        x_name: format!("{} [°]", spec.over.symbol()),
        panels,
    };
    let mut plot = Plot::new(&outline, size);
    let grazing = grazing_regions(spec);
    for [from, to] in &grazing {
        plot.shade(
            from.to_degrees(),
            to.to_degrees(),
            Ink::from(Role::Faint).faded(0.45),
        );
    }
    plot.axes();
    let even = if spec.residual == Residual::Ratio {
        1.0
    } else {
        0.0
    };
    plot.level(1, even, Pen::thin(Ink::from(Role::Muted).faded(0.8)));
    lines(&mut plot, spec, subjects, &traces, &residuals);
    probe(&mut plot, spec, subjects, &traces, &residuals);
    names(&mut plot, spec, &traces);
    let text = RichText::literal(&format!("> {UNRELIABLE_THETA_DEG}°"));
    for [from, to] in grazing {
        plot.note(0, from.to_degrees(), to.to_degrees(), &text, Role::Muted);
    }
    if traces
        .iter()
        .all(|trace| samples::values(&trace.samples).next().is_none())
    {
        plot.say(0, sentences(subjects.is_empty()));
    } else if spec.residual != Residual::None && residuals.is_empty() {
        plot.say(
            1,
            &[
                "No measurement and model of one material are shown.",
                "No pair is shown.",
            ],
        );
    }
    let (frame, strip) = (plot.frames[0], plot.frames.get(1).copied());
    let (drawing, legend) = plot.finish();
    SlicePlot {
        drawing,
        frame,
        strip,
        traces,
        residuals,
        legend,
    }
}

fn sentences(no_subjects: bool) -> &'static [&'static str] {
    if no_subjects {
        &["Open a material to see its slices.", "Nothing to show."]
    } else {
        &["No value at these angles.", "No value."]
    }
}

/// One axis for all curves, from what is drawn or as the spec says.
fn value_axis(spec: &SliceSpec, traces: &[SliceTrace]) -> Axis {
    if let Some([low, high]) = spec.limits {
        return Axis::between(spec.scale, low, high);
    }
    let values = || {
        traces
            .iter()
            .flat_map(|trace| samples::values(&trace.samples))
    };
    let limit = nice_limit(values().fold(0.0, f64::max));
    let smallest = values().filter(|x| *x > 0.0).min_by(f64::total_cmp);
    Axis::with_decades(spec.scale, limit, smallest, DECADES)
}

/// Limits of a ratio and its inverse.
const RATIOS: [f64; 11] = [
    1.1, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0,
];

fn strip(spec: &SliceSpec, residuals: &[ResidualTrace]) -> Panel {
    let values = residuals
        .iter()
        .flat_map(|trace| samples::values(&trace.samples));
    let (axis, title) = if spec.residual == Residual::Ratio {
        let most = values.map(|x| x.max(1.0 / x)).fold(1.0, f64::max);
        let limit = RATIOS.into_iter().find(|limit| most <= *limit);
        let limit = limit.unwrap_or(RATIOS[RATIOS.len() - 1]);
        (
            Axis::between(RadialScale::Log, 1.0 / limit, limit),
            vec![
                "model / measured, log_{10} scale".into(),
                "model / measured".into(),
            ],
        )
    } else {
        // Differences have both signs: a logarithm has no place for them, a cube root does.
        let scale = match spec.scale {
            RadialScale::Linear => RadialScale::Linear,
            RadialScale::CubeRoot | RadialScale::Log => RadialScale::CubeRoot,
        };
        let limit = nice_limit(values.map(f64::abs).fold(0.0, f64::max));
        let what = format!("(model − measured){} [sr^{{−1}}]", spec.cosine.markup());
        let short = if spec.cosine == CosineFactor::NONE {
            "model − measured [sr^{−1}]".into()
        } else {
            what
        };
        (
            Axis::between(scale, -limit, limit),
            vec![format!("{short}, {} scale", scale.phrase()), short],
        )
    };
    Panel {
        axis,
        height: 1.0,
        title,
    }
}

/// Title: the quantity, its unit, the fixed angles, the channel and the scale; shorter ones for less room.
fn title(spec: &SliceSpec) -> Vec<String> {
    let what = format!("f_{{r}}{} [sr^{{−1}}]", spec.cosine.markup());
    let degrees = |x: f64| format!("{}°", (10.0 * x.to_degrees()).round() / 10.0);
    let (theta_h, theta_d, phi_d) = (
        format!("θ_{{h}} = {}", degrees(spec.theta_h)),
        format!("θ_{{d}} = {}", degrees(spec.theta_d)),
        format!("φ_{{d}} = {}", degrees(spec.phi_d)),
    );
    let at = match spec.over {
        Over::ThetaO => {
            let list: Vec<String> = spec.theta_i.iter().map(|x| degrees(*x)).collect();
            format!("θ_{{i}} = {}", list.join(", "))
        }
        Over::ThetaH => format!("{theta_d}, {phi_d}"),
        Over::ThetaD => format!("{theta_h}, {phi_d}"),
        Over::PhiD => format!("{theta_h}, {theta_d}"),
    };
    let (channel, scale) = (spec.channel.name(), spec.scale.phrase());
    vec![
        format!("{what} at {at}, {channel}, {scale} scale"),
        format!("{what}, {at}, {channel}, {scale}"),
        format!("{what}, {channel}, {scale}"),
    ]
}

/// The parts of what is seen that are above the horizon with θi or θo past 80°; over θo with several θi, by θo and by
/// the smallest of them.
pub(super) fn grazing_regions(spec: &SliceSpec) -> Vec<[f64; 2]> {
    const STEPS: usize = 720;
    let slice = (0..spec.theta_i.len())
        .min_by(|a, b| spec.theta_i[*a].total_cmp(&spec.theta_i[*b]))
        .unwrap_or(0);
    let edge = UNRELIABLE_THETA_DEG.to_radians().cos();
    let grazes = |x: f64| {
        let (wi, wo) = spec.pair(slice, x);
        let lower = wi.z.min(wo.z);
        (-1e-12..edge).contains(&lower)
    };
    let [low, high] = spec.seen();
    let at = |k: usize| low + (high - low) * k as f64 / STEPS as f64;
    // Where the answer changes between two angles that differ in it.
    let border = |mut a: f64, mut b: f64| {
        let first = grazes(a);
        for _ in 0..30 {
            let middle = 0.5 * (a + b);
            *(if grazes(middle) == first {
                &mut a
            } else {
                &mut b
            }) = middle;
        }
        0.5 * (a + b)
    };
    let mut regions = Vec::new();
    let mut begin = grazes(low).then_some(low);
    for k in 1..=STEPS {
        let (a, b) = (at(k - 1), at(k));
        match (begin, grazes(b)) {
            (None, true) => begin = Some(border(a, b)),
            (Some(from), false) => {
                regions.push([from, border(a, b)]);
                begin = None;
            }
            _ => {}
        }
    }
    regions.extend(begin.map(|from| [from, high]));
    regions
}

/// The active slices over the others, models over measurements.
fn lines(
    plot: &mut Plot,
    spec: &SliceSpec,
    subjects: &[Subject],
    traces: &[SliceTrace],
    residuals: &[ResidualTrace],
) {
    let in_degrees = |samples: &[samples::Sample]| -> Vec<(f64, Option<f64>)> {
        let samples = samples.iter();
        samples.map(|s| (s.x.to_degrees(), s.value)).collect()
    };
    let mut order: Vec<&SliceTrace> = traces.iter().collect();
    order.sort_by_key(|trace| (spec.is_active(trace.slice), subjects[trace.subject].look));
    for trace in order {
        let pen = Pen::of(&subjects[trace.subject], spec.is_active(trace.slice));
        plot.curve(0, in_degrees(&trace.samples).into_iter(), pen);
    }
    let mut order: Vec<&ResidualTrace> = residuals.iter().collect();
    order.sort_by_key(|trace| (spec.is_active(trace.slice), subjects[trace.model].look));
    for trace in order {
        let pen = Pen::of(&subjects[trace.model], spec.is_active(trace.slice));
        plot.curve(1, in_degrees(&trace.samples).into_iter(), pen);
    }
}

/// A line at the probe's angle, and dots where it meets the active curves.
fn probe(
    plot: &mut Plot,
    spec: &SliceSpec,
    subjects: &[Subject],
    traces: &[SliceTrace],
    residuals: &[ResidualTrace],
) {
    let Some(ProbeMark { at, exact }) = spec.probe else {
        return;
    };
    let x = at.to_degrees();
    plot.upright(
        x,
        Pen {
            dash: Some([2.0, 3.0]),
            ..Pen::thin(Ink::from(Role::Muted).faded(0.9))
        },
    );
    for trace in traces.iter().filter(|trace| spec.is_active(trace.slice)) {
        if let Some(value) = samples::value_at(&trace.samples, at) {
            let role = Role::Series(subjects[trace.subject].series);
            plot.probe(0, x, value, role, exact);
        }
    }
    for trace in residuals.iter().filter(|trace| spec.is_active(trace.slice)) {
        if let Some(value) = samples::value_at(&trace.samples, at) {
            let role = Role::Series(subjects[trace.model].series);
            plot.probe(1, x, value, role, exact);
        }
    }
}

/// θi beside the peak of each slice where there are several: the active one first.
fn names(plot: &mut Plot, spec: &SliceSpec, traces: &[SliceTrace]) {
    if spec.slices() < 2 {
        return;
    }
    let mut slices: Vec<usize> = (0..spec.slices()).collect();
    slices.sort_by_key(|slice| !spec.is_active(*slice));
    for slice in slices {
        let highest = traces
            .iter()
            .filter(|trace| trace.slice == slice)
            .filter_map(|trace| samples::peak(&trace.samples))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((x, value)) = highest {
            let degrees = (10.0 * spec.theta_i[slice].to_degrees()).round() / 10.0;
            let name = RichText::parse(&format!("θ_{{i}} {degrees}°"));
            let role = if spec.is_active(slice) {
                Role::Foreground
            } else {
                Role::Muted
            };
            plot.tag(0, x.to_degrees(), value, &name, role);
        }
    }
}
