//! Lobes in space as pixels, without a graphics adapter: what `gpu/lobe3d_pass` draws, for files.
//!
//! Solids go into a picture with depth; flat surfaces are laid over what is behind them; lines are drawn strong in
//! front of solids and weak behind them. Several samples a pixel make the edges soft.

use super::{Lobes, SpaceLine, SpaceProjection, ground, wires};
use crate::figure::drawing::{Item, Picture};
use crate::figure::palette::{Palette, Role};
use glam::{DVec2, DVec3};
use image::RgbaImage;
use image::imageops::{FilterType, crop_imm, resize};
use std::ops::Range;

/// Samples a pixel along each side.
const SAMPLES: f64 = 3.0;
/// Most samples in memory at once, about 30 bytes each.
const MOST_SAMPLES: u32 = 4 << 20;
/// Rows of pixels beyond a band that are drawn with it.
const MARGIN: u32 = 2;
/// Direction of the lamp in view space: from the upper left, beside the eye; as in the shader.
const LIGHT: DVec3 = DVec3::new(-0.40, 0.55, 0.73);
/// Distance of a line in front of the solid that it lies on, in units of the dome's radius.
const LIFT: f64 = 0.004;

/// The lobes on a canvas of `size` points, `density` pixels to the point.
pub fn picture(
    lobes: &Lobes,
    projection: &SpaceProjection,
    palette: &Palette,
    size: [f32; 2],
    density: f32,
) -> Item {
    let most = MOST_SAMPLES;
    Item::Image(picture_of(
        lobes,
        projection,
        palette,
        (size, density),
        most,
    ))
}

/// The picture, with so many samples in memory at once.
pub(super) fn picture_of(
    lobes: &Lobes,
    projection: &SpaceProjection,
    palette: &Palette,
    (size, density): ([f32; 2], f32),
    most: u32,
) -> Picture {
    let [width, height] = size.map(|points| ((points * density).ceil() as u32).clamp(1, 4096));
    let rows = (most / (width * SAMPLES as u32 * SAMPLES as u32)).max(1);
    let mut rgba = Vec::new();
    for first in (0..height).step_by(rows as usize) {
        let last = (first + rows).min(height);
        let band = band(
            lobes,
            projection,
            palette,
            density,
            [width, height],
            first..last,
        );
        rgba.extend(straight(band));
    }
    Picture {
        min: [0.0; 2],
        max: size,
        width: width as usize,
        height: height as usize,
        rgba: rgba.into(),
        smooth: true,
    }
}

/// Some rows of a picture, premultiplied.
fn band(
    lobes: &Lobes,
    projection: &SpaceProjection,
    palette: &Palette,
    density: f32,
    [width, height]: [u32; 2],
    rows: Range<u32>,
) -> RgbaImage {
    let scale = SAMPLES * f64::from(density);
    // Pixels are mixed with their neighbours.
    let from = rows.start.saturating_sub(MARGIN);
    let to = (rows.end + MARGIN).min(height);
    let samples = [width, to - from].map(|pixels| pixels as usize * SAMPLES as usize);
    let mut canvas = RasterCanvas::new(samples, from as usize * SAMPLES as usize);
    let place = |p: DVec3| {
        let [x, y] = projection.point(p).map(f64::from);
        DVec3::new(scale * x, scale * y, projection.view(p).z)
    };
    for lobe in lobes.list.iter().filter(|lobe| lobe.is_solid()) {
        let Some(mesh) = &lobe.mesh else {
            continue;
        };
        let color = palette.color(Role::Series(lobe.subject.series));
        for triangle in &mesh.triangles {
            let corners = triangle.map(|index| place(mesh.positions[index as usize]));
            let normals = triangle.map(|index| projection.view(mesh.normals[index as usize]));
            canvas.solid(corners, normals, color);
        }
    }
    let (fills, mut lines) = ground(lobes, None);
    for fill in fills {
        let points: Vec<DVec3> = fill.points.iter().map(|p| place(*p)).collect();
        for k in 2..points.len() {
            let color = palette.resolve(fill.ink);
            canvas.flat([points[0], points[k - 1], points[k]], color);
        }
    }
    lines.extend(wires(lobes, palette));
    for SpaceLine {
        points,
        width,
        ink,
        behind,
    } in lines
    {
        let points: Vec<DVec3> = points.iter().map(|p| place(*p)).collect();
        let width = f64::from(width) * scale;
        canvas.line(&points, width, palette.resolve(ink), f64::from(behind));
    }
    let [across, down] = canvas.size.map(|n| n as u32);
    let bytes = canvas.bytes();
    drop(canvas);
    let large = RgbaImage::from_raw(across, down, bytes).unwrap_or_default();
    let small = resize(&large, width, to - from, FilterType::Triangle);
    crop_imm(&small, 0, rows.start - from, width, rows.end - rows.start).to_image()
}

/// Pixels with depth, the larger the nearer; premultiplied.
struct RasterCanvas {
    size: [usize; 2],
    /// The row of the picture that is its first.
    first: usize,
    color: Vec<[f32; 4]>,
    depth: Vec<f64>,
    /// The last line that has coloured a pixel.
    touched: Vec<u32>,
    lines: u32,
}

impl RasterCanvas {
    fn new(size: [usize; 2], first: usize) -> Self {
        Self {
            size,
            first,
            color: vec![[0.0; 4]; size[0] * size[1]],
            depth: vec![f64::NEG_INFINITY; size[0] * size[1]],
            touched: vec![0; size[0] * size[1]],
            lines: 0,
        }
    }

    fn solid(&mut self, corners: [DVec3; 3], normals: [DVec3; 3], color: [u8; 3]) {
        let outside = facing(corners);
        self.each(corners, |canvas, at, weights, depth| {
            if depth > canvas.depth[at] {
                let normal: DVec3 = (0..3).map(|k| weights[k] * normals[k]).sum();
                canvas.depth[at] = depth;
                canvas.color[at] = shaded(normal, outside, color);
            }
        });
    }

    fn flat(&mut self, corners: [DVec3; 3], color: [u8; 4]) {
        self.each(corners, |canvas, at, _, depth| {
            let behind = canvas.depth[at] > depth;
            canvas.color[at] = if behind {
                over(canvas.color[at], premultiplied(color, 1.0))
            } else {
                over(premultiplied(color, 1.0), canvas.color[at])
            };
        });
    }

    /// Pieces overlap at their joints: each pixel takes the colour of a line once.
    fn line(&mut self, points: &[DVec3], width: f64, color: [u8; 4], behind: f64) {
        self.lines += 1;
        for pair in points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let along = (b - a).truncate().normalize_or(DVec2::X);
            let across = 0.5 * width * along.perp();
            let beyond = 0.2 * width * along;
            let corner = |p: DVec3, side: f64, out: f64| {
                DVec3::from(((p.truncate() + side * across + out * beyond), p.z))
            };
            let strip = [
                corner(a, -1.0, -1.0),
                corner(a, 1.0, -1.0),
                corner(b, 1.0, 1.0),
                corner(b, -1.0, 1.0),
            ];
            for triangle in [[0, 1, 2], [0, 2, 3]] {
                let corners = triangle.map(|k: usize| strip[k]);
                self.each(corners, |canvas, at, _, depth| {
                    let hidden = canvas.depth[at] > depth + LIFT;
                    let share = if hidden { behind } else { 1.0 };
                    if canvas.touched[at] != canvas.lines {
                        canvas.touched[at] = canvas.lines;
                        let ink = premultiplied(color, share);
                        canvas.color[at] = over(ink, canvas.color[at]);
                    }
                });
            }
        }
    }

    /// Calls `paint` with every pixel whose middle is in a triangle, the weights of the corners and the depth there.
    fn each(
        &mut self,
        corners: [DVec3; 3],
        mut paint: impl FnMut(&mut Self, usize, [f64; 3], f64),
    ) {
        let [a, b, c] = corners;
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        let ends = |values: [f64; 3], first: usize, count: usize| {
            let low = values.into_iter().fold(f64::INFINITY, f64::min);
            let high = values.into_iter().fold(f64::NEG_INFINITY, f64::max);
            let (first, last) = (first as f64, (first + count) as f64);
            (
                (low.clamp(first, last) as usize),
                (high.clamp(first, last).ceil() as usize),
            )
        };
        if area.abs() < 1e-9 || !area.is_finite() {
            return;
        }
        let (left, right) = ends([a.x, b.x, c.x], 0, self.size[0]);
        let (top, bottom) = ends([a.y, b.y, c.y], self.first, self.size[1]);
        for y in top..bottom {
            for x in left..right {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let v = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
                let w = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
                let weights = [1.0 - v - w, v, w];
                if weights.iter().all(|weight| *weight >= 0.0) {
                    let depth = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
                    let at = x + self.size[0] * (y - self.first);
                    paint(self, at, weights, depth);
                }
            }
        }
    }

    fn bytes(&self) -> Vec<u8> {
        let byte = |x: f32| (255.0 * x.clamp(0.0, 1.0)).round() as u8;
        self.color
            .iter()
            .flat_map(|color| color.map(byte))
            .collect()
    }
}

/// Whether a triangle shows its outside; y points down.
fn facing([a, b, c]: [DVec3; 3]) -> bool {
    (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) < 0.0
}

/// RGBA of a lit solid, as `fragment_solid` of the shader.
fn shaded(normal: DVec3, outside: bool, color: [u8; 3]) -> [f32; 4] {
    let normal = normal.normalize_or_zero() * if outside { 1.0 } else { -1.0 };
    let lit = 0.5 + 0.5 * normal.dot(LIGHT);
    let shade = if outside {
        0.28 + 0.72 * lit * lit
    } else {
        0.35
    };
    let gleam = if outside { 0.25 * lit.powi(8) } else { 0.0 };
    let [r, g, b] = color.map(|x| {
        let base = f64::from(x) / 255.0 * shade;
        (base + (1.0 - base) * gleam) as f32
    });
    [r, g, b, 1.0]
}

fn premultiplied([r, g, b, alpha]: [u8; 4], share: f64) -> [f32; 4] {
    let opacity = f32::from(alpha) / 255.0 * share as f32;
    let [r, g, b] = [r, g, b].map(|x| f32::from(x) / 255.0 * opacity);
    [r, g, b, opacity]
}

fn over(upper: [f32; 4], lower: [f32; 4]) -> [f32; 4] {
    std::array::from_fn(|k| upper[k] + lower[k] * (1.0 - upper[3]))
}

fn straight(picture: RgbaImage) -> Vec<u8> {
    let mut bytes = picture.into_raw();
    for pixel in bytes.chunks_exact_mut(4) {
        let alpha = f32::from(pixel[3]);
        for value in &mut pixel[..3] {
            *value = (f32::from(*value) * 255.0 / alpha.max(1.0))
                .min(255.0)
                .round() as u8;
        }
    }
    bytes
}
