//! Paints a [`Drawing`] with egui, and turns marked-up text into egui's.

pub mod pictures;

use crate::figure::drawing::{Drawing, Item, Label, Point};
use crate::figure::palette::{Ink, Palette, Role};
use crate::figure::text::{RichText, ScriptLevel};
use egui::emath::Rot2;
use egui::epaint::TextShape;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

pub(crate) use pictures::paint_picture;
/// The colour of a data set.
pub fn series_color(dark_mode: bool, series: usize) -> Color32 {
    color(&Palette::of_theme(dark_mode), Role::Series(series).into())
}

/// The colour of a role.
pub fn role_color(dark_mode: bool, role: Role) -> Color32 {
    color(&Palette::of_theme(dark_mode), role.into())
}

/// Paints a drawing with its upper left corner at `origin`.
pub fn paint(painter: &Painter, origin: Pos2, drawing: &Drawing, palette: &Palette) {
    let place = |point: &Point| pos2(origin.x + point[0], origin.y + point[1]);
    for item in &drawing.items {
        match item {
            Item::Line {
                points,
                width,
                dash,
                ink,
            } => {
                let stroke = Stroke::new(*width, color(palette, *ink));
                let path: Vec<Pos2> = points.iter().map(place).collect();
                match dash {
                    None => {
                        painter.line(crisp(painter, path, *width), stroke);
                    }
                    Some([on, off]) => {
                        let dashes = dashes(&path, *on, *off);
                        painter.extend(dashes.into_iter().map(|dash| Shape::line(dash, stroke)));
                    }
                }
            }
            Item::Fill { points, ink } => {
                let path = points.iter().map(place).collect();
                let fill = color(palette, *ink);
                painter.add(Shape::convex_polygon(path, fill, Stroke::NONE));
            }
            Item::Dot {
                center,
                radius,
                ink,
                outline,
            } => {
                let stroke = outline.map_or(Stroke::NONE, |(width, ink)| {
                    Stroke::new(width, color(palette, ink))
                });
                painter.circle(place(center), *radius, color(palette, *ink), stroke);
            }
            Item::Text(label) => paint_label(painter, place(&label.pos), label, palette),
            Item::Image(picture) => {
                let rect = Rect::from_min_max(place(&picture.min), place(&picture.max));
                let size = [picture.width, picture.height];
                paint_picture(painter, rect, size, &picture.rgba, picture.smooth);
            }
        }
    }
}

fn paint_label(painter: &Painter, pos: Pos2, label: &Label, palette: &Palette) {
    let ink = color(palette, label.ink);
    let galley = painter.layout_job(rich_text_job(&label.text, label.size, ink));
    let extent = galley.size();
    let turn = Rot2::from_angle(label.angle);
    let to_corner = vec2(-label.anchor.x * extent.x, -label.anchor.y * extent.y);
    let corner = pos + turn * to_corner;
    if label.halo {
        let patch = Rect::from_min_size(pos + to_corner, extent).expand2(vec2(1.5, -1.0));
        let ground = Ink::from(Role::Background).faded(0.75);
        painter.rect_filled(patch, 3.0, color(palette, ground));
    }
    painter.add(TextShape::new(corner, galley, ink).with_angle(label.angle));
}

/// Straight level and upright lines moved onto whole pixels, so that thin ones are not blurred.
fn crisp(painter: &Painter, mut path: Vec<Pos2>, width: f32) -> Vec<Pos2> {
    let pixels = (width * painter.pixels_per_point()).round();
    let snap = |x: f32| {
        if pixels % 2.0 == 1.0 {
            painter.round_to_pixel_center(x)
        } else {
            (x * painter.pixels_per_point()).round() / painter.pixels_per_point()
        }
    };
    let Some(first) = path.first().copied() else {
        return path;
    };
    if path.iter().all(|p| (p.y - first.y).abs() < 1e-3) {
        path.iter_mut().for_each(|p| p.y = snap(first.y));
    } else if path.iter().all(|p| (p.x - first.x).abs() < 1e-3) {
        path.iter_mut().for_each(|p| p.x = snap(first.x));
    }
    path
}

/// The dashes of a polyline, each one a polyline that follows its bends.
fn dashes(path: &[Pos2], on: f32, off: f32) -> Vec<Vec<Pos2>> {
    let mut dashes = Vec::new();
    let Some(first) = path.first() else {
        return dashes;
    };
    let mut dash = vec![*first];
    // What is left of the dash or gap that the walk is in.
    let (mut left, mut drawing) = (on, true);
    for pair in path.windows(2) {
        let length = pair[0].distance(pair[1]);
        let mut walked = 0.0;
        while length - walked > left {
            walked += left;
            let point = pair[0] + (pair[1] - pair[0]) * (walked / length);
            if drawing {
                dash.push(point);
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash = vec![point];
            }
            drawing = !drawing;
            left = if drawing { on } else { off }.max(0.1);
        }
        left -= length - walked;
        if drawing {
            dash.push(pair[1]);
        }
    }
    if drawing && dash.len() > 1 {
        dashes.push(dash);
    }
    dashes
}

fn color(palette: &Palette, ink: Ink) -> Color32 {
    let [r, g, b, a] = palette.resolve(ink);
    Color32::from_rgba_unmultiplied(r, g, b, a)
}

/// Text with raised and lowered runs, for labels and formulas.
pub fn rich_text_job(text: &RichText, font_size: f32, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    for run in &text.runs {
        let format = TextFormat {
            font_id: FontId::proportional(run.level.relative_size() * font_size),
            color,
            valign: match run.level {
                ScriptLevel::Base => Align::Center,
                ScriptLevel::Sub => Align::BOTTOM,
                ScriptLevel::Sup => Align::TOP,
            },
            ..TextFormat::default()
        };
        job.append(&run.text, 0.0, format);
    }
    job
}

/// Marked-up text as plain letters, powers after `^`, for places that know one level only.
pub fn plain(markup: &str) -> String {
    RichText::parse(markup)
        .runs
        .iter()
        .map(|run| match run.level {
            ScriptLevel::Sup => format!("^{}", run.text),
            ScriptLevel::Base | ScriptLevel::Sub => run.text.clone(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distance along an L-shaped path of 30 + 30 points.
    fn along(p: Pos2) -> f32 {
        p.x + p.y
    }

    #[test]
    fn dashes_go_on_around_corners() {
        let path = [pos2(0.0, 0.0), pos2(30.0, 0.0), pos2(30.0, 30.0)];
        let dashes = dashes(&path, 8.0, 4.0);
        let ends: Vec<(f32, f32)> = dashes
            .iter()
            .map(|dash| (along(dash[0]), along(dash[dash.len() - 1])))
            .collect();
        let wanted = [0.0, 12.0, 24.0, 36.0, 48.0].map(|start| (start, start + 8.0));
        assert_eq!(ends, wanted);
        // The third one bends.
        assert_eq!(dashes[2].len(), 3);
    }

    #[test]
    fn scripts_are_small_and_at_the_edges() {
        let job = rich_text_job(&RichText::parse("x_{i}^{2}"), 20.0, Color32::RED);
        let formats: Vec<_> = job.sections.iter().map(|s| &s.format).collect();
        assert_eq!(job.text, "xi2");
        assert_eq!(formats[0].font_id.size, 20.0);
        assert!(formats[1].font_id.size < 16.0 && formats[1].valign == Align::BOTTOM);
        assert_eq!(formats[2].valign, Align::TOP);
    }
}
