//! The order in which a disc is drawn: cells, hatching, rings and spokes with their names, colour bar; and the marks.

use super::{DiscField, DiscFrame, DiscPlot, DiscSpec};
use crate::figure::drawing::{Anchor, Drawing, Item, LINE_HEIGHT, Label, Point, font_size};
use crate::figure::heatmap::{
    Cell, ColorBar, ColorScale, draw_key, fitting_title, hatch, image, key_width_em,
};
use crate::figure::over_colors::{self, LIGHT};
use crate::figure::palette::{Ink, Role};
use crate::figure::placing::Placing;
use crate::figure::text::RichText;
use crate::geom::limits::{UNRELIABLE_THETA, UNRELIABLE_THETA_DEG};
use crate::geom::{direction, mirror};
use std::f64::consts::FRAC_PI_2;

/// Rings of equal θo in degrees, besides the dashed one and the rim.
const RINGS_DEG: [f64; 2] = [30.0, 60.0];
/// Degrees between spokes of equal φo.
const SPOKE_DEG: usize = 30;
/// θo in degrees at which spokes begin: the middle stays free.
const SPOKES_FROM_DEG: f64 = 10.0;
/// φo in degrees at which rings are named: between two spokes, away from light and mirror direction.
const NAMES_AT_DEG: f64 = 75.0;
/// Corners of a ring.
const CORNERS: usize = 120;
/// Room outside the rim for the names of spokes, in units of the font size.
const RIM_EM: f32 = 2.3;

/// Sizes and places in points.
struct DiscLayout {
    font: f32,
    frame: DiscFrame,
    bar: ColorBar,
    title: (RichText, Point),
}

impl DiscLayout {
    fn new(spec: &DiscSpec, name: &str, colors: &ColorScale, [width, height]: [f32; 2]) -> Self {
        let font = font_size([width, height]);
        let (pad, line) = (0.6 * font, LINE_HEIGHT * font);
        let top = pad + line + 1.4 * line;
        let bottom = 1.4 * line + pad;
        let tall = (height - top - bottom).max(8.0);
        let bar = ColorBar::new(colors, width, tall, font);
        let aside = RIM_EM * font;
        let wide = (width - 2.0 * aside - bar.width() - pad).max(8.0);
        let diameter = wide.min(tall);
        let center = [aside + 0.5 * pad + 0.5 * wide, top + 0.5 * tall];
        Self {
            font,
            frame: DiscFrame {
                center,
                radius: 0.5 * diameter,
                projection: spec.projection,
            },
            bar,
            title: (
                fitting_title(&titles(spec, name), (width - 2.0 * pad) / font),
                [pad, pad + 0.5 * line],
            ),
        }
    }
}

fn titles(spec: &DiscSpec, name: &str) -> Vec<String> {
    let unit = if spec.shown.is_amount() {
        " [sr^{−1}]"
    } else {
        ""
    };
    let degrees = (10.0 * spec.theta_i.to_degrees()).round() / 10.0;
    let (phrase, channel) = (spec.shown.phrase(), spec.channel.name());
    let what = format!("f_{{r}}{}", spec.cosine.markup());
    vec![
        format!("{name}, {phrase}: {what}{unit}, {channel}, θ_{{i}} = {degrees}°"),
        format!("{name}, {phrase}, {channel}, θ_{{i}} = {degrees}°"),
        format!("{name}, {phrase}, θ_{{i}} = {degrees}°"),
        format!("{phrase}, θ_{{i}} = {degrees}°"),
    ]
}

pub(super) fn draw(spec: &DiscSpec, name: &str, field: &DiscField, size: [f32; 2]) -> DiscPlot {
    let colors = field.colors(spec);
    let layout = DiscLayout::new(spec, name, &colors, size);
    let (frame, font) = (layout.frame, layout.font);
    let mut drawing = Drawing::new(size);
    let mut placing = Placing::default();
    let square = frame.square();
    drawing
        .items
        .extend(image(&field.cells, &colors, &square, true));
    let muted = Ink::from(Role::Muted);
    hatch(&mut drawing, &field.cells, &square, muted.faded(0.9));
    net(&mut drawing, &frame);
    let names = [RINGS_DEG[0], RINGS_DEG[1], UNRELIABLE_THETA_DEG];
    for degrees in names.into_iter().filter(|_| !is_small(&frame, font)) {
        name_ring(&mut drawing, &mut placing, &frame, degrees, font);
    }
    name_spokes(&mut drawing, &mut placing, &frame, font);
    let (title, at) = layout.title;
    let label = Label::new(title, at, Anchor::LEFT, font, Role::Foreground);
    placing.place(&mut drawing, label);
    let side = [1.0, -1.0].map(|y| frame.at([1.0, y]));
    let beside = side.map(|[x, y]| [x + RIM_EM * font, y]);
    let bar_title = spec.shown.bar_title(spec.cosine, spec.channel, spec.scale);
    layout.bar.draw(&mut drawing, &colors, &bar_title, beside);
    let foot = size[1] - 0.6 * font - 0.5 * LINE_HEIGHT * font;
    if spec.theta_i > UNRELIABLE_THETA {
        let text = RichText::literal(&format!("light beyond {UNRELIABLE_THETA_DEG}°"));
        let at = [0.6 * font, foot];
        placing.try_place(
            &mut drawing,
            Label::new(text, at, Anchor::LEFT, font, Role::Muted),
        );
    }
    const MISSING: &str = "not measured";
    let key = key_width_em(MISSING) * font;
    let has_missing = field.cells.cells.contains(&Cell::Missing);
    if has_missing && key + 2.0 * font < 0.5 * size[0] {
        draw_key(
            &mut drawing,
            MISSING,
            [size[0] - 0.6 * font - key, foot],
            font,
        );
    }
    if field.cells.values().next().is_none() {
        let text = RichText::literal("No value under this light.");
        let mut label = Label::new(text, frame.center, Anchor::CENTER, font, Role::Muted);
        label.halo = true;
        placing.place(&mut drawing, label);
    }
    DiscPlot { drawing, frame }
}

/// Whether a disc has no room for more than the names of light and axes.
fn is_small(frame: &DiscFrame, font: f32) -> bool {
    frame.radius < 4.5 * font
}

/// A ring of equal θo as a closed polyline.
fn ring(frame: &DiscFrame, theta: f64) -> Vec<Point> {
    let corner = |k: usize| {
        let phi = std::f64::consts::TAU * k as f64 / CORNERS as f64;
        let (radius, (sin, cos)) = (frame.projection.radius(theta), phi.sin_cos());
        frame.at([radius * cos, radius * sin])
    };
    (0..=CORNERS).map(corner).collect()
}

/// Rings of equal θo, spokes of equal φo, the line at which data stop to be relied on, and the horizon.
fn net(drawing: &mut Drawing, frame: &DiscFrame) {
    const FAINT: f32 = 0.45;
    for degrees in RINGS_DEG {
        over_colors::line(drawing, ring(frame, degrees.to_radians()), 0.8, None, FAINT);
    }
    for degrees in (0..360).step_by(SPOKE_DEG) {
        let at = |theta: f64| frame.point(direction(theta, (degrees as f64).to_radians()));
        let spoke = vec![at(SPOKES_FROM_DEG.to_radians()), at(FRAC_PI_2)];
        over_colors::line(drawing, spoke, 0.8, None, FAINT);
    }
    let dash = Some([5.0, 4.0]);
    over_colors::line(drawing, ring(frame, UNRELIABLE_THETA), 1.0, dash, 0.9);
    drawing.line(ring(frame, FRAC_PI_2), 1.5, Ink::from(Role::Muted));
}

/// Writes θo on a ring.
fn name_ring(
    drawing: &mut Drawing,
    placing: &mut Placing,
    frame: &DiscFrame,
    degrees: f64,
    font: f32,
) {
    let at = frame.point(direction(degrees.to_radians(), NAMES_AT_DEG.to_radians()));
    let text = if degrees == RINGS_DEG[0] {
        format!("θ_{{o}} = {degrees}°")
    } else {
        format!("{degrees}°")
    };
    let text = RichText::parse(&text);
    let mut label = Label::new(text, at, Anchor::CENTER, 0.85 * font, Role::Foreground);
    label.halo = true;
    placing.try_place(drawing, label);
}

/// Writes φo outside the rim, at every third spoke first.
fn name_spokes(drawing: &mut Drawing, placing: &mut Placing, frame: &DiscFrame, font: f32) {
    let outside = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let reach = 1.0 + 0.5 * f64::from(font / frame.radius);
        let anchor = Anchor {
            x: 0.5 - 0.5 * cos as f32,
            y: 0.5 + 0.5 * sin as f32,
        };
        (frame.at([reach * cos, reach * sin]), anchor)
    };
    let mut put = |text: &str, degrees: f64| {
        let (at, anchor) = outside(degrees);
        let text = RichText::parse(text);
        let label = Label::new(text, at, anchor, 0.9 * font, Role::Muted);
        placing.try_place(drawing, label);
    };
    let (quarters, others): (Vec<usize>, Vec<usize>) = (0..360)
        .step_by(SPOKE_DEG)
        .partition(|degrees| degrees % 90 == 0);
    for degrees in quarters {
        put(&format!("{degrees}°"), degrees as f64);
    }
    put("φ_{o}", 0.5 * SPOKE_DEG as f64);
    for degrees in others.into_iter().filter(|_| !is_small(frame, font)) {
        put(&format!("{degrees}°"), degrees as f64);
    }
}

pub(super) fn marks(spec: &DiscSpec, frame: &DiscFrame, size: [f32; 2]) -> Drawing {
    let mut drawing = Drawing::new(size);
    let font = font_size(size);
    let wi = spec.wi();
    let wr = mirror(wi);
    let (light, peak) = (frame.point(wi), frame.point(wr));
    let apart = (light[0] - peak[0]).hypot(light[1] - peak[1]) > 3.0 * font;
    let name = |drawing: &mut Drawing, text: &str, at: Point| {
        // Towards the middle there is always room.
        let inwards = [0, 1].map(|k| frame.center[k] - at[k]);
        let length = inwards[0].hypot(inwards[1]).max(1.0);
        let shift = if length > 2.5 * font {
            inwards.map(|x| 1.5 * font * x / length)
        } else {
            [0.0, -1.4 * font]
        };
        let pos = [at[0] + shift[0], at[1] + shift[1]];
        let text = RichText::parse(text);
        let mut label = Label::new(text, pos, Anchor::CENTER, font, Role::Foreground);
        label.halo = true;
        drawing.items.push(Item::Text(label));
    };
    if apart {
        over_colors::ring(&mut drawing, peak, 3.0, false, LIGHT);
        name(&mut drawing, "ω_{r}", peak);
    }
    over_colors::ring(&mut drawing, light, 5.0, true, Role::Accent);
    name(&mut drawing, "ω_{i}", light);
    if let Some(mark) = spec.probe {
        let [theta_o, phi_o] = mark.at;
        let at = frame.point(direction(theta_o, phi_o));
        over_colors::ring(&mut drawing, at, 4.0, mark.exact, LIGHT);
    }
    drawing
}
