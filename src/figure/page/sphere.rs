//! A sphere on paper: a picture, and words and a bar that say what it is.

use super::panel_io::{PanelDrawing, PanelInput};
use super::spec::{PageSpec, SphereShow, SphereSpec, ViewSpec};
use crate::figure::drawing::{Anchor, Drawing, Item, Label, Picture, font_size};
use crate::figure::palette::Role;
use crate::figure::sphere_image::{
    PIXEL, SphereSource, error_colors, error_names, error_ticks, error_unit, render_part,
};
use crate::figure::subject::{Look, Source, Subject};
use crate::figure::text::RichText;
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;
use crate::geom::sphere_error::SphereError;

/// Pixels on a side at most.
const MOST: usize = 4096;

pub(super) fn sphere(spec: &SphereSpec, input: &PanelInput) -> PanelDrawing {
    let [width, height] = input.size;
    let font = font_size(input.size);
    let mut drawing = Drawing::new(input.size);
    let Some(source) = source(spec, input) else {
        let text = RichText::literal("Nothing to show.");
        let middle = [0.5 * width, 0.5 * height];
        let label = Label::new(text, middle, Anchor::CENTER, font, Role::Muted);
        drawing.items.push(Item::Text(label));
        return drawn(drawing);
    };
    // A bar stands at the right.
    let bar = match spec.show {
        SphereShow::Error(_) => 4.5 * font,
        _ => 0.0,
    };
    let side = (width - bar).min(height).max(4.0);
    let min = [0.5 * (width - bar - side), 0.5 * (height - side)];
    let max = [min[0] + side, min[1] + side];
    let size = ((side * input.density).ceil() as usize).clamp(1, MOST);
    let picture = render_part(&source, &spec.view, spec.sight, size);
    drawing.items.push(Item::Image(Picture {
        min,
        max,
        width: size,
        height: size,
        rgba: picture.to_rgba8().into(),
        smooth: true,
    }));
    let mut word = |text: &str, x: f32, anchor: f32| {
        let anchor = Anchor { x: anchor, y: 0.0 };
        let text = RichText::literal(text);
        let label = Label::new(text, [x, min[1]], anchor, 0.9 * font, Role::Muted);
        drawing.items.push(Item::Text(label));
    };
    match spec.show {
        SphereShow::Measured | SphereShow::Model => {}
        SphereShow::Split => {
            word("measured", min[0], 0.0);
            word("model", max[0], 1.0);
            let split = spec.sight.zoom * (spec.split - spec.sight.center[0]);
            if split.abs() <= 1.0 {
                let x = min[0] + 0.5 * side * (1.0 + split as f32);
                let line = vec![[x, min[1]], [x, max[1]]];
                drawing.line(line, 1.0, Role::Muted.into());
            }
        }
        SphereShow::Error(error) => {
            word(error_names(error)[0], min[0], 0.0);
            let stops = spec.view.exposure_stops;
            let top = [max[0] + font, min[1] + 1.6 * font];
            draw_bar(
                &mut drawing,
                error,
                stops,
                [top, [top[0] + font, max[1]]],
                font,
            );
        }
    }
    drawn(drawing)
}

fn drawn(drawing: Drawing) -> PanelDrawing {
    PanelDrawing {
        drawing,
        ..PanelDrawing::default()
    }
}

/// The sphere of a page that has nothing else on it, its lights, and the part in sight.
pub fn only_sphere(
    page: &PageSpec,
    subjects: &[Subject],
) -> Option<(SphereSource, SphereView, Sight)> {
    let mut panels = page.rows.iter().flat_map(|row| &row.panels);
    let (Some(panel), None) = (panels.next(), panels.next()) else {
        return None;
    };
    let ViewSpec::Sphere(spec) = &panel.view else {
        return None;
    };
    let of_panel = || panel.subjects.iter().filter_map(|at| subjects.get(*at));
    let of = |measured| {
        let found = of_panel().find(|s| (s.look == Look::Measured) == measured);
        found.map(|subject| subject.source.clone())
    };
    Some((source_of(spec, of)?, spec.view.clone(), spec.sight))
}

fn source(spec: &SphereSpec, input: &PanelInput) -> Option<SphereSource> {
    source_of(spec, |measured| input.source(measured).cloned())
}

fn source_of(spec: &SphereSpec, of: impl Fn(bool) -> Option<Source>) -> Option<SphereSource> {
    Some(match spec.show {
        SphereShow::Measured => SphereSource::One(of(true)?),
        SphereShow::Model => SphereSource::One(of(false)?),
        SphereShow::Split => SphereSource::Split {
            left: of(true)?,
            right: of(false)?,
            at: spec.split,
        },
        SphereShow::Error(error) => SphereSource::Compared {
            measured: of(true)?,
            model: of(false)?,
            error,
        },
    })
}

/// The colours from below to above, with their numbers.
fn draw_bar(
    drawing: &mut Drawing,
    error: SphereError,
    stops: f64,
    [min, max]: [[f32; 2]; 2],
    font: f32,
) {
    const SHADES: usize = 256;
    let map = error_colors(error);
    let shades = (0..SHADES).rev().flat_map(|k| {
        let [r, g, b] = map.color(k as f64 / (SHADES - 1) as f64);
        [r, g, b, 255]
    });
    let rgba: Vec<u8> = shades.collect();
    debug_assert_eq!(rgba.len(), PIXEL * SHADES);
    drawing.items.push(Item::Image(Picture {
        min,
        max,
        width: 1,
        height: SHADES,
        rgba: rgba.into(),
        smooth: false,
    }));
    let mut put = |text: RichText, at: [f32; 2], anchor: Anchor| {
        let label = Label::new(text, at, anchor, 0.9 * font, Role::Muted);
        drawing.items.push(Item::Text(label));
    };
    for (place, text) in error_ticks(error, stops) {
        let y = max[1] - place * (max[1] - min[1]);
        put(text, [max[0] + 0.4 * font, y], Anchor::LEFT);
    }
    let unit = RichText::literal(error_unit(error));
    put(
        unit,
        [min[0], min[1] - 0.4 * font],
        Anchor { x: 0.0, y: 1.0 },
    );
}
