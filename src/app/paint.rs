//! Paints a [`Drawing`] with egui, and turns marked-up text into egui's.

use crate::figure::drawing::{DARK, Drawing, Ink, Item, LIGHT, Palette, Point, Role};
use crate::figure::text::{Level, RichText, SMALL};
use egui::epaint::{PathShape, PathStroke};
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2, vec2};

/// Dash and gap in points.
const DASH: (f32, f32) = (6.0, 4.0);

/// The colours for the window's theme.
pub fn palette(dark_mode: bool) -> Palette {
    if dark_mode { DARK } else { LIGHT }
}

/// The colour of a data set.
pub fn series_color(dark_mode: bool, series: usize) -> Color32 {
    let [r, g, b] = palette(dark_mode).color(Role::Series(series));
    Color32::from_rgb(r, g, b)
}

/// Paints a drawing with its upper left corner at `origin`.
pub fn paint(painter: &Painter, origin: Pos2, drawing: &Drawing, palette: &Palette) {
    let place = |point: &Point| pos2(origin.x + point[0], origin.y + point[1]);
    for item in &drawing.items {
        match item {
            Item::Line {
                points,
                width,
                dashed,
                ink,
            } => {
                let path: Vec<Pos2> = points.iter().map(place).collect();
                let stroke = Stroke::new(*width, color(palette, *ink));
                if *dashed {
                    painter.extend(Shape::dashed_line(&path, stroke, DASH.0, DASH.1));
                } else {
                    painter.add(Shape::line(path, stroke));
                }
            }
            Item::Fill { points, ink } => {
                let path = points.iter().map(place).collect();
                painter.add(PathShape::convex_polygon(
                    path,
                    color(palette, *ink),
                    PathStroke::NONE,
                ));
            }
            Item::Dot {
                center,
                radius,
                ink,
            } => {
                painter.circle_filled(place(center), *radius, color(palette, *ink));
            }
            Item::Text {
                position,
                anchor,
                size,
                text,
                ink,
                halo,
            } => {
                let galley = painter.layout_job(rich_text_job(text, *size, color(palette, *ink)));
                let extent: Vec2 = galley.size();
                let corner = place(position) - vec2(anchor[0] * extent.x, anchor[1] * extent.y);
                if *halo {
                    let ground = color(palette, Role::Background.with_opacity(0.8));
                    painter.rect_filled(
                        Rect::from_min_size(corner, extent).expand2(vec2(2.0, -1.0)),
                        3.0,
                        ground,
                    );
                }
                painter.galley(corner, galley, Color32::PLACEHOLDER);
            }
        }
    }
}

fn color(palette: &Palette, ink: Ink) -> Color32 {
    let [r, g, b] = palette.color(ink.role);
    Color32::from_rgba_unmultiplied(r, g, b, (255.0 * ink.opacity).round() as u8)
}

/// Text with raised and lowered runs, for labels and formulas.
pub fn rich_text_job(text: &RichText, size: f32, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    for run in &text.runs {
        let (size, valign) = match run.level {
            Level::Base => (size, Align::Center),
            Level::Sub => (SMALL * size, Align::BOTTOM),
            Level::Sup => (SMALL * size, Align::TOP),
        };
        job.append(
            &run.text,
            0.0,
            TextFormat {
                font_id: FontId::proportional(size),
                color,
                valign,
                ..Default::default()
            },
        );
    }
    job
}

/// Marked-up text as plain letters with superscript digits, for places that know one level only.
pub fn plain(markup: &str) -> String {
    RichText::parse(markup)
        .runs
        .iter()
        .map(|run| {
            if run.level == Level::Sup {
                format!("^{}", run.text)
            } else {
                run.text.clone()
            }
        })
        .collect()
}
