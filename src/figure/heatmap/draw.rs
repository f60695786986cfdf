//! The order in which a heat map is drawn: cells, hatching, lines, frame, colour bar, marks.

use super::bar::{draw_key, rectangle};
use super::layout::{HeatLayout, TICK};
use super::{Cell, Curve, CurveKind, HeatField, HeatFrame, HeatSpec, HeatSpot, hatch, raster};
use crate::figure::drawing::{Anchor, Drawing, Item, LINE_HEIGHT, Label, Point};
use crate::figure::mark::ProbeMark;
use crate::figure::over_colors::{self, DARK, LIGHT};
use crate::figure::palette::{Ink, Role};
use crate::figure::placing::Placing;
use crate::figure::text::RichText;
use std::f32::consts::FRAC_PI_2;

pub(super) fn draw(
    spec: &HeatSpec,
    field: &HeatField,
    plan: &HeatLayout,
    size: [f32; 2],
) -> Drawing {
    let mut drawing = Drawing::new(size);
    let mut placing = Placing::default();
    let frame = &plan.frame;
    drawing
        .items
        .extend(raster::image(field, &spec.colors, frame, spec.smooth));
    let hatching = Ink::from(Role::Muted).faded(0.9);
    hatch::hatch(&mut drawing, field, frame, hatching);
    for curve in &spec.curves {
        line_over(&mut drawing, curve, frame);
    }
    for curve in &spec.curves {
        name_line(&mut drawing, &mut placing, curve, plan);
    }
    axes(&mut drawing, spec, plan);
    let ([_, top], [right, bottom]) = (frame.min, frame.max);
    plan.bar.draw(
        &mut drawing,
        &spec.colors,
        &spec.bar_title,
        [[right, top], [right, bottom]],
    );
    if let Some(at) = plan.key {
        draw_key(&mut drawing, spec.missing, at, plan.font);
    }
    for spot in &spec.spots {
        mark(&mut drawing, *spot, frame);
    }
    if !field
        .cells
        .iter()
        .any(|cell| matches!(cell, Cell::Value(_)))
    {
        let middle = [0, 1].map(|k| 0.5 * (frame.min[k] + frame.max[k]));
        let text = RichText::literal(spec.nothing);
        let mut label = Label::new(text, middle, Anchor::CENTER, plan.font, Role::Muted);
        label.halo = true;
        drawing.items.push(Item::Text(label));
    }
    drawing
}

fn axes(drawing: &mut Drawing, spec: &HeatSpec, plan: &HeatLayout) {
    let (frame, font) = (&plan.frame, plan.font);
    let ink = Ink::from(Role::Muted).faded(0.8);
    let ([left, top], [_, bottom]) = (frame.min, frame.max);
    let [width, height] = frame.size();
    let mut texts = Vec::new();
    for tick in &plan.x_ticks {
        let x = left + width * tick.position as f32;
        drawing.line(vec![[x, bottom], [x, bottom + TICK]], 1.0, ink);
        let at = [x, bottom + TICK + 0.5 * LINE_HEIGHT * font];
        texts.push(Label::new(
            tick.label.clone(),
            at,
            Anchor::CENTER,
            font,
            Role::Muted,
        ));
    }
    for tick in &plan.y_ticks {
        let y = bottom - height * tick.position as f32;
        drawing.line(vec![[left - TICK, y], [left, y]], 1.0, ink);
        let at = [left - TICK - 0.3 * font, y];
        texts.push(Label::new(
            tick.label.clone(),
            at,
            Anchor::RIGHT,
            font,
            Role::Muted,
        ));
    }
    drawing.line(rectangle([frame.min, frame.max]), 1.0, ink);
    let (title, at) = &plan.title;
    texts.push(Label::new(
        title.clone(),
        *at,
        Anchor::LEFT,
        font,
        Role::Foreground,
    ));
    let below = [left + 0.5 * width, bottom + TICK + 1.5 * LINE_HEIGHT * font];
    let name = RichText::parse(&spec.x.title);
    texts.push(Label::new(
        name,
        below,
        Anchor::CENTER,
        font,
        Role::Foreground,
    ));
    let widest = plan.y_ticks.iter().map(|tick| tick.label.width_em());
    let gap = TICK + font * (0.4 + widest.fold(0.0, f32::max)) + 0.6 * LINE_HEIGHT * font;
    let beside = [left - gap, top + 0.5 * height];
    let name = RichText::parse(&spec.y.title);
    let mut label = Label::new(name, beside, Anchor::CENTER, font, Role::Foreground);
    label.angle = -FRAC_PI_2;
    texts.push(label);
    drawing.items.extend(texts.into_iter().map(Item::Text));
}

/// A curve, cut at the frame.
fn line_over(drawing: &mut Drawing, curve: &Curve, frame: &HeatFrame) {
    let (width, dash, opacity) = match curve.kind {
        CurveKind::Limit => (1.0, Some([5.0, 4.0]), 0.9),
        CurveKind::Contour => (1.0, None, 0.75),
        CurveKind::Path => (2.0, None, 1.0),
    };
    for run in runs(curve, frame) {
        over_colors::line(drawing, run, width, dash, opacity);
    }
}

/// The pieces of a curve within the frame.
fn runs(curve: &Curve, frame: &HeatFrame) -> Vec<Vec<Point>> {
    let points: Vec<Point> = curve.points.iter().map(|at| frame.point(*at)).collect();
    let mut runs: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some([a, b]) = clip(pair[0], pair[1], frame) else {
            continue;
        };
        match runs.last_mut() {
            Some(run) if run.last() == Some(&a) => run.push(b),
            _ => runs.push(vec![a, b]),
        }
    }
    runs.retain(|run| run.len() > 1);
    runs
}

/// The piece of a segment within the frame [Liang and Barsky].
fn clip(a: Point, b: Point, frame: &HeatFrame) -> Option<[Point; 2]> {
    let (mut from, mut to) = (0.0f32, 1.0f32);
    for k in 0..2 {
        let way = b[k] - a[k];
        for (sign, edge) in [(1.0, frame.min[k]), (-1.0, frame.max[k])] {
            let (speed, gap) = (sign * way, sign * (edge - a[k]));
            if speed == 0.0 {
                if gap > 0.0 {
                    return None;
                }
            } else if speed > 0.0 {
                from = from.max(gap / speed);
            } else {
                to = to.min(gap / speed);
            }
        }
    }
    let at = |t: f32| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    let whole = |t: f32, end: Point, rest: f32| if t == rest { end } else { at(t) };
    (from < to).then(|| [whole(from, a, 0.0), whole(to, b, 1.0)])
}

/// The name of a curve in the middle of its longest piece, along it, where nothing else is.
fn name_line(drawing: &mut Drawing, placing: &mut Placing, curve: &Curve, plan: &HeatLayout) {
    let Some(name) = &curve.label else {
        return;
    };
    let text = RichText::parse(name);
    let size = 0.85 * plan.font;
    let length = |run: &Vec<Point>| -> f32 {
        let pairs = run.windows(2);
        pairs
            .map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]))
            .sum()
    };
    let mut runs = runs(curve, &plan.frame);
    runs.sort_by(|a, b| length(b).total_cmp(&length(a)));
    for run in runs.iter().filter(|run| length(run) > 30.0) {
        for share in [0.5, 0.3, 0.7, 0.15, 0.85] {
            let at = run[((run.len() - 1) as f32 * share) as usize];
            let mut label = Label::new(text.clone(), at, Anchor::CENTER, size, Role::Foreground);
            label.halo = true;
            let [min, max] = label.bounds();
            let inside = (0..2).all(|k| min[k] >= plan.frame.min[k] && max[k] <= plan.frame.max[k]);
            if inside && placing.try_place(drawing, label) {
                placing.keep_free(at, 2.2 * size);
                return;
            }
        }
    }
}

fn mark(drawing: &mut Drawing, spot: HeatSpot, frame: &HeatFrame) {
    let (HeatSpot::Probe(ProbeMark { at, .. })
    | HeatSpot::Mirrored(ProbeMark { at, .. })
    | HeatSpot::Here(at)
    | HeatSpot::Best(at)
    | HeatSpot::Start(at)) = spot;
    let center = frame.point(at);
    let [x, y] = center;
    let inside = (0..2).all(|k| (frame.min[k] - 0.5..=frame.max[k] + 0.5).contains(&center[k]));
    if let HeatSpot::Probe(_) = spot {
        cross(drawing, center, frame);
    }
    if !inside {
        return;
    }
    let mut ring = |radius: f32, filled: bool, middle: Role| {
        over_colors::ring(drawing, center, radius, filled, middle);
    };
    match spot {
        HeatSpot::Probe(mark) => ring(4.0, mark.exact, LIGHT),
        HeatSpot::Mirrored(mark) => ring(3.0, mark.exact, LIGHT),
        HeatSpot::Here(_) => ring(3.5, true, Role::Accent),
        HeatSpot::Start(_) => ring(4.0, false, LIGHT),
        HeatSpot::Best(_) => {
            for (half, role) in [(9.0, DARK), (7.5, LIGHT)] {
                let corners = vec![[x, y - half], [x + half, y], [x, y + half], [x - half, y]];
                drawing.fill(corners, role.into());
            }
        }
    }
}

/// Thin lines across the cells through a point, as far as they are in sight.
fn cross(drawing: &mut Drawing, [x, y]: Point, frame: &HeatFrame) {
    let ([left, top], [right, bottom]) = (frame.min, frame.max);
    let gap = 7.0;
    let mut pieces = Vec::new();
    if (left..=right).contains(&x) {
        pieces.push([[x, top], [x, (y - gap).clamp(top, bottom)]]);
        pieces.push([[x, (y + gap).clamp(top, bottom)], [x, bottom]]);
    }
    if (top..=bottom).contains(&y) {
        pieces.push([[left, y], [(x - gap).clamp(left, right), y]]);
        pieces.push([[(x + gap).clamp(left, right), y], [right, y]]);
    }
    for piece in pieces {
        for (width, ink) in [
            (2.6, Ink::from(DARK).faded(0.35)),
            (1.0, Ink::from(LIGHT).faded(0.85)),
        ] {
            drawing.line(piece.to_vec(), width, ink);
        }
    }
}
