//! The lit sphere as pixels, without a graphics adapter: the twin in f64 of what `gpu/sphere.wgsl` draws.

use super::subject::Source;
use crate::geom::Rgb;
use crate::geom::color::srgb_encode;
use crate::geom::sphere::{HATCH, SphereView, irradiance, local_directions};
use crate::geom::sphere_error::SphereError;
use rayon::prelude::*;

/// Bytes of a pixel: RGBA, sRGB-encoded, premultiplied; transparent outside the sphere.
pub const PIXEL: usize = 4;

/// A square picture of `size` pixels a side, [`PIXEL`] bytes each, rows from above; hatched where nothing was measured.
///
/// One sample a pixel with a soft rim. A table at 96 pixels takes about 10 ms of processor time.
pub fn sphere_image(source: &Source, view: &SphereView, size: usize) -> Vec<u8> {
    image_of(size, |x, y| {
        Some(radiance_at(source, view, x, y)?.map(srgb_encode))
    })
}

/// The same of how far a model is from a measurement, in the colours of `map` for places in [0, 1].
pub fn error_image(
    [measured, model]: [&Source; 2],
    view: &SphereView,
    error: SphereError,
    map: impl Fn(f64) -> [u8; 3] + Sync,
    size: usize,
) -> Vec<u8> {
    image_of(size, |x, y| {
        let measured = radiance_at(measured, view, x, y)?;
        let model = radiance_at(model, view, x, y)?;
        let color = error.place(measured, model).map(&map);
        Some(color.map_or_else(
            || hatch_tone(0),
            |color| color.map(|value| f64::from(value) / 255.0),
        ))
    })
}

/// A sphere whose sRGB-encoded colour at a point in units of its radius is `color`; hatched where that is `None`.
fn image_of(size: usize, color: impl Fn(f64, f64) -> Option<Rgb> + Sync) -> Vec<u8> {
    let mut bytes = vec![0; size * size * PIXEL];
    let rows = bytes.par_chunks_mut((size * PIXEL).max(1)).enumerate();
    rows.for_each(|(y, row)| {
        for (x, pixel) in row.chunks_exact_mut(PIXEL).enumerate() {
            pixel.copy_from_slice(&pixel_at(&color, size, [x, y]));
        }
    });
    bytes
}

fn pixel_at(
    color: &impl Fn(f64, f64) -> Option<Rgb>,
    size: usize,
    [x, y]: [usize; 2],
) -> [u8; PIXEL] {
    // A pixel is left free around the sphere.
    let radius_px = 0.5 * size as f64;
    let unit = |k: usize| (k as f64 + 0.5 - radius_px) / radius_px * (1.0 + 2.0 / radius_px);
    let (x_unit, y_unit) = (unit(x), -unit(y));
    let radius = x_unit.hypot(y_unit);
    let coverage = ((1.0 - radius) * radius_px + 0.5).clamp(0.0, 1.0);
    if coverage == 0.0 {
        return [0; PIXEL];
    }
    // The soft rim is shaded as the last point of the sphere.
    let inside = (0.9999 / radius.max(1e-6)).min(1.0);
    let [r, g, b] = color(x_unit * inside, y_unit * inside)
        .unwrap_or_else(|| hatch_tone(usize::from((x + y + 1) % 8 >= 4)));
    [r, g, b, 1.0].map(|value| (255.0 * coverage * value).round() as u8)
}

fn hatch_tone(index: usize) -> Rgb {
    let [r, g, b, _] = HATCH[index].map(f64::from);
    [r, g, b]
}

/// What is seen at a point of the exposed sphere; `None` where a light above the horizon has no value.
fn radiance_at(source: &Source, view: &SphereView, x: f64, y: f64) -> Option<Rgb> {
    let mut radiance = [0.0; 3];
    for light in &view.lights {
        let Some((wi, wo)) = local_directions(x, y, light) else {
            continue;
        };
        if wi.z <= 0.0 {
            continue;
        }
        let f_r = source.f_r(wi, wo)?;
        let strength = irradiance(light, view.exposure_stops);
        for (channel, total) in radiance.iter_mut().enumerate() {
            *total += f_r[channel] * wi.z * strength[channel];
        }
    }
    Some(radiance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_1_PI, PI};
    use std::sync::Arc;

    /// A diffuse sphere of albedo `albedo` seen at a pixel of `size`.
    fn lambert(albedo: f64, size: usize, at: [usize; 2]) -> [u8; PIXEL] {
        let source = Source::Function(Arc::new(move |_, _| Some([albedo * FRAC_1_PI; 3])));
        let bytes = sphere_image(&source, &SphereView::default(), size);
        let start = (at[1] * size + at[0]) * PIXEL;
        std::array::from_fn(|k| bytes[start + k])
    }

    #[test]
    fn a_diffuse_sphere_is_its_closed_form() {
        let (size, at) = (64, [40, 20]);
        let unit = |k: usize| (k as f64 + 0.5 - 32.0) / 32.0 * (1.0 + 2.0 / 32.0);
        let (x, y) = (unit(at[0]), -unit(at[1]));
        let n = glam::DVec3::new(x, y, (1.0 - x * x - y * y).sqrt());
        let lights = SphereView::default().lights;
        // ρ/π cos θi E with E = π.
        let lit: f64 = lights.iter().map(|l| l.direction.dot(n).max(0.0)).sum();
        let wanted = (255.0 * srgb_encode(0.5 * FRAC_1_PI * PI * lit)).round() as u8;
        assert_eq!(lambert(0.5, size, at), [wanted, wanted, wanted, 255]);
        assert_ne!(lambert(0.52, size, at)[0], wanted, "4 % went unnoticed");
        assert_eq!(lambert(0.5, size, [0, 0]), [0; PIXEL]);
    }

    #[test]
    fn nothing_measured_is_hatched_where_there_is_light() {
        let source = Source::Function(Arc::new(|_, _| None));
        let bytes = sphere_image(&source, &SphereView::default(), 32);
        let tones = HATCH.map(|tone| tone.map(|x| (255.0 * x).round() as u8));
        let inside = bytes.chunks_exact(PIXEL).filter(|pixel| pixel[3] == 255);
        let hatched = inside.filter(|pixel| tones.iter().any(|tone| tone == pixel));
        assert!(hatched.count() > 300);
        assert!(sphere_image(&source, &SphereView::default(), 0).is_empty());
    }
}
