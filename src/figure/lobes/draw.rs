//! The curves of a lobe plot, what names them, and the order in which all is drawn.

use super::backdrop::{self, LobeCanvas};
use super::layout::LobeLayout;
use super::{LobeFrame, LobeSpec, Trace};
use crate::figure::drawing::{Anchor, Drawing, Item, Point};
use crate::figure::legend::{self, LegendEntry};
use crate::figure::mark::{ProbeMark, probe_dot};
use crate::figure::palette::{Ink, Role};
use crate::figure::polyline::{self, thinned};
use crate::figure::scale::number;
use crate::figure::subject::Subject;
use crate::figure::text::RichText;

pub(super) fn draw(
    spec: &LobeSpec,
    subjects: &[Subject],
    traces: &[Trace],
    frame: &LobeFrame,
    plan: &LobeLayout,
    size: [f32; 2],
) -> (Drawing, Vec<LegendEntry>) {
    let mut canvas = LobeCanvas::new(frame, plan.font, size);
    let (title, at) = &plan.title;
    let label = canvas.label(title.clone(), *at, Anchor::LEFT, Role::Muted);
    canvas.placing.place(&mut canvas.drawing, label);
    let entries = legend(&mut canvas, subjects, plan);
    backdrop::ground(&mut canvas);
    backdrop::vectors(&mut canvas, spec);
    backdrop::rim_labels(&mut canvas);
    backdrop::ring_labels(&mut canvas);
    // The active lobes over the others, models over measurements.
    let mut order: Vec<&Trace> = traces.iter().collect();
    order.sort_by_key(|trace| {
        let strong = spec.is_strong(trace.lobe);
        (strong, subjects[trace.subject].look)
    });
    for trace in &order {
        lobe(
            &mut canvas,
            trace,
            &subjects[trace.subject],
            spec.is_strong(trace.lobe),
        );
    }
    if !spec.still {
        backdrop::handles(&mut canvas, spec);
    }
    probe_dots(&mut canvas, spec, subjects, &order);
    lobe_labels(&mut canvas, spec, traces, subjects);
    if !traces.iter().any(|trace| trace.values().next().is_some()) {
        nothing(&mut canvas, subjects.is_empty());
    }
    (canvas.drawing, entries)
}

fn legend(canvas: &mut LobeCanvas, subjects: &[Subject], plan: &LobeLayout) -> Vec<LegendEntry> {
    let entries = plan.legend.iter().map(|(index, name, at)| {
        let (entry, label) = legend::draw_entry(
            &mut canvas.drawing,
            *index,
            &subjects[*index],
            name,
            *at,
            canvas.font,
        );
        canvas.placing.place(&mut canvas.drawing, label);
        entry
    });
    entries.collect()
}

/// A trace as polylines, broken where it has no value and where it leaves the rim; an arrow where it leaves the rim
/// stands for the peak beyond.
fn lobe(canvas: &mut LobeCanvas, trace: &Trace, subject: &Subject, strong: bool) {
    let ink = Ink::from(Role::Series(subject.series)).faded(if strong { 1.0 } else { 0.5 });
    let width = subject.look.width() * if strong { 1.0 } else { 0.6 };
    for points in runs(canvas.frame, trace) {
        if let [lone] = points[..] {
            canvas.drawing.items.push(Item::Dot {
                center: lone,
                radius: 0.5 * width,
                ink,
                outline: None,
            });
        }
        let dash = subject.look.dash();
        canvas
            .drawing
            .dashed_line(thinned(points), width, dash, ink);
    }
    if let Some(theta_o) = exit(canvas.frame, trace) {
        let reach = f64::from(0.75 * canvas.font / canvas.frame.radius);
        let half_width = 0.55 * reach;
        let arrow = [
            canvas.frame.at(theta_o - half_width, 1.0 - reach),
            canvas.frame.at(theta_o, 1.0),
            canvas.frame.at(theta_o + half_width, 1.0 - reach),
        ];
        canvas.drawing.fill(arrow.to_vec(), ink);
    }
}

/// Signed θo at which a curve leaves the rim for its peak, on the side of the normal; `None` where it stays inside.
fn exit(frame: &LobeFrame, trace: &Trace) -> Option<f64> {
    let beyond = |value: f64| frame.axis.position(value) > 1.0 + 1e-9;
    let (peak_at, _) = trace.peak().filter(|(_, value)| beyond(*value))?;
    let inside = trace.samples.iter().filter(|sample| {
        let towards = sample.x * peak_at >= 0.0 && sample.x.abs() <= peak_at.abs();
        towards && sample.value.is_some_and(|value| !beyond(value))
    });
    let last = inside.max_by(|a, b| a.x.abs().total_cmp(&b.x.abs()));
    Some(last.map_or(peak_at, |sample| sample.x))
}

/// The pieces of a trace between gaps, inside the rim.
fn runs(frame: &LobeFrame, trace: &Trace) -> Vec<Vec<Point>> {
    let samples = trace
        .samples
        .iter()
        .map(|sample| (sample.x, sample.value.map(|x| frame.axis.position(x))));
    polyline::runs(samples, |theta_o, position| frame.at(theta_o, position))
}

/// Dots at which the probe meets the active lobes.
fn probe_dots(canvas: &mut LobeCanvas, spec: &LobeSpec, subjects: &[Subject], traces: &[&Trace]) {
    let Some(ProbeMark { at: theta_o, exact }) = spec.probe else {
        return;
    };
    for trace in traces.iter().filter(|trace| trace.lobe == spec.active) {
        let Some(value) = trace.value_at(theta_o) else {
            continue;
        };
        if canvas.frame.axis.position(value) <= 1.0 {
            let center = canvas.frame.point(theta_o, value);
            let role = Role::Series(subjects[trace.subject].series);
            canvas.drawing.items.push(probe_dot(center, role, exact));
        }
    }
}

/// θi beside each lobe, with the peak of one that is clipped: the active lobe first.
fn lobe_labels(canvas: &mut LobeCanvas, spec: &LobeSpec, traces: &[Trace], subjects: &[Subject]) {
    let mut lobes: Vec<usize> = (0..spec.theta_i.len()).collect();
    lobes.sort_by_key(|lobe| *lobe != spec.active);
    for lobe in lobes {
        // The data name a lobe where there are any: they keep still while a model is moved.
        let of_lobe = traces
            .iter()
            .filter(|trace| trace.lobe == lobe && trace.peak().is_some());
        let named = of_lobe.min_by_key(|trace| subjects[trace.subject].look);
        let Some((trace, (theta_o, value))) = named.and_then(|trace| Some((trace, trace.peak()?)))
        else {
            continue;
        };
        let degrees = (10.0 * spec.theta_i[lobe].to_degrees()).round() / 10.0;
        let exit = exit(canvas.frame, trace);
        let text = match (exit.is_some(), spec.theta_i.len()) {
            (true, 1) => format!("peak {}", two_digits(value)),
            (true, _) => format!("{degrees}°, peak {}", two_digits(value)),
            (false, 1) => continue,
            (false, _) => format!("{degrees}°"),
        };
        let text = RichText::parse(&text);
        let role = if spec.is_strong(lobe) {
            Role::Foreground
        } else {
            Role::Muted
        };
        // At the tip, or else further down on either side.
        let tip = exit.unwrap_or(theta_o);
        let places = [
            0.0, 4.0, -4.0, 9.0, -9.0, 16.0, -16.0, 25.0, -25.0, 40.0, -40.0_f64,
        ];
        let places = places.iter().filter_map(|aside_deg| {
            let theta_o = tip + aside_deg.to_radians();
            let value = trace.value_at(theta_o)?;
            Some((theta_o, canvas.frame.axis.position(value).min(1.0)))
        });
        let places: Vec<(f64, f64)> = places.collect();
        for place in places {
            if label_at(canvas, &text, place, role) {
                break;
            }
        }
    }
}

/// Writes a lobe's name beyond a point of it, or beside that, a little inwards; whether there was room.
fn label_at(
    canvas: &mut LobeCanvas,
    text: &RichText,
    (theta_o, position): (f64, f64),
    role: Role,
) -> bool {
    let tip = canvas.frame.at(theta_o, position);
    let gap = 0.35 * canvas.font;
    // Beyond it, then on the side of the normal, where curves are fewer, then on that of the horizon.
    [0.0, -85.0, -110.0, -60.0, 100.0, 60.0, -135.0, 130.0_f64]
        .into_iter()
        .any(|turn_deg| {
            let heading = theta_o + theta_o.signum() * turn_deg.to_radians();
            let (dx, dy) = (heading.sin() as f32, -heading.cos() as f32);
            let at = [tip[0] + gap * dx, tip[1] + gap * dy];
            let mut label = canvas.label(text.clone(), at, Anchor::towards(-dx, -dy), role);
            label.halo = true;
            canvas.inside_disc(&label) && canvas.placing.try_place(&mut canvas.drawing, label)
        })
}

/// A value with two digits that count, as markup.
fn two_digits(value: f64) -> String {
    let unit = 10f64.powi(value.abs().log10().floor() as i32 - 1);
    number((value / unit).round() * unit)
}

/// One sentence in place of curves.
fn nothing(canvas: &mut LobeCanvas, no_curves: bool) {
    let sentence = if no_curves {
        "Open a material to see its lobes."
    } else {
        "No value at these angles."
    };
    let mut text = RichText::literal(sentence);
    let room = 1.7 * canvas.frame.radius / canvas.font;
    if text.width_em() > room {
        text = RichText::literal("Nothing to show.");
    }
    let at = canvas.frame.at(0.0, 0.45);
    let mut label = canvas.label(text, at, Anchor::CENTER, Role::Muted);
    label.halo = true;
    canvas.placing.place(&mut canvas.drawing, label);
}
