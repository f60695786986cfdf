//! The colours of the difference sphere and the bar that says what they mean.

use super::sphere::OnScreen;
use crate::app::paint;
use crate::figure::scale::number;
use crate::figure::sphere_image::error_colors;
use crate::geom::sphere_error::{DIFFERENCE_LIMIT, RATIO_STOPS, SphereError};
use crate::gpu::sphere_pass::COLORS;
use egui::{Align2, Color32, FontId, Pos2, Rect, Stroke, pos2, vec2};

/// Room for the bar with its numbers, in points.
const ROOM: f32 = 62.0;
const WIDTH: f32 = 12.0;

/// What the bar leaves of a rectangle.
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
pub fn bar(ui: &egui::Ui, rect: Rect, sphere: &OnScreen, error: SphereError, stops: f64) {
    let painter = ui.painter();
    let visuals = ui.visuals();
    let text = |at: Pos2, align: Align2, text: &str| {
        let color = visuals.weak_text_color();
        painter.text(at, align, text, FontId::proportional(12.0), color);
    };
    // Beside a small sphere there is room for a word.
    let name = match (error, sphere.rect.width() > 240.0) {
        (SphereError::Difference, true) => "|model − measured|",
        (SphereError::Difference, false) => "difference",
        (SphereError::Ratio, true) => "model / measured",
        (SphereError::Ratio, false) => "ratio",
    };
    text(sphere.rect.left_top(), Align2::LEFT_TOP, name);
    let left = beside_bar(rect).right() + 4.0;
    let high = sphere.rect.height() - 22.0;
    let bar = Rect::from_min_size(
        pos2(left, sphere.rect.top() + 18.0),
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
    for (place, label) in ticks(error, stops) {
        let y = egui::lerp(bar.bottom()..=bar.top(), place);
        painter.hline(bar.right()..=bar.right() + 3.0, y, line);
        text(pos2(bar.right() + 5.0, y), Align2::LEFT_CENTER, &label);
    }
    text(
        pos2(rect.right(), sphere.rect.top() - 2.0),
        Align2::RIGHT_TOP,
        match error {
            SphereError::Difference => "white = 1",
            SphereError::Ratio => "factor",
        },
    );
}

/// Places on the bar and what stands there. A difference is one of luminance before the exposure, as seen under the
/// lights; a white diffuse surface that faces one of them has 1.
fn ticks(error: SphereError, stops: f64) -> Vec<(f32, String)> {
    let label = |value: f64| paint::plain(&number(value));
    match error {
        SphereError::Difference => (0..=4)
            .map(|k| {
                let place = f64::from(k) / 4.0;
                let value = place * DIFFERENCE_LIMIT * (-stops).exp2();
                let rounded = format!("{value:.2e}").parse().unwrap_or(value);
                (place as f32, label(rounded))
            })
            .collect(),
        SphereError::Ratio => {
            let most = RATIO_STOPS as i32;
            (-most..=most)
                .map(|stop| {
                    let place = 0.5 + 0.5 * f64::from(stop) / RATIO_STOPS;
                    let factor = 2_i32.pow(stop.unsigned_abs());
                    let text = if stop < 0 {
                        format!("1/{factor}")
                    } else {
                        factor.to_string()
                    };
                    (place as f32, text)
                })
                .collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_says_radiance_before_the_exposure_and_factors() {
        let texts = |error, stops| -> Vec<String> {
            let ticks = ticks(error, stops).into_iter();
            ticks.map(|(_, text)| text).collect()
        };
        assert_eq!(
            texts(SphereError::Difference, 0.0),
            ["0", "0.125", "0.25", "0.375", "0.5"]
        );
        assert_eq!(texts(SphereError::Difference, 1.0)[4], "0.25");
        assert_eq!(
            texts(SphereError::Ratio, 3.0),
            ["1/4", "1/2", "1", "2", "4"]
        );
    }
}
