//! A sphere on paper: a picture, and words and a bar that say what it is.

use super::{
    PIXEL, SphereShow, SphereSpec, error_colors, error_names, error_ticks, error_unit, render_part,
    sanitize,
};
use crate::figure::drawing::{Anchor, Drawing, Item, Label, Picture, font_size};
use crate::figure::faults::Faults;
use crate::figure::palette::Role;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::text::RichText;
use crate::geom::sphere_error::SphereError;

/// Pixels on a side at most.
const MOST: usize = 4096;

impl PanelView for SphereSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        sanitize(&mut self.view, &mut self.split, &mut self.sight, faults);
    }

    fn height(&self, width: f32, _font: f32) -> f32 {
        match self.show {
            SphereShow::Error(_) => 0.85 * width,
            _ => width,
        }
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let [width, height] = input.size;
        let font = font_size(input.size);
        let mut drawing = Drawing::new(input.size);
        let Some(source) = self.source(|measured| input.source(measured).cloned()) else {
            let text = RichText::literal("Nothing to show.");
            let middle = [0.5 * width, 0.5 * height];
            let label = Label::new(text, middle, Anchor::CENTER, font, Role::Muted);
            drawing.items.push(Item::Text(label));
            return drawn(drawing);
        };
        // A bar stands at the right.
        let bar = match self.show {
            SphereShow::Error(_) => 4.5 * font,
            _ => 0.0,
        };
        let side = (width - bar).min(height).max(4.0);
        let min = [0.5 * (width - bar - side), 0.5 * (height - side)];
        let max = [min[0] + side, min[1] + side];
        let size = ((side * input.density).ceil() as usize).clamp(1, MOST);
        let picture = render_part(&source, &self.view, self.sight, size);
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
        match self.show {
            SphereShow::Measured | SphereShow::Model => {}
            SphereShow::Split => {
                word("measured", min[0], 0.0);
                word("model", max[0], 1.0);
                let split = self.sight.zoom * (self.split - self.sight.center[0]);
                if split.abs() <= 1.0 {
                    let x = min[0] + 0.5 * side * (1.0 + split as f32);
                    let line = vec![[x, min[1]], [x, max[1]]];
                    drawing.line(line, 1.0, Role::Muted.into());
                }
            }
            SphereShow::Error(error) => {
                word(error_names(error)[0], min[0], 0.0);
                let stops = self.view.exposure_stops;
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
}

fn drawn(drawing: Drawing) -> PanelDrawing {
    PanelDrawing {
        drawing,
        ..PanelDrawing::default()
    }
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
