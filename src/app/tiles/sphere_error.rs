//! The colours of the difference sphere and the bar that says what they mean.

use super::sphere::OnScreen;
use crate::app::paint;
use crate::figure::scale::number;
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
    std::array::from_fn(|k| color(error, k as f64 / (COLORS - 1) as f64))
}

/// The sRGB colour at a place in [0, 1].
fn color(error: SphereError, at: f64) -> [u8; 3] {
    match error {
        SphereError::Difference => viridis(at),
        SphereError::Ratio => diverging(at),
    }
}

/// The bar with its ticks at the right of `rect`, as high as the sphere, and the name of what it shows over the sphere.
pub fn bar(ui: &egui::Ui, rect: Rect, sphere: &OnScreen, error: SphereError, stops: f64) {
    let painter = ui.painter();
    let visuals = ui.visuals();
    let text = |at: Pos2, align: Align2, text: &str| {
        let color = visuals.weak_text_color();
        painter.text(at, align, text, FontId::proportional(12.0), color);
    };
    let name = match error {
        SphereError::Difference => "|model − measured|",
        SphereError::Ratio => "model / measured",
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

/// Viridis by van der Walt, Smith and Firing, as a polynomial by Matt Zucker (both CC0).
fn viridis(t: f64) -> [u8; 3] {
    const TERMS: [[f64; 3]; 7] = [
        [0.277_727_3, 0.005_407_3, 0.334_099_8],
        [0.105_093_0, 1.404_613_5, 1.384_590_2],
        [-0.330_861_8, 0.214_847_6, 0.095_095_2],
        [-4.634_230_5, -5.799_101_0, -19.332_441_0],
        [6.228_269_9, 14.179_933_4, 56.690_552_6],
        [4.776_385_0, -13.745_145_4, -65.353_032_6],
        [-5.435_455_9, 4.645_852_6, 26.312_435_2],
    ];
    std::array::from_fn(|k| {
        let value = TERMS.iter().rev().fold(0.0, |sum, term| sum * t + term[k]);
        (255.0 * value.clamp(0.0, 1.0)).round() as u8
    })
}

/// Blue over light grey to red: the ends and quarters of ColorBrewer's RdBu.
fn diverging(t: f64) -> [u8; 3] {
    const STOPS: [[u8; 3]; 5] = [
        [0x05, 0x30, 0x61],
        [0x43, 0x93, 0xc3],
        [0xf7, 0xf7, 0xf7],
        [0xd6, 0x60, 0x4d],
        [0x67, 0x00, 0x1f],
    ];
    let x = 4.0 * t.clamp(0.0, 1.0);
    let low = (x as usize).min(3);
    let share = x - low as f64;
    std::array::from_fn(|k| {
        let (a, b) = (f64::from(STOPS[low][k]), f64::from(STOPS[low + 1][k]));
        (a + share * (b - a)).round() as u8
    })
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

    #[test]
    fn the_maps_have_their_published_ends() {
        assert_eq!(viridis(0.0), [71, 1, 85]);
        let [r, g, b] = viridis(1.0);
        assert!(r > 248 && (228..236).contains(&g) && b < 40, "{r} {g} {b}");
        assert_eq!(diverging(0.5), [0xf7; 3]);
        assert_eq!(colors(SphereError::Ratio)[COLORS - 1], [0x67, 0, 0x1f]);
    }
}
