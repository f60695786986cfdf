//! The sphere for files: many samples a pixel, linear light, any size.

use super::{PIXEL, SphereSource, hatch_color, hatch_tone, unit_point};
use crate::geom::Rgb;
use crate::geom::color::srgb_encode;
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;
use exr::prelude::{Image, SpecificChannels, Vec2, WritableImage as _};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _, ImageResult};
use rayon::prelude::*;
use std::io::{Seek, Write};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// The samples of a pixel are a grid of this many by as many.
pub const SAMPLES_A_SIDE: usize = 4;

/// A square picture of a sphere in linear light, not clamped. It holds what is drawn, and draws some rows at a time as they are
/// asked for.
#[derive(Clone, Debug)]
pub struct LinearImage {
    source: SphereSource,
    view: SphereView,
    sight: Sight,
    /// Pixels a side.
    size: usize,
    /// Samples along a side of a pixel.
    side: usize,
    /// Background in linear RGB; `None` is transparent.
    pub background: Option<Rgb>,
}

/// Pixels in memory at once.
const MOST_PIXELS: usize = 1 << 20;

/// Some rows of a picture.
#[derive(Default)]
struct Band {
    rows: Range<usize>,
    /// Rows from above. Premultiplied linear RGB, then the share of the pixel that the measured part of the sphere covers.
    pixels: Vec<[f32; 4]>,
    /// Unmeasured samples of each pixel: those on the dark stripes of the hatch, and on the light ones.
    unmeasured: Vec<[u16; 2]>,
}

/// A sphere on `size` × `size` pixels with [`SAMPLES_A_SIDE`]² samples in each, averaged in linear light; as large as the
/// one on screen, which leaves a pixel around it free. The background is transparent.
///
/// Deterministic: the same bytes on every run. A table takes about 1 µs of processor time a sample.
pub fn render(source: &SphereSource, view: &SphereView, size: usize) -> LinearImage {
    render_part(source, view, Sight::default(), size)
}

/// The part of a sphere that is in sight, as [`render`] draws it.
pub fn render_part(
    source: &SphereSource,
    view: &SphereView,
    sight: Sight,
    size: usize,
) -> LinearImage {
    sampled(source, view, sight, size, SAMPLES_A_SIDE)
}

/// The part of a sphere that is in sight with a grid of `side` × `side` samples in each pixel.
pub(super) fn sampled(
    source: &SphereSource,
    view: &SphereView,
    sight: Sight,
    size: usize,
    side: usize,
) -> LinearImage {
    LinearImage {
        source: source.clone(),
        view: view.clone(),
        sight,
        size,
        side,
        background: None,
    }
}

impl LinearImage {
    /// A pixel, and its unmeasured samples.
    fn pixel(&self, at: [usize; 2]) -> ([f32; 4], [u16; 2]) {
        let (size, side) = (self.size, self.side);
        let mut sum = [0.0; 4];
        let mut unmeasured = [0; 2];
        for sample in 0..side * side {
            let inside = |k: usize| (k as f64 + 0.5) / side as f64;
            let x_px = at[0] as f64 + inside(sample % side);
            let y_px = at[1] as f64 + inside(sample / side);
            let (x, y) = unit_point(size, x_px, y_px);
            let (x, y) = self.sight.point(x, y);
            if x * x + y * y >= 1.0 {
                continue;
            }
            match self.source.seen_at(&self.view, x, y) {
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

    /// Pixels a side.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Draws the rows that are held together with this one.
    fn band(&self, row: usize) -> Band {
        let size = self.size.max(1);
        let count = (MOST_PIXELS / size).max(1);
        let first = row / count * count;
        let rows = first..(first + count).min(self.size);
        let mut pixels = vec![[0.0; 4]; self.size * rows.len()];
        let mut unmeasured = vec![[0; 2]; self.size * rows.len()];
        pixels
            .par_chunks_mut(size)
            .zip(unmeasured.par_chunks_mut(size))
            .enumerate()
            .for_each(|(y, (pixels, unmeasured))| {
                for (x, (pixel, unmeasured)) in pixels.iter_mut().zip(unmeasured).enumerate() {
                    (*pixel, *unmeasured) = self.pixel([x, first + y]);
                }
            });
        Band {
            rows,
            pixels,
            unmeasured,
        }
    }

    /// The bands from above.
    fn bands(&self) -> impl Iterator<Item = Band> {
        let count = (MOST_PIXELS / self.size.max(1)).max(1);
        (0..self.size).step_by(count).map(|row| self.band(row))
    }

    /// RGBA, [`PIXEL`] bytes each, sRGB-encoded with straight alpha, rows from above; hatched where nothing was
    /// measured. What is brighter than white is white.
    pub fn to_rgba8(&self) -> Vec<u8> {
        let samples = (self.side * self.side) as f64;
        let mut bytes = vec![0; self.size * self.size * PIXEL];
        for band in self.bands() {
            let first = band.rows.start * self.size * PIXEL;
            let pixels = bytes[first..].par_chunks_exact_mut(PIXEL);
            let seen = band.pixels.par_iter().zip(&band.unmeasured);
            pixels.zip(seen).for_each(|(pixel, (color, unmeasured))| {
                let mut color = color.map(f64::from);
                for (tone, count) in unmeasured.iter().enumerate() {
                    if *count > 0 {
                        lay(&mut color, hatch_color(tone), f64::from(*count) / samples);
                    }
                }
                pixel.copy_from_slice(&encoded(self.on_background(color)));
            });
        }
        bytes
    }

    /// RGBA in linear light, premultiplied as in OpenEXR, not clamped, rows from above. What was not measured covers
    /// nothing.
    pub fn to_linear(&self) -> Vec<[f32; 4]> {
        let bands = self.bands();
        bands
            .flat_map(|band| band.pixels)
            .map(|pixel| self.linear(pixel))
            .collect()
    }

    fn linear(&self, pixel: [f32; 4]) -> [f32; 4] {
        self.on_background(pixel.map(f64::from)).map(|x| x as f32)
    }

    /// Writes [`LinearImage::to_rgba8`] as a PNG file.
    ///
    /// # Errors
    /// What the writer says, and for a picture without pixels.
    pub fn write_png(&self, writer: impl Write) -> ImageResult<()> {
        let side = self.size as u32;
        PngEncoder::new(writer).write_image(&self.to_rgba8(), side, side, ExtendedColorType::Rgba8)
    }

    /// Writes [`LinearImage::to_linear`] as an OpenEXR file with 32-bit floats, with some rows in memory at once.
    ///
    /// # Errors
    /// What the writer says, and for a picture without pixels.
    pub fn write_exr(&self, writer: impl Write + Seek) -> exr::error::UnitResult {
        // The writer asks for rows in their order.
        let drawn = Mutex::new(Band::default());
        let pixel = |at: Vec2<usize>| {
            let mut band = drawn.lock().unwrap_or_else(PoisonError::into_inner);
            if !band.rows.contains(&at.y()) {
                *band = self.band(at.y());
            }
            let position = at.x() + self.size * (at.y() - band.rows.start);
            let [r, g, b, alpha] = self.linear(band.pixels[position]);
            (r, g, b, alpha)
        };
        Image::from_channels((self.size, self.size), SpecificChannels::rgba(pixel))
            .write()
            .to_buffered(writer)
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
