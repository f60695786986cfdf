//! What stands around the lobes: rings, angles, the grazing shade, vectors, names, the legend.

use super::frame::HANDLE;
use super::{Curve, LobeFrame, LobeSpec, Sample};
use crate::figure::drawing::{Drawing, Ink, Item, Point, Role};
use crate::figure::scale::RadialScale;
use crate::figure::text::RichText;
use std::f64::consts::{FRAC_PI_2, PI};

/// Where grazing begins.
const GRAZING_DEG: f64 = 80.0;
/// Radius in points below which the plot says less.
const SMALL: f32 = 150.0;
/// Font sizes of labels and names.
const LABEL: f32 = 11.0;
const NAME: f32 = 13.5;

pub(super) fn draw_ground(drawing: &mut Drawing, frame: &LobeFrame, spec: &LobeSpec) {
    let roomy = frame.radius >= SMALL;
    shade_grazing(drawing, frame, roomy);
    let grid = Role::Faint.with_opacity(0.45);
    for tick in spec.scale.ticks(frame.limit) {
        let length = spec.scale.length(tick.value, frame.limit) as f32;
        drawing.line(arc(frame, length, -FRAC_PI_2, FRAC_PI_2), 0.75, grid);
    }
    drawing.line(
        arc(frame, 1.0, -FRAC_PI_2, FRAC_PI_2),
        1.0,
        Role::Faint.ink(),
    );
    let step = if roomy { 10 } else { 30 };
    for deg in (-90..=90i32).step_by(step) {
        let theta = f64::from(deg).to_radians();
        let major = deg % 30 == 0;
        if major && deg.abs() != 90 {
            drawing.line(vec![frame.origin, frame.at(theta, 1.0)], 0.75, grid);
        }
        let inner = 1.0 - if major { 5.0 } else { 3.0 } / frame.radius;
        drawing.line(
            vec![frame.at(theta, inner), frame.at(theta, 1.0)],
            1.0,
            Role::Faint.ink(),
        );
        if major {
            let anchor = [
                0.5 - 0.5 * theta.sin() as f32,
                0.5 + 0.5 * theta.cos() as f32,
            ];
            let at = frame.at(theta, 1.0 + 6.0 / frame.radius);
            drawing.text(
                at,
                anchor,
                LABEL,
                &format!("{}°", deg.abs()),
                Role::Muted.ink(),
            );
        }
    }
    draw_surface(drawing, frame);
    draw_ring_labels(drawing, frame, spec);
    let title = axis_title(spec);
    let below = [0.5 * drawing.size[0], frame.origin[1] + 21.0];
    drawing.text(below, [0.5, 0.0], LABEL + 0.5, &title, Role::Muted.ink());
}

fn axis_title(spec: &LobeSpec) -> String {
    let cosine = if spec.with_cosine { " cos θ_{i}" } else { "" };
    format!(
        "f_{{r}}{cosine}  [sr^{{−1}}],  {},  {} scale",
        spec.channel.name(),
        spec.scale.phrase()
    )
}

/// The wedges past 80° on both sides, where measurements are least reliable and models go wrong.
fn shade_grazing(drawing: &mut Drawing, frame: &LobeFrame, roomy: bool) {
    let start = GRAZING_DEG.to_radians();
    for side in [-1.0, 1.0] {
        let mut points = vec![frame.origin];
        points.extend((0..=8).map(|k| {
            let theta = start + (FRAC_PI_2 - start) * f64::from(k) / 8.0;
            frame.at(side * theta, 1.0)
        }));
        drawing.items.push(Item::Fill {
            points,
            ink: Role::Faint.with_opacity(0.22),
        });
        if roomy {
            let at = frame.at(side * 85f64.to_radians(), 0.995);
            let anchor = [0.5 + 0.5 * side as f32, 0.5];
            drawing.text(
                at,
                anchor,
                LABEL - 1.5,
                " > 80° ",
                Role::Muted.with_opacity(0.9),
            );
        }
    }
}

fn draw_surface(drawing: &mut Drawing, frame: &LobeFrame) {
    let [x, y] = frame.origin;
    let half = frame.radius;
    drawing.line(
        vec![[x - half, y], [x + half, y]],
        1.5,
        Role::Foreground.with_opacity(0.8),
    );
}

/// Values of the rings along the surface, to the right, where they cross no label of the rim.
fn draw_ring_labels(drawing: &mut Drawing, frame: &LobeFrame, spec: &LobeSpec) {
    let mut free_from = frame.origin[0] + 6.0;
    for tick in spec.scale.ticks(frame.limit) {
        let length = spec.scale.length(tick.value, frame.limit) as f32;
        let x = frame.origin[0] + frame.radius * length;
        let width = RichText::parse(&tick.label).estimated_width(LABEL - 1.0);
        let y = frame.origin[1];
        drawing.line(vec![[x, y], [x, y + 4.0]], 1.0, Role::Muted.ink());
        if x - 0.5 * width > free_from && length > 0.02 {
            drawing.text(
                [x, y + 6.0],
                [0.5, 0.0],
                LABEL - 1.0,
                &tick.label,
                Role::Muted.ink(),
            );
            free_from = x + 0.5 * width + 4.0;
        }
    }
    let centre = if spec.scale == RadialScale::Log {
        format!(
            "≤ {}",
            crate::figure::scale::label(spec.scale.value(0.0, frame.limit), true)
        )
    } else {
        "0".to_string()
    };
    drawing.text(
        [frame.origin[0], frame.origin[1] + 6.0],
        [0.5, 0.0],
        LABEL - 1.0,
        &centre,
        Role::Muted.ink(),
    );
}

pub(super) fn draw_vectors(drawing: &mut Drawing, frame: &LobeFrame, spec: &LobeSpec) {
    for (index, theta_i) in spec.theta_i.iter().enumerate() {
        if index != spec.active {
            handle(drawing, frame, *theta_i, Role::Muted.with_opacity(0.7));
        }
    }
    let Some(theta_i) = spec.theta_i.get(spec.active).copied() else {
        return;
    };
    let ink = Role::Foreground.with_opacity(0.85);
    arrow(drawing, frame, 0.0, 0.62, ink);
    name(drawing, frame, 0.0, 0.62, "n", ink);
    arrow(drawing, frame, theta_i, 0.62, ink);
    if theta_i.to_degrees() > 8.0 {
        name(drawing, frame, theta_i, 0.62, "ω_{r}", ink);
    }
    arrow(drawing, frame, -theta_i, HANDLE - 5.0 / frame.radius, ink);
    handle(drawing, frame, theta_i, Role::Foreground.ink());
    name(drawing, frame, -theta_i, 0.86, "ω_{i}", ink);
    if let Some(theta_o) = spec.probe_theta_o {
        let accent = Role::Accent.ink();
        arrow(drawing, frame, theta_o, 0.8, accent);
        name(drawing, frame, theta_o, 0.8, "ω_{o}", accent);
        let theta_h = 0.5 * (theta_o - theta_i);
        arrow(drawing, frame, theta_h, 0.45, accent);
        name(drawing, frame, theta_h, 0.45, "ω_{h}", accent);
    }
}

/// Where a light can be taken.
fn handle(drawing: &mut Drawing, frame: &LobeFrame, theta_i: f64, ink: Ink) {
    let center = frame.at(-theta_i, HANDLE);
    drawing.items.push(Item::Dot {
        center,
        radius: 5.0,
        ink,
    });
    drawing.items.push(Item::Dot {
        center,
        radius: 2.5,
        ink: Role::Background.ink(),
    });
}

fn arrow(drawing: &mut Drawing, frame: &LobeFrame, theta: f64, length: f32, ink: Ink) {
    let head = 8.0 / frame.radius;
    drawing.line(
        vec![frame.origin, frame.at(theta, length - 0.7 * head)],
        1.25,
        ink,
    );
    let tip = frame.at(theta, length);
    let base = frame.at(theta, length - head);
    let (sin, cos) = theta.sin_cos();
    let side = |sign: f32| -> Point {
        [
            base[0] + sign * 3.2 * cos as f32,
            base[1] + sign * 3.2 * sin as f32,
        ]
    };
    drawing.items.push(Item::Fill {
        points: vec![tip, side(1.0), side(-1.0)],
        ink,
    });
}

/// A name beside the tip of an arrow, on its outer side.
fn name(drawing: &mut Drawing, frame: &LobeFrame, theta: f64, length: f32, markup: &str, ink: Ink) {
    let tip = frame.at(theta, length);
    let side = if theta < -1e-9 { -1.0 } else { 1.0 };
    let (sin, cos) = theta.sin_cos();
    let offset = 11.0;
    let at = [
        tip[0] + side * offset * cos as f32,
        tip[1] + side * offset * sin as f32,
    ];
    drawing.text_on_ground(at, [0.5, 0.5], NAME, markup, ink);
}

/// θi at the highest point of each lobe, where there is room.
pub(super) fn draw_lobe_names(
    drawing: &mut Drawing,
    frame: &LobeFrame,
    spec: &LobeSpec,
    lobes: &[Vec<Vec<Sample>>],
) {
    let Some(first) = lobes.first() else { return };
    let mut taken: Vec<Point> = Vec::new();
    for (theta_i, lobe) in spec.theta_i.iter().zip(first) {
        let highest = lobe
            .iter()
            .filter_map(|(theta_o, value)| Some((*theta_o, (*value)?)))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((theta_o, value)) = highest else {
            continue;
        };
        let length = spec.scale.length(value, frame.limit).min(1.0) as f32;
        let at = frame.at(
            theta_o,
            (length + 15.0 / frame.radius).min(1.0 - 30.0 / frame.radius),
        );
        let free = taken
            .iter()
            .all(|other| (other[0] - at[0]).hypot(other[1] - at[1]) > 26.0);
        if free && length > 0.15 {
            let label = format!("{:.0}°", theta_i.to_degrees());
            drawing.text_on_ground(
                at,
                [0.5, 0.5],
                LABEL,
                &label,
                Role::Foreground.with_opacity(0.9),
            );
            taken.push(at);
        }
    }
}

/// A line and a name per curve, from the upper left corner.
pub(super) fn draw_legend(drawing: &mut Drawing, curves: &[Curve<'_>]) {
    let [width, _] = drawing.size;
    for (row, curve) in curves.iter().enumerate() {
        let y = 9.0 + 17.0 * row as f32;
        let ink = Role::Series(curve.series).ink();
        drawing.stroke(vec![[4.0, y], [30.0, y]], 2.0, curve.dashed, ink);
        let room = ((0.36 * width - 36.0) / (0.54 * (LABEL + 0.5))).max(6.0) as usize;
        drawing.text(
            [36.0, y],
            [0.0, 0.5],
            LABEL + 0.5,
            &elided(&curve.label, room),
            Role::Foreground.ink(),
        );
    }
}

/// At most `room` letters, the end kept out.
fn elided(label: &str, room: usize) -> String {
    if label.chars().count() <= room {
        return label.to_string();
    }
    label
        .chars()
        .take(room.saturating_sub(1))
        .chain(['…'])
        .collect()
}

fn arc(frame: &LobeFrame, length: f32, from: f64, to: f64) -> Vec<Point> {
    let steps = ((to - from) / PI * 96.0).ceil().max(2.0) as i32;
    (0..=steps)
        .map(|k| frame.at(from + (to - from) * f64::from(k) / f64::from(steps), length))
        .collect()
}
