//! The sphere as a picture against the definitions, pixel by pixel.

use crate::common::gpu::gpu;
use crate::common::random::Random;
use grazing::brdf::fresnel::Fresnel;
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, COMBINED, Params};
use grazing::figure::sphere_image::{SphereSource, error_colors, render, sphere_image};
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
        lobe: lobe_values([30.0, 0.4]),
        eta: 1.5,
    };
    Brdf {
        model: &COMBINED,
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
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_models_sphere_is_the_definition() {
    let gpu = gpu();
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
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_split_shows_the_table_left_and_the_model_right() {
    let gpu = gpu();
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
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn unmeasured_directions_are_hatched_not_black() {
    let gpu = gpu();
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

/// GL draws what the first choice draws.
#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
#[cfg_attr(not(target_os = "linux"), ignore = "GL is there on Linux")]
fn gl_draws_the_same_sphere() {
    let first = gpu();
    let gl = headless_on(wgpu::Backends::GL).unwrap_or_else(|reason| {
        panic!("no GL ({reason}); install libegl1 and libgl1-mesa-dri or set SKIP_GPU=1")
    });
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

/// Mean distance in steps of 255 between two pictures with premultiplied bytes.
fn mean_distance(first: &RgbaImage, second: &[u8]) -> f64 {
    let distances = first.as_raw().iter().zip(second);
    let sum: f64 = distances.map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / second.len() as f64
}

/// The share of pixels that are more than two steps of 255 apart in some channel.
fn share_of_others(first: &RgbaImage, second: &[u8]) -> f64 {
    let pixels = first.pixels().zip(second.as_chunks::<4>().0);
    let apart =
        |(a, b): &(&image::Rgba<u8>, &[u8; 4])| a.0.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 2);
    pixels.filter(apart).count() as f64 / f64::from(SIZE * SIZE)
}

/// A way to draw without an adapter, premultiplied.
type Draw = fn(&SphereSource, &SphereView) -> Vec<u8>;

const ON_SCREEN: Draw = |source, view| sphere_image(source, view, SIZE as usize);

const FOR_FILES: Draw = |source, view| {
    let mut bytes = render(source, view, SIZE as usize).to_rgba8();
    for [r, g, b, alpha] in bytes.as_chunks_mut::<4>().0 {
        for value in [r, g, b] {
            *value = (f64::from(*value) * f64::from(*alpha) / 255.0).round() as u8;
        }
    }
    bytes
};

/// How far the picture of the adapter is from the one without, the mean of table, model and the two split.
fn adapter_distance(
    gpu: &Gpu,
    table: &Arc<Table>,
    draw: Draw,
    shift: f64,
    distance: fn(&RgbaImage, &[u8]) -> f64,
) -> f64 {
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, table);
    let view = SphereView {
        exposure_stops: shift,
        ..SphereView::default()
    };
    let measured = Source::Measured(Arc::clone(table), Lookup::Smooth);
    let model = Source::Model(brdf());
    let sources = [
        (2.0, SphereSource::One(measured.clone())),
        (-2.0, SphereSource::One(model.clone())),
        (
            0.25,
            SphereSource::Split {
                left: measured,
                right: model,
                at: 0.25,
            },
        ),
    ];
    let distances = sources.iter().map(|(split, source)| {
        let first = picture(gpu, &texture, *split, Lookup::Smooth);
        distance(&first, &draw(source, &view))
    });
    distances.sum::<f64>() / sources.len() as f64
}

/// Largest distance in steps of 255 of a part enlarged from the same part of a picture twice as large.
fn enlarged_distance(gpu: &Gpu, center: [f64; 2]) -> u8 {
    let texture = TableTexture::empty(&gpu.device, &gpu.queue);
    let pass = SpherePass::new(&gpu.device, offscreen::FORMAT);
    let slot = pass.slot(&gpu.device, &texture);
    let view = SphereView::default();
    let plain = SphereUniform::new(&view, &brdf(), Lookup::Smooth, -2.0, SIZE as f32);
    let draw = |size, uniform: &SphereUniform| {
        slot.write(&gpu.queue, uniform);
        offscreen::render(gpu, size, |render| pass.draw(render, &slot)).expect("a picture")
    };
    let whole = draw(2 * SIZE, &plain);
    let part = draw(SIZE, &plain.in_sight(center, 2.0));
    // Of the whole picture, three quarters from the left and five eighths from the top of a half.
    let (left, top) = (SIZE * 3 / 4, SIZE * 5 / 8);
    part.enumerate_pixels()
        .flat_map(|(x, y, pixel)| {
            let wanted = whole.get_pixel(left + x, top + y).0;
            (0..4).map(move |k| pixel[k].abs_diff(wanted[k]))
        })
        .max()
        .expect("pixels")
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_part_enlarged_is_a_part_of_a_larger_sphere() {
    let gpu = gpu();
    let far = enlarged_distance(&gpu, [0.25, -0.125]);
    assert!(far <= 2, "{far}");
    let planted = enlarged_distance(&gpu, [0.25, -0.15]);
    assert!(planted > 20, "a planted shift went unnoticed: {planted}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_picture_without_an_adapter_is_the_same() {
    let gpu = gpu();
    let table = Arc::new(table(0.2));
    let mean = |shift| adapter_distance(&gpu, &table, ON_SCREEN, shift, mean_distance);
    println!("one sample a pixel: {:.3} of 255 apart", mean(0.0));
    assert!(mean(0.0) < 0.05, "{}", mean(0.0));
    // A fortieth of a stop is 1.7 % of the light.
    assert!(
        mean(0.025) > 0.2,
        "a planted shift went unnoticed: {}",
        mean(0.025)
    );
    // Sixteen samples differ from one where the colour bends: at the rim, the hatch and the highlights.
    let share = |shift| adapter_distance(&gpu, &table, FOR_FILES, shift, share_of_others);
    println!(
        "sixteen samples a pixel: {:.4} of the pixels differ",
        share(0.0)
    );
    assert!(share(0.0) < 0.06, "{}", share(0.0));
    assert!(
        share(0.1) > 0.2,
        "a planted shift went unnoticed: {}",
        share(0.1)
    );
}

/// Mean distance in steps of 255 between the comparison on the adapter and the one without.
fn compared_distance(gpu: &Gpu, table: &Arc<Table>, error: SphereError, shift: f64) -> f64 {
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, table);
    let pass = SpherePass::new(&gpu.device, offscreen::FORMAT);
    let slot = pass.slot(&gpu.device, &texture);
    // The measurement is the model, but for a planted half of the highlight.
    let mut other = brdf();
    other.params.k_s = [4.0; 3];
    let view = SphereView::default();
    let colors = std::array::from_fn(|k| error_colors(error).color(k as f64 / 32.0));
    let uniform = SphereUniform::new(&view, &other, Lookup::Smooth, 0.0, 0.5 * SIZE as f32);
    slot.write(&gpu.queue, &uniform.comparing(error, &colors));
    let first = offscreen::render(gpu, SIZE, |render| pass.draw_compared(render, &slot));
    other.params.k_s = [4.0 + shift; 3];
    let source = SphereSource::Compared {
        measured: Source::Measured(Arc::clone(table), Lookup::Smooth),
        model: Source::Model(other),
        error,
    };
    mean_distance(&first.expect("a picture"), &ON_SCREEN(&source, &view))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_comparison_is_its_definition() {
    let gpu = gpu();
    let table = Arc::new(table(0.2));
    for error in [SphereError::Difference, SphereError::Ratio] {
        let mean = compared_distance(&gpu, &table, error, 0.0);
        println!("{error:?} with and without an adapter: {mean:.3} of 255 apart");
        assert!(mean < 0.08, "{error:?}: {mean}");
        let planted = compared_distance(&gpu, &table, error, 1.0);
        assert!(
            planted > 0.25,
            "a shift went unnoticed: {error:?} {planted}"
        );
    }
}
