//! Labels over the lobes in space: title, legend, names and heads of vectors, angles, values, the probe.

use super::camera::{Camera, SpaceProjection};
use super::lobes::Lobes;
use super::space::{CIRCLES_DEG, VECTOR};
use crate::figure::drawing::{Anchor, Drawing, LINE_HEIGHT, Label, Point, font_size};
use crate::figure::legend::{LegendEntry, SWATCH_EM, draw_entry};
use crate::figure::mark::probe_dot;
use crate::figure::palette::{Ink, Role};
use crate::figure::placing::Placing;
use crate::figure::text::{RichText, elided};
use crate::geom::{direction, mirror};
use glam::DVec3;

/// The flat part of the picture, and how space is seen under it.
#[derive(Clone, Debug)]
pub struct Overlay {
    /// Over what is in space.
    pub drawing: Drawing,
    /// Places of the subjects' names.
    pub legend: Vec<LegendEntry>,
    /// Map from space to points of the canvas.
    pub projection: SpaceProjection,
}

impl Overlay {
    /// Overlay of some lobes, with the direction `wo` of the probe, on a canvas of `size` points.
    pub fn new(lobes: &Lobes, camera: Camera, wo: Option<DVec3>, size: [f32; 2]) -> Self {
        let [width, height] = size;
        let font = font_size([width, height]);
        let mut canvas = LabelCanvas {
            drawing: Drawing::new(size),
            placing: Placing::default(),
            font,
        };
        let below = title_and_legend(&mut canvas, lobes);
        let projection = SpaceProjection::new(camera, [0.0, below.1], size);
        vectors(&mut canvas, lobes, &projection, wo);
        values(&mut canvas, lobes, &projection);
        circles(&mut canvas, &projection);
        if let Some(wo) = wo {
            probe(&mut canvas, lobes, &projection, wo);
        }
        if lobes.meshes().all(|mesh| mesh.triangles.is_empty()) {
            nothing(&mut canvas, lobes.list.is_empty());
        }
        Self {
            drawing: canvas.drawing,
            legend: below.0,
            projection,
        }
    }
}

struct LabelCanvas {
    drawing: Drawing,
    placing: Placing,
    font: f32,
}

impl LabelCanvas {
    fn label(&self, text: RichText, pos: Point, anchor: Anchor, role: Role) -> Label {
        Label::new(text, pos, anchor, self.font, role)
    }
}

/// Title at the left, names at the right, or under each other; and where they end.
fn title_and_legend(canvas: &mut LabelCanvas, lobes: &Lobes) -> (Vec<LegendEntry>, f32) {
    let [width, _] = canvas.drawing.size;
    let font = canvas.font;
    let (pad, line) = (0.7 * font, LINE_HEIGHT * font);
    let shape = &lobes.shape;
    let cosine = shape.cosine.markup();
    let (channel, scale) = (shape.channel.name(), shape.scale.phrase());
    let degrees = (10.0 * shape.theta_i.to_degrees()).round() / 10.0;
    let start = format!("f_{{r}}{cosine} [sr^{{−1}}], {channel}, {scale}");
    let long = RichText::parse(&format!("{start} scale, θ_{{i}} = {degrees}°"));
    let room = (width - 2.0 * pad) / font;
    let title = if long.width_em() <= room {
        long
    } else {
        RichText::parse(&format!("{start}, θ_{{i}} = {degrees}°"))
    };
    let title_width = font * title.width_em();
    let label = canvas.label(title, [pad, pad + 0.5 * line], Anchor::LEFT, Role::Muted);
    canvas.placing.place(&mut canvas.drawing, label);
    let names: Vec<RichText> = lobes
        .list
        .iter()
        .map(|lobe| {
            elided(
                &lobe.subject.label,
                (0.5 * room - SWATCH_EM).clamp(3.0, 24.0),
            )
        })
        .collect();
    let widest = names.iter().map(RichText::width_em).fold(0.0, f32::max);
    let block = font * (SWATCH_EM + widest);
    // In the corner where it is free, else in a row under the title.
    let beside = title_width + block + 3.0 * pad <= width;
    let (mut x, mut y) = if beside {
        (width - pad - block, pad + 0.5 * line)
    } else {
        (pad, pad + 1.5 * line)
    };
    let mut legend = Vec::new();
    for (index, (lobe, name)) in lobes.list.iter().zip(&names).enumerate() {
        if name.runs.is_empty() {
            continue;
        }
        let entry_width = font * (SWATCH_EM + name.width_em() + 1.5);
        if !beside && x > pad && x + entry_width > width {
            (x, y) = (pad, y + line);
        }
        let (entry, label) = draw_entry(
            &mut canvas.drawing,
            index,
            &lobe.subject,
            name,
            [x, y],
            font,
        );
        canvas.placing.place(&mut canvas.drawing, label);
        legend.push(entry);
        if beside {
            y += line;
        } else {
            x += entry_width;
        }
    }
    let end = if beside { pad + line } else { y + 0.5 * line };
    (legend, end)
}

/// Heads of the vectors and their names.
fn vectors(
    canvas: &mut LabelCanvas,
    lobes: &Lobes,
    projection: &SpaceProjection,
    wo: Option<DVec3>,
) {
    let wi = lobes.wi();
    let named = [("n", DVec3::Z), ("ω_{i}", wi), ("ω_{r}", mirror(wi))];
    let named = named.into_iter().chain(wo.map(|wo| ("ω_{o}", wo)));
    for (name, w) in named {
        let (foot, tip) = (projection.point(DVec3::ZERO), projection.point(VECTOR * w));
        let (dx, dy) = (tip[0] - foot[0], tip[1] - foot[1]);
        let length = dx.hypot(dy);
        let (ux, uy) = if length > 1.0 {
            (dx / length, dy / length)
        } else {
            (0.0, -1.0)
        };
        let head = 0.8 * canvas.font;
        if length > head {
            let tail = [tip[0] - 1.01 * head * ux, tip[1] - 1.01 * head * uy];
            let ink = Ink::from(Role::Foreground);
            canvas.drawing.arrow(tail, tip, 1.5, head, ink);
        }
        let gap = 0.35 * canvas.font;
        let pos = [tip[0] + gap * ux, tip[1] + gap * uy];
        let label = canvas.label(
            RichText::parse(name),
            pos,
            Anchor::towards(-ux, -uy),
            Role::Foreground,
        );
        canvas.placing.try_place(&mut canvas.drawing, label);
    }
}

/// Values of the rings of the plane of incidence, along the surface at the right.
fn values(canvas: &mut LabelCanvas, lobes: &Lobes, projection: &SpaceProjection) {
    for tick in lobes.axis.ticks(4).into_iter().rev() {
        let mut pos = projection.point(tick.position * DVec3::X);
        pos[1] += 0.3 * canvas.font;
        let mut label = canvas.label(tick.label, pos, Anchor::TOP, Role::Muted);
        label.size = 0.9 * canvas.font;
        label.halo = true;
        canvas.placing.try_place(&mut canvas.drawing, label);
    }
}

/// Angles of the circles of the surface, on whichever side of the plane of incidence is nearer to the eye.
fn circles(canvas: &mut LabelCanvas, projection: &SpaceProjection) {
    let towards_eye = projection.view(DVec3::Y).z.signum();
    // One beside the other, as the outer circles are close together.
    for (degrees, aside) in CIRCLES_DEG.into_iter().zip([0.0, 0.0, 0.55]) {
        let theta = degrees.to_radians();
        let azimuth = towards_eye * (std::f64::consts::FRAC_PI_2 + aside);
        let on_surface = direction(theta, azimuth).with_z(0.0);
        let pos = projection.point(on_surface);
        let mut label = canvas.label(
            RichText::literal(&format!("{degrees:.0}°")),
            pos,
            Anchor::CENTER,
            Role::Muted,
        );
        label.size = 0.85 * canvas.font;
        label.halo = true;
        canvas.placing.try_place(&mut canvas.drawing, label);
    }
}

/// A dot on every lobe towards `wo`.
fn probe(canvas: &mut LabelCanvas, lobes: &Lobes, projection: &SpaceProjection, wo: DVec3) {
    for lobe in lobes.list.iter().filter(|lobe| !lobe.subject.hidden) {
        let Some(value) = lobes.shape.value(&lobe.subject.source, wo) else {
            continue;
        };
        let radius = lobes.axis.position(value).min(1.0);
        let center = projection.point(radius * wo);
        let role = Role::Series(lobe.subject.series);
        let dot = probe_dot(center, role, true);
        canvas.drawing.items.push(dot);
    }
}

/// Why there is nothing to see.
fn nothing(canvas: &mut LabelCanvas, no_subjects: bool) {
    let text = if no_subjects {
        "Open a material to see its lobes."
    } else {
        "Nothing to show at this angle."
    };
    let [width, height] = canvas.drawing.size;
    let label = canvas.label(
        RichText::literal(text),
        [0.5 * width, 0.5 * height],
        Anchor::CENTER,
        Role::Muted,
    );
    canvas.placing.place(&mut canvas.drawing, label);
}
