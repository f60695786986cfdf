//! The sphere for files: many samples a pixel, linear light, any size.

use super::{PIXEL, SphereSource, hatch_color, hatch_tone, unit_point};
use crate::geom::Rgb;
use crate::geom::color::srgb_encode;
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;
use image::codecs::openexr::OpenExrEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _, ImageResult};
use rayon::prelude::*;
use std::io::{Seek, Write};

/// The samples of a pixel are a grid of this many by as many.
pub const SAMPLES_A_SIDE: usize = 4;

/// A square picture of a sphere in linear light, not clamped.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearImage {
    /// Pixels a side.
    size: usize,
    /// Rows from above. Premultiplied linear RGB, then the share of the pixel that the measured part of the sphere covers.
    pixels: Vec<[f32; 4]>,
    /// Unmeasured samples of each pixel: those on the dark stripes of the hatch, and on the light ones.
    unmeasured: Vec<[u16; 2]>,
    /// Number of samples in a pixel.
    samples: usize,
    /// Background in linear RGB; `None` is transparent.
    pub background: Option<Rgb>,
}

/// Draws a sphere on `size` × `size` pixels with [`SAMPLES_A_SIDE`]² samples in each, averaged in linear light; as large
/// as the one on screen, which leaves a pixel around it free. The background is transparent.
///
/// Deterministic: the same bytes on every run. A table takes about 1 µs of processor time a sample.
pub fn render(source: &SphereSource, view: &SphereView, size: usize) -> LinearImage {
    render_part(source, view, Sight::default(), size)
}

/// Draws the part of a sphere that is in sight, as [`render`] does.
pub fn render_part(
    source: &SphereSource,
    view: &SphereView,
    sight: Sight,
    size: usize,
) -> LinearImage {
    sampled(source, view, sight, size, SAMPLES_A_SIDE)
}

/// Draws the part of a sphere that is in sight with a grid of `side` × `side` samples in each pixel.
pub(super) fn sampled(
    source: &SphereSource,
    view: &SphereView,
    sight: Sight,
    size: usize,
    side: usize,
) -> LinearImage {
    let mut pixels = vec![[0.0; 4]; size * size];
    let mut unmeasured = vec![[0; 2]; size * size];
    pixels
        .par_chunks_mut(size.max(1))
        .zip(unmeasured.par_chunks_mut(size.max(1)))
        .enumerate()
        .for_each(|(y, (pixels, unmeasured))| {
            for (x, (pixel, unmeasured)) in pixels.iter_mut().zip(unmeasured).enumerate() {
                (*pixel, *unmeasured) = pixel_of(source, view, sight, size, side, [x, y]);
            }
        });
    LinearImage {
        size,
        pixels,
        unmeasured,
        samples: side * side,
        background: None,
    }
}

fn pixel_of(
    source: &SphereSource,
    view: &SphereView,
    sight: Sight,
    size: usize,
    side: usize,
    at: [usize; 2],
) -> ([f32; 4], [u16; 2]) {
    let mut sum = [0.0; 4];
    let mut unmeasured = [0; 2];
    for sample in 0..side * side {
        let inside = |k: usize| (k as f64 + 0.5) / side as f64;
        let x_px = at[0] as f64 + inside(sample % side);
        let y_px = at[1] as f64 + inside(sample / side);
        let (x, y) = unit_point(size, x_px, y_px);
        let (x, y) = sight.point(x, y);
        if x * x + y * y >= 1.0 {
            continue;
        }
        match source.seen_at(view, x, y) {
            Some([r, g, b]) => {
                for (sum, value) in sum.iter_mut().zip([r, g, b, 1.0]) {
                    *sum += value;
                }
            }
            None => unmeasured[hatch_tone(size, x_px, y_px)] += 1,
        }
    }
    let count = (side * side) as f64;
    // A table may hold numbers whose sum over the lights is too large for f32.
    let mean = sum.map(|sum| (sum / count).min(f64::from(f32::MAX)) as f32);
    (mean, unmeasured)
}

impl LinearImage {
    /// Pixels a side.
    pub fn size(&self) -> usize {
        self.size
    }

    /// RGBA, [`PIXEL`] bytes each, sRGB-encoded with straight alpha, rows from above; hatched where nothing was
    /// measured. What is brighter than white is white.
    pub fn to_rgba8(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.pixels.len() * PIXEL];
        let pixels = bytes.par_chunks_exact_mut(PIXEL).enumerate();
        pixels.for_each(|(k, pixel)| {
            let mut color = self.pixels[k].map(f64::from);
            for (tone, count) in self.unmeasured[k].into_iter().enumerate() {
                if count > 0 {
                    let [r, g, b] = hatch_color(tone);
                    lay(
                        &mut color,
                        [r, g, b],
                        f64::from(count) / self.samples as f64,
                    );
                }
            }
            pixel.copy_from_slice(&encoded(self.on_background(color)));
        });
        bytes
    }

    /// RGBA in linear light, premultiplied as in OpenEXR, not clamped, rows from above. What was not measured covers
    /// nothing.
    pub fn to_linear(&self) -> Vec<[f32; 4]> {
        let pixels = self.pixels.iter();
        pixels
            .map(|pixel| self.on_background(pixel.map(f64::from)).map(|x| x as f32))
            .collect()
    }

    /// Writes [`LinearImage::to_rgba8`] as a PNG file.
    ///
    /// # Errors
    /// What the writer says, and for a picture without pixels.
    pub fn write_png(&self, writer: impl Write) -> ImageResult<()> {
        let side = self.size as u32;
        PngEncoder::new(writer).write_image(&self.to_rgba8(), side, side, ExtendedColorType::Rgba8)
    }

    /// Writes [`LinearImage::to_linear`] as an OpenEXR file with 32-bit floats.
    ///
    /// # Errors
    /// What the writer says, and for a picture without pixels.
    pub fn write_exr(&self, writer: impl Write + Seek) -> ImageResult<()> {
        let side = self.size as u32;
        let pixels = self.to_linear();
        let bytes = bytemuck::cast_slice(&pixels);
        OpenExrEncoder::new(writer).write_image(bytes, side, side, ExtendedColorType::Rgba32F)
    }

    fn on_background(&self, mut color: [f64; 4]) -> [f64; 4] {
        if let Some(background) = self.background {
            let free = 1.0 - color[3];
            lay(&mut color, background, free);
        }
        color
    }
}

/// Adds an opaque colour to a share of a premultiplied pixel.
fn lay(pixel: &mut [f64; 4], [r, g, b]: Rgb, share: f64) {
    for (value, added) in pixel.iter_mut().zip([r, g, b, 1.0]) {
        *value += share * added;
    }
}

/// A premultiplied linear pixel with straight alpha.
fn encoded([r, g, b, alpha]: [f64; 4]) -> [u8; PIXEL] {
    if alpha <= 0.0 {
        return [0; PIXEL];
    }
    let [r, g, b] = [r, g, b].map(|value| srgb_encode(value / alpha));
    [r, g, b, alpha].map(|value| (255.0 * value).round() as u8)
}
