//! The lit sphere as pixels, without a graphics adapter: the twin in f64 of what `gpu/sphere.wgsl` draws.
//!
//! [`render`] makes pictures for files, [`sphere_image`] small ones for the screen; both are of a [`SphereSource`].

mod bar;
mod panel;
mod render;
mod spec;

pub use bar::{error_names, error_ticks, error_unit};
pub use render::{LinearImage, SAMPLES_A_SIDE, render, render_part};
pub use spec::{SphereShow, SphereSpec, sanitize};

use super::colormap::ColorMap;
use super::subject::Source;
use crate::geom::Rgb;
use crate::geom::color::{srgb_decode, srgb_encode};
use crate::geom::sphere::{HATCH, SphereView, irradiance, local_directions};
use crate::geom::sphere_error::SphereError;
use rayon::prelude::*;

/// Picture on a sphere, with its sources.
#[derive(Clone, Debug, PartialEq)]
pub enum SphereSource {
    /// One BRDF.
    One(Source),
    /// Two, side by side on one sphere.
    Split {
        /// Left of the line.
        left: Source,
        /// Right of it.
        right: Source,
        /// Place of the line: −1 is the left rim, 1 the right one.
        at: f64,
    },
    /// Error of a model against a measurement, in the colours of [`error_colors`].
    Compared {
        /// The measurement.
        measured: Source,
        /// The model.
        model: Source,
        /// Measure of the error.
        error: SphereError,
    },
}

/// The colours in which a comparison is shown.
pub fn error_colors(error: SphereError) -> ColorMap {
    match error {
        SphereError::Difference => ColorMap::Sequential,
        SphereError::Ratio => ColorMap::Diverging,
    }
}

impl SphereSource {
    /// Linear RGB at a point inside the sphere, in units of its radius, exposed and not clamped; `None` where a light
    /// above the horizon has no value.
    fn seen_at(&self, view: &SphereView, x: f64, y: f64) -> Option<Rgb> {
        match self {
            Self::One(source) => radiance_at(source, view, x, y),
            Self::Split { left, right, at } => {
                let source = if x < *at { left } else { right };
                radiance_at(source, view, x, y)
            }
            Self::Compared {
                measured,
                model,
                error,
            } => {
                let measured = radiance_at(measured, view, x, y)?;
                let model = radiance_at(model, view, x, y)?;
                let Some(place) = error.place(measured, model) else {
                    return Some(hatch_color(0));
                };
                let color = error_colors(*error).color(place);
                Some(color.map(|value| srgb_decode(f64::from(value) / 255.0)))
            }
        }
    }
}

/// Bytes of a pixel: RGBA, sRGB-encoded.
pub const PIXEL: usize = 4;

/// A square picture of `size` pixels a side, [`PIXEL`] bytes each, premultiplied, rows from above; transparent outside
/// the sphere, hatched where nothing was measured.
///
/// One sample a pixel with a soft rim, as on the adapter. A table at 96 pixels takes about 10 ms of processor time.
pub fn sphere_image(source: &SphereSource, view: &SphereView, size: usize) -> Vec<u8> {
    let mut bytes = vec![0; size * size * PIXEL];
    let rows = bytes.par_chunks_mut((size * PIXEL).max(1)).enumerate();
    rows.for_each(|(y, row)| {
        for (x, pixel) in row.chunks_exact_mut(PIXEL).enumerate() {
            pixel.copy_from_slice(&pixel_at(source, view, size, [x, y]));
        }
    });
    bytes
}

fn pixel_at(source: &SphereSource, view: &SphereView, size: usize, at: [usize; 2]) -> [u8; PIXEL] {
    let radius_px = 0.5 * size as f64;
    let [x_px, y_px] = at.map(|k| k as f64 + 0.5);
    let (x, y) = unit_point(size, x_px, y_px);
    let radius = x.hypot(y);
    let coverage = ((1.0 - radius) * radius_px + 0.5).clamp(0.0, 1.0);
    if coverage == 0.0 {
        return [0; PIXEL];
    }
    // The soft rim is shaded as the last point of the sphere.
    let inside = (0.9999 / radius.max(1e-6)).min(1.0);
    let color = source.seen_at(view, x * inside, y * inside);
    let color = color.unwrap_or_else(|| hatch_color(hatch_tone(size, x_px, y_px)));
    let [r, g, b] = color.map(srgb_encode);
    [r, g, b, 1.0].map(|value| (255.0 * coverage * value).round() as u8)
}

/// A place in pixels from the upper left corner of a picture, in units of the sphere's radius with y up. A pixel is
/// left free around the sphere.
fn unit_point(size: usize, x_px: f64, y_px: f64) -> (f64, f64) {
    let radius_px = 0.5 * size as f64;
    let unit = |place: f64| (place - radius_px) / radius_px * (1.0 + 2.0 / radius_px);
    (unit(x_px), -unit(y_px))
}

/// Position in [`HATCH`] of the tone of the hatch at a place in pixels. Its stripes grow with large pictures.
fn hatch_tone(size: usize, x_px: f64, y_px: f64) -> usize {
    let period = (size as f64 / 32.0).max(8.0);
    usize::from((x_px + y_px).rem_euclid(period) >= 0.5 * period)
}

/// A tone of the hatch in linear RGB.
fn hatch_color(tone: usize) -> Rgb {
    let [r, g, b, _] = HATCH[tone].map(f64::from);
    [r, g, b].map(srgb_decode)
}

/// Exposed radiance in linear RGB at a point of the sphere; `None` where a light above the horizon has no value.
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
mod tests;
