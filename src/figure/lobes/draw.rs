//! The curves of a lobe plot, what names them, and the order in which all is drawn.

use super::backdrop::{self, LobeCanvas};
use super::layout::LobeLayout;
use super::{LobeFrame, LobeSpec, Trace};
use crate::figure::drawing::{Anchor, Drawing, Item, Point};
use crate::figure::legend::{self, LegendEntry};
use crate::figure::mark::{ProbeMark, probe_dot};
use crate::figure::palette::{Ink, Role};
use crate::figure::polyline::{self, thinned};
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
    lobe_labels(&mut canvas, spec, traces);
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

/// A trace as polylines, broken where it has no value and where it leaves the rim.
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

/// θi beside the tip of each lobe, where there is room: the active one first.
fn lobe_labels(canvas: &mut LobeCanvas, spec: &LobeSpec, traces: &[Trace]) {
    if spec.theta_i.len() < 2 {
        return;
    }
    let mut lobes: Vec<usize> = (0..spec.theta_i.len()).collect();
    lobes.sort_by_key(|lobe| *lobe != spec.active);
    for lobe in lobes {
        let highest = traces
            .iter()
            .filter(|trace| trace.lobe == lobe)
            .filter_map(Trace::peak)
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((theta_o, value)) = highest else {
            continue;
        };
        let degrees = (10.0 * spec.theta_i[lobe].to_degrees()).round() / 10.0;
        let text = RichText::literal(&format!("{degrees}°"));
        let position = canvas.frame.axis.position(value).min(1.0);
        let role = if spec.is_strong(lobe) {
            Role::Foreground
        } else {
            Role::Muted
        };
        let tip = canvas.frame.at(theta_o, position);
        let gap = 0.35 * canvas.font;
        // Beyond the tip, then beside it on either side, a little inwards.
        for turn_deg in [0.0, 100.0, -100.0, 60.0, -60.0, 130.0, -130.0_f64] {
            let heading = theta_o + turn_deg.to_radians();
            let (dx, dy) = (heading.sin() as f32, -heading.cos() as f32);
            let at = [tip[0] + gap * dx, tip[1] + gap * dy];
            let mut label = canvas.label(text.clone(), at, Anchor::towards(-dx, -dy), role);
            label.halo = true;
            if canvas.inside_disc(&label) && canvas.placing.try_place(&mut canvas.drawing, label) {
                break;
            }
        }
    }
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
