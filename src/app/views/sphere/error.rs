//! The colours of the difference sphere and the bar that says what they mean.

use crate::app::views::sphere::{SphereOnScreen, word};
use crate::figure::sphere_image::{error_colors, error_names, error_ticks, error_unit};
use crate::geom::sphere_error::SphereError;
use crate::gpu::sphere_pass::COLORS;
use egui::{Align2, Color32, FontId, Pos2, Rect, Stroke, pos2, vec2};

/// Room for the bar with its numbers, in points.
const ROOM: f32 = 62.0;
const WIDTH: f32 = 12.0;

/// Part of a rectangle that the bar leaves.
pub fn beside_bar(rect: Rect) -> Rect {
    let room = ROOM.min(0.3 * rect.width());
    rect.with_max_x(rect.right() - room)
}

/// The map of a comparison at even places from 0 to 1.
pub fn colors(error: SphereError) -> [[u8; 3]; COLORS] {
    let map = error_colors(error);
    std::array::from_fn(|k| map.color(k as f64 / (COLORS - 1) as f64))
}

/// The bar with its ticks at the right of `rect`, as high as the sphere, and the name of what it shows over the sphere.
pub fn bar(ui: &egui::Ui, rect: Rect, sphere: &SphereOnScreen, error: SphereError, stops: f64) {
    let painter = ui.painter();
    let visuals = ui.visuals();
    let text = |at: Pos2, align: Align2, text: &str| {
        let color = visuals.weak_text_color();
        painter.text(at, align, text, FontId::proportional(12.0), color);
    };
    // Beside a small sphere there is room for a word.
    let [full, short] = error_names(error);
    let name = if sphere.frame.width() > 240.0 {
        full
    } else {
        short
    };
    word(ui, sphere.frame.left_top(), Align2::LEFT_TOP, name, 12.0);
    let left = beside_bar(rect).right() + 4.0;
    let high = sphere.frame.height() - 22.0;
    let bar = Rect::from_min_size(
        pos2(left, sphere.frame.top() + 18.0),
        vec2(WIDTH, high.max(20.0)),
    );
    let mut mesh = egui::Mesh::default();
    for (k, [r, g, b]) in colors(error).into_iter().enumerate() {
        let y = egui::lerp(bar.bottom()..=bar.top(), k as f32 / (COLORS - 1) as f32);
        let color = Color32::from_rgb(r, g, b);
        mesh.colored_vertex(pos2(bar.left(), y), color);
        mesh.colored_vertex(pos2(bar.right(), y), color);
        if k > 0 {
            let k = 2 * k as u32;
            mesh.add_triangle(k - 2, k - 1, k);
            mesh.add_triangle(k - 1, k, k + 1);
        }
    }
    painter.add(mesh);
    let line = Stroke::new(1.0, visuals.weak_text_color());
    painter.rect_stroke(bar, 0.0, line, egui::StrokeKind::Outside);
    for (place, label) in error_ticks(error, stops) {
        let y = egui::lerp(bar.bottom()..=bar.top(), place);
        painter.hline(bar.right()..=bar.right() + 3.0, y, line);
        text(
            pos2(bar.right() + 5.0, y),
            Align2::LEFT_CENTER,
            &label.plain(),
        );
    }
    text(
        pos2(rect.right(), sphere.frame.top() - 2.0),
        Align2::RIGHT_TOP,
        error_unit(error),
    );
}
