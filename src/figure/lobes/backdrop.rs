//! Backdrop of the lobes: the half disc with its rings and angles, the grazing regions, the vectors.

use super::{LobeFrame, LobeSpec};
use crate::figure::drawing::{Anchor, Drawing, Item, Label, Point};
use crate::figure::mark::ProbeMark;
use crate::figure::palette::{Ink, Role};
use crate::figure::placing::Placing;
use crate::figure::scale::power_of_ten;
use crate::figure::text::RichText;
use crate::geom::limits::UNRELIABLE_THETA_DEG;
use std::f64::consts::FRAC_PI_2;

/// A drawing in the making.
pub(super) struct LobeCanvas<'a> {
    pub drawing: Drawing,
    pub placing: Placing,
    pub frame: &'a LobeFrame,
    pub font: f32,
}

impl<'a> LobeCanvas<'a> {
    pub fn new(frame: &'a LobeFrame, font: f32, size: [f32; 2]) -> Self {
        Self {
            drawing: Drawing::new(size),
            placing: Placing::default(),
            frame,
            font,
        }
    }

    /// A text in the size of the plot, without a halo.
    pub fn label(&self, text: RichText, pos: Point, anchor: Anchor, role: Role) -> Label {
        Label::new(text, pos, anchor, self.font, role)
    }

    /// Whether a label is all in the half disc.
    pub fn inside_disc(&self, label: &Label) -> bool {
        let [min, max] = label.bounds();
        let [x, y] = self.frame.origin;
        let reach = (x - min[0]).max(max[0] - x).hypot(y - min[1]);
        reach <= self.frame.radius && max[1] <= y
    }

    /// A point outside the rim, `gap` times the font size from it.
    fn outside(&self, theta: f64, gap: f32) -> Point {
        self.frame
            .at(theta, 1.0 + f64::from(gap * self.font / self.frame.radius))
    }
}

/// The half disc, the grazing regions, rings, rays and ticks.
pub(super) fn ground(canvas: &mut LobeCanvas) {
    let frame = canvas.frame;
    let grid = Ink::from(Role::Faint);
    let grazing = UNRELIABLE_THETA_DEG.to_radians();
    for side in [-1.0, 1.0] {
        let mut wedge = vec![frame.origin];
        wedge.extend(arc(frame, 1.0, side * grazing, side * FRAC_PI_2));
        canvas.drawing.fill(wedge, grid.faded(0.45));
    }
    let ticks = frame.axis.ticks(ring_count(frame));
    for tick in ticks.iter().filter(|tick| tick.position < 1.0 - 1e-6) {
        let ring = arc(frame, tick.position, -FRAC_PI_2, FRAC_PI_2);
        canvas.drawing.line(ring, 1.0, grid.faded(0.8));
    }
    for deg in (-90..=90_i32).step_by(10) {
        let theta = f64::from(deg).to_radians();
        let major = deg % 30 == 0;
        if major && deg.abs() < 90 {
            let ray = vec![frame.origin, frame.at(theta, 1.0)];
            canvas.drawing.line(ray, 1.0, grid.faded(0.8));
        }
        if major || frame.radius >= 90.0 {
            let inner = frame.at(
                theta,
                1.0 - if major { 6.0 } else { 3.5 } / f64::from(frame.radius),
            );
            let tick = vec![inner, frame.at(theta, 1.0)];
            canvas
                .drawing
                .line(tick, 1.0, Ink::from(Role::Muted).faded(0.8));
        }
    }
    let rim = arc(frame, 1.0, -FRAC_PI_2, FRAC_PI_2);
    canvas
        .drawing
        .line(rim, 1.0, Ink::from(Role::Muted).faded(0.7));
    for side in [-1.0, 1.0] {
        let at = frame.at(
            side * 84.8_f64.to_radians(),
            1.0 - f64::from(2.2 * canvas.font / frame.radius),
        );
        let mut label = canvas.label(
            RichText::literal(&format!("> {UNRELIABLE_THETA_DEG}°")),
            at,
            Anchor::CENTER,
            Role::Muted,
        );
        label.size = 0.85 * canvas.font;
        // The region is this high where the label is.
        if f64::from(frame.radius) * 0.8 * 10f64.to_radians().tan() > 1.4 * f64::from(canvas.font) {
            canvas.placing.try_place(&mut canvas.drawing, label);
        }
    }
    let surface = vec![
        frame.at(-FRAC_PI_2, 1.0),
        frame.origin,
        frame.at(FRAC_PI_2, 1.0),
    ];
    canvas.drawing.line(surface, 1.5, Role::Foreground.into());
}

/// n, and ωi, ωr of the active θi; with a probe ωo and ωh too. Names stand outside the rim. On paper n and every ωi.
pub(super) fn vectors(canvas: &mut LobeCanvas, spec: &LobeSpec) {
    if spec.still {
        vector(canvas, 0.0, "n", Role::Muted.into());
        // One name stands for all.
        for (lobe, theta_i) in spec.theta_i.iter().enumerate() {
            let name = if lobe == 0 { "ω_{i}" } else { "" };
            vector(canvas, -theta_i, name, Role::Accent.into());
        }
        return;
    }
    for theta_i in &spec.theta_i {
        canvas
            .placing
            .keep_free(canvas.frame.handle(*theta_i), HANDLE + 1.0);
    }
    let active = spec.theta_i.get(spec.active).copied();
    if let Some(theta_i) = active {
        vector(canvas, -theta_i, "ω_{i}", Role::Accent.into());
        if let Some(ProbeMark {
            at: theta_o,
            exact: true,
        }) = spec.probe
        {
            vector(canvas, theta_o, "ω_{o}", Role::Foreground.into());
            let theta_h = 0.5 * (theta_o - theta_i);
            vector(canvas, theta_h, "ω_{h}", Role::Muted.into());
        }
    }
    let quiet = Ink::from(Role::Muted);
    vector(canvas, 0.0, "n", quiet);
    if let Some(theta_i) = active {
        vector(canvas, theta_i, "ω_{r}", quiet);
    }
}

fn vector(canvas: &mut LobeCanvas, theta: f64, name: &str, ink: Ink) {
    let (tail, tip) = (canvas.frame.origin, canvas.frame.at(theta, 1.0));
    let head = (0.75 * canvas.font).max(7.0);
    canvas.drawing.arrow(tail, tip, 1.25, head, ink);
    if name.is_empty() {
        return;
    }
    let (dx, dy) = (theta.sin() as f32, -theta.cos() as f32);
    // Further out where another name is in the way, as two vectors may be one.
    for gap in [0.75, 1.0] {
        for shift in [0.0, 0.06, -0.06, 0.12, -0.12] {
            let shift = shift * 200.0 / f64::from(canvas.frame.radius.max(100.0));
            let at = canvas.outside(theta + shift, gap);
            let mut label = canvas.label(
                RichText::parse(name),
                at,
                Anchor::towards(-dx, -dy),
                ink.role,
            );
            label.size = 1.15 * canvas.font;
            if canvas.placing.try_place(&mut canvas.drawing, label) {
                return;
            }
        }
    }
}

/// Degrees outside the rim, where no name is.
pub(super) fn rim_labels(canvas: &mut LobeCanvas) {
    for deg in [90, 60, 30, 0, -30, -60, -90_i32] {
        let theta = f64::from(deg).to_radians();
        let (dx, dy) = (theta.sin() as f32, -theta.cos() as f32);
        let text = RichText::literal(&format!("{}°", deg.abs()));
        // Further out where a handle is.
        for gap in [0.45, 0.85] {
            let at = canvas.outside(theta, gap);
            let anchor = Anchor::towards(-dx, -dy);
            let mut label = canvas.label(text.clone(), at, anchor, Role::Muted);
            if deg.abs() == 90 {
                // Above the line of the surface: values of rings are below it.
                label.anchor.y = 0.9;
            }
            if canvas.placing.try_place(&mut canvas.drawing, label) {
                break;
            }
        }
    }
}

/// Values of the rings below the surface line, on both sides, from the rim inwards, and the one in the middle.
pub(super) fn ring_labels(canvas: &mut LobeCanvas) {
    let frame = canvas.frame;
    let below = |x: f32| [x, frame.origin[1] + 0.35 * canvas.font];
    let floor = if frame.axis.floor > 0.0 {
        format!("≤ {}", power_of_ten(frame.axis.floor))
    } else {
        "0".to_owned()
    };
    let middle = canvas.label(
        RichText::parse(&floor),
        below(frame.origin[0]),
        Anchor::TOP,
        Role::Muted,
    );
    let mut labels = vec![middle];
    for tick in frame.axis.ticks(ring_count(frame)).iter().rev() {
        for side in [1.0, -1.0] {
            let x = frame.origin[0] + side * frame.radius * tick.position as f32;
            labels.push(canvas.label(tick.label.clone(), below(x), Anchor::TOP, Role::Muted));
        }
    }
    for label in labels {
        let x = label.pos[0];
        let mark = vec![
            [x, frame.origin[1]],
            [x, frame.origin[1] + 0.3 * canvas.font],
        ];
        let gap = 0.25 * canvas.font;
        if canvas
            .placing
            .try_place_apart(&mut canvas.drawing, label, gap)
        {
            canvas.drawing.line(mark, 1.0, Role::Muted.into());
        }
    }
}

/// Radius of the active handle in points; the others are smaller.
const HANDLE: f32 = 5.5;

/// Handles by which the lights can be dragged.
pub(super) fn handles(canvas: &mut LobeCanvas, spec: &LobeSpec) {
    for (lobe, theta_i) in spec.theta_i.iter().enumerate() {
        let active = lobe == spec.active;
        let role = if active { Role::Accent } else { Role::Muted };
        canvas.drawing.items.push(Item::Dot {
            center: canvas.frame.handle(*theta_i),
            radius: if active { HANDLE } else { 4.0 },
            ink: if active { role } else { Role::Background }.into(),
            outline: Some((1.5, if active { Role::Background } else { role }.into())),
        });
    }
}

fn ring_count(frame: &LobeFrame) -> usize {
    ((frame.radius / 42.0) as usize).clamp(2, 6)
}

/// Points of a circle between two signed angles, close enough to look round.
fn arc(frame: &LobeFrame, position: f64, from: f64, to: f64) -> Vec<Point> {
    let length = f64::from(frame.radius) * position * (to - from).abs();
    let steps = (length / 5.0).ceil().clamp(8.0, 240.0);
    (0..=steps as i32)
        .map(|k| frame.at(from + (to - from) * f64::from(k) / steps, position))
        .collect()
}
