//! The sphere as a picture against the definitions, pixel by pixel.

mod common;

use common::{Random, gpu};
use grazing::brdf::fresnel::Fresnel;
use grazing::brdf::{Brdf, MODELS, Params};
use grazing::figure::sphere_image::{error_image, sphere_image};
use grazing::figure::subject::Source;
use grazing::geom::Cosines;
use grazing::geom::color::srgb_bytes;
use grazing::geom::sphere::{SphereView, local_directions};
use grazing::geom::sphere_error::SphereError;
use grazing::gpu::adapter::{Gpu, headless_on};
use grazing::gpu::offscreen;
use grazing::gpu::sphere_pass::{SpherePass, SphereUniform};
use grazing::gpu::table_texture::TableTexture;
use grazing::measured::lookup::Lookup;
use grazing::measured::{Grid, Table};
use image::RgbaImage;
use std::f64::consts::PI;
use std::sync::Arc;

const SIZE: u32 = 200;

fn brdf() -> Brdf {
    let params = Params {
        rho_d: [0.5, 0.2, 0.1],
        k_s: [8.0; 3],
        s: 30.0,
        alpha: 0.4,
        eta: 1.5,
    };
    Brdf {
        model: MODELS[2],
        fresnel: Fresnel::Exact,
        params,
    }
}

fn picture(gpu: &Gpu, table: &TableTexture, split: f64, lookup: Lookup) -> RgbaImage {
    let pass = SpherePass::new(&gpu.device, offscreen::FORMAT);
    let slot = pass.slot(&gpu.device, table);
    let radius = 0.5 * SIZE as f32;
    slot.write(
        &gpu.queue,
        &SphereUniform::new(&SphereView::default(), &brdf(), lookup, split, radius),
    );
    offscreen::render(gpu, SIZE, |render_pass| pass.draw(render_pass, &slot)).expect("a picture")
}

/// A pixel's place in units of the radius; the draw leaves one pixel around the sphere.
fn place(x: u32, y: u32) -> (f64, f64) {
    let half = 0.5 * f64::from(SIZE);
    let stretch = 1.0 + 2.0 / half;
    let unit = |k: u32| (f64::from(k) + 0.5 - half) / half * stretch;
    (unit(x), -unit(y))
}

/// Written from the definitions: the sum of f_r cos θi E over the lights, with E = π at strength 1.
fn expected(x: f64, y: f64, gain: f64) -> [u8; 3] {
    let mut radiance = [0.0; 3];
    for light in SphereView::default().lights {
        let (wi, wo) = local_directions(x, y, &light).expect("on the sphere");
        let c = Cosines::from_directions(wi, wo);
        if c.cos_theta_i > 0.0 {
            for (total, f_r) in radiance.iter_mut().zip(brdf().eval(&c)) {
                *total += gain * PI * f_r * c.cos_theta_i;
            }
        }
    }
    srgb_bytes(radiance)
}

fn worst_distance(picture: &RgbaImage, gain: f64) -> u8 {
    let mut random = Random(5);
    let mut worst = 0;
    for _ in 0..800 {
        let (px, py) = (
            (random.unit() * f64::from(SIZE)) as u32,
            (random.unit() * f64::from(SIZE)) as u32,
        );
        let (x, y) = place(px, py);
        if x.hypot(y) > 0.97 {
            continue;
        }
        let pixel = picture.get_pixel(px, py);
        for (shown, wanted) in pixel.0.iter().zip(expected(x, y, gain)) {
            worst = worst.max(shown.abs_diff(wanted));
        }
    }
    worst
}

#[test]
fn the_models_sphere_is_the_definition() {
    let Some(gpu) = gpu() else { return };
    let none = TableTexture::empty(&gpu.device, &gpu.queue);
    let picture = picture(&gpu, &none, -2.0, Lookup::Smooth);
    assert!(
        worst_distance(&picture, 1.0) <= 1,
        "{}",
        worst_distance(&picture, 1.0)
    );
    assert!(
        worst_distance(&picture, 1.03) > 1,
        "3 % more light went unnoticed"
    );
    assert_eq!(picture.get_pixel(0, 0).0, [0; 4], "outside is transparent");
    assert_eq!(picture.get_pixel(SIZE / 2, SIZE / 2).0[3], 255);
}

/// The model as a table; cells with θ_i or θ_o past `limit` are unmeasured.
fn table(limit: f64) -> Table {
    let grid = Grid::FOLDED;
    let cells = (0..grid.len()).map(|index| {
        let (h, d, phi) = grid.bins(index);
        let c = grid.center(h, d, phi).cosines();
        let measured = c.cos_theta_i.min(c.cos_theta_o) >= limit;
        if measured {
            brdf().eval(&c).map(|x| x as f32)
        } else {
            [-1.0; 3]
        }
    });
    Table::new(grid, cells.collect())
}

#[test]
fn the_split_shows_the_table_left_and_the_model_right() {
    let Some(gpu) = gpu() else { return };
    // All cells hold a value here, also below the horizon.
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, &table(-1.0));
    let split = picture(&gpu, &texture, 0.0, Lookup::Smooth);
    let model = picture(&gpu, &texture, -2.0, Lookup::Smooth);
    let measured = picture(&gpu, &texture, 2.0, Lookup::Smooth);
    for (x, y, pixel) in split.enumerate_pixels() {
        let side = if place(x, y).0 < 0.0 {
            &measured
        } else {
            &model
        };
        assert_eq!(pixel, side.get_pixel(x, y));
    }
    // The table interpolates the model within a few steps of 255, away from the highlight's flank.
    let close = measured
        .pixels()
        .zip(model.pixels())
        .filter(|(a, b)| a.0.iter().zip(b.0).all(|(a, b)| a.abs_diff(b) <= 3));
    assert!(close.count() > (SIZE * SIZE) as usize * 95 / 100);
    assert_ne!(measured, picture(&gpu, &texture, 2.0, Lookup::Nearest));
}

#[test]
fn unmeasured_directions_are_hatched_not_black() {
    let Some(gpu) = gpu() else { return };
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, &table(0.5));
    let picture = picture(&gpu, &texture, 2.0, Lookup::Smooth);
    let mut hatched = 0;
    for (px, py, pixel) in picture.enumerate_pixels() {
        let (x, y) = place(px, py);
        if x.hypot(y) > 0.97 {
            continue;
        }
        let unmeasured = SphereView::default().lights.iter().any(|light| {
            let (wi, wo) = local_directions(x, y, light).expect("on the sphere");
            wi.z > 0.01 && wi.z.min(wo.z) < 0.48
        });
        if unmeasured {
            let [r, g, b, a] = pixel.0;
            // The two greys of the hatch: nothing of the reddish material, nothing near black.
            assert!(
                r.abs_diff(g) < 4 && b >= r && r > 80 && a == 255,
                "({px}, {py}) {pixel:?}"
            );
            hatched += 1;
        }
    }
    assert!(hatched > 1000, "the planted gap covers {hatched} pixels");
}

/// Where there is GL at all, it draws what the first choice draws.
#[test]
fn gl_draws_the_same_sphere() {
    let Some(first) = gpu() else { return };
    let Ok(gl) = headless_on(wgpu::Backends::GL) else {
        eprintln!("no GL here: not compared");
        return;
    };
    let draw = |gpu: &Gpu| {
        let texture = TableTexture::upload(&gpu.device, &gpu.queue, &table(0.3));
        picture(gpu, &texture, 0.1, Lookup::Smooth)
    };
    let (a, b) = (draw(&first), draw(&gl));
    let differing = a
        .pixels()
        .zip(b.pixels())
        .filter(|(a, b)| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 1));
    // The hatch starts in another corner, and a pixel in a hundred may be on the other side of a cell's edge.
    let differing = differing.count();
    assert!(differing < (SIZE * SIZE) as usize / 20, "{differing}");
    assert!(b.get_pixel(SIZE * 3 / 4, SIZE / 2).0[0] > 40, "lit");
}

/// Mean distance in steps of 255 between the picture of the adapter and the one without, for the table and the model.
fn mean_distance(gpu: &Gpu, table: &Arc<Table>, shift: f64) -> f64 {
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, table);
    let view = SphereView {
        exposure_stops: shift,
        ..SphereView::default()
    };
    let sources = [
        (2.0, Source::Measured(Arc::clone(table), Lookup::Smooth)),
        (-2.0, Source::Model(brdf())),
    ];
    let mut total = 0.0;
    for (split, source) in sources {
        let first = picture(gpu, &texture, split, Lookup::Smooth);
        let second = sphere_image(&source, &view, SIZE as usize);
        let distances = first.as_raw().iter().zip(&second);
        let sum: f64 = distances.map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
        total += sum / second.len() as f64;
    }
    0.5 * total
}

#[test]
fn the_picture_without_an_adapter_is_the_same() {
    let Some(gpu) = gpu() else { return };
    let table = Arc::new(table(0.2));
    let mean = mean_distance(&gpu, &table, 0.0);
    println!("with and without an adapter: {mean:.3} of 255 apart");
    assert!(mean < 0.05, "{mean}");
    // A fortieth of a stop is 1.7 % of the light.
    let planted = mean_distance(&gpu, &table, 0.025);
    assert!(planted > 0.2, "a planted shift went unnoticed: {planted}");
}

/// Mean distance in steps of 255 between the comparison on the adapter and the one without.
fn mean_compared_distance(gpu: &Gpu, table: &Arc<Table>, error: SphereError, shift: f64) -> f64 {
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, table);
    let pass = SpherePass::new(&gpu.device, offscreen::FORMAT);
    let slot = pass.slot(&gpu.device, &texture);
    // The measurement is the model, but for a planted half of the highlight.
    let mut other = brdf();
    other.params.k_s = [4.0; 3];
    let view = SphereView::default();
    let colors = std::array::from_fn(|k| [8 * k.min(31) as u8, 255 - 8 * k.min(31) as u8, 77]);
    let uniform = SphereUniform::new(&view, &other, Lookup::Smooth, 0.0, 0.5 * SIZE as f32);
    slot.write(&gpu.queue, &uniform.comparing(error, &colors));
    let first = offscreen::render(gpu, SIZE, |render| pass.draw_compared(render, &slot));
    let first = first.expect("a picture");
    let map = |place: f64| {
        let x = (place + shift).clamp(0.0, 1.0) * 32.0;
        let low = (x as usize).min(31);
        let mix = |a: u8, b: u8| {
            let (a, b) = (f64::from(a), f64::from(b));
            (a + (x - low as f64) * (b - a)).round() as u8
        };
        std::array::from_fn(|k| mix(colors[low][k], colors[low + 1][k]))
    };
    let sources = [
        Source::Measured(Arc::clone(table), Lookup::Smooth),
        Source::Model(other),
    ];
    let second = error_image([&sources[0], &sources[1]], &view, error, map, SIZE as usize);
    let distances = first.as_raw().iter().zip(&second);
    let sum: f64 = distances.map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / second.len() as f64
}

#[test]
fn the_comparison_is_its_definition() {
    let Some(gpu) = gpu() else { return };
    let table = Arc::new(table(0.2));
    for error in [SphereError::Difference, SphereError::Ratio] {
        let mean = mean_compared_distance(&gpu, &table, error, 0.0);
        println!("{error:?} with and without an adapter: {mean:.3} of 255 apart");
        assert!(mean < 0.1, "{error:?}: {mean}");
        let planted = mean_compared_distance(&gpu, &table, error, 0.02);
        assert!(planted > 0.5, "a shift went unnoticed: {error:?} {planted}");
    }
}
