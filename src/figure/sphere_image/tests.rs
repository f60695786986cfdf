use super::render::sampled;
use super::*;
use crate::geom::sight::Sight;
use crate::geom::sphere::Light;
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, PI};
use std::io::Cursor;
use std::sync::Arc;

fn diffuse(albedo: f64) -> Source {
    Source::Function(Arc::new(move |_, _| Some([albedo * FRAC_1_PI; 3])))
}

fn unmeasured() -> Source {
    Source::Function(Arc::new(|_, _| None))
}

/// Lit from the eye: the radiance of a diffuse sphere is its albedo times √(1 − x² − y²).
fn frontal() -> SphereView {
    let light = Light {
        direction: DVec3::Z,
        strength: [1.0; 3],
    };
    SphereView {
        lights: vec![light],
        exposure_stops: 0.0,
    }
}

/// Radius of the sphere in pixels: one is left free around it.
fn radius_px(size: usize) -> f64 {
    let half = 0.5 * size as f64;
    half / (1.0 + 2.0 / half)
}

/// A diffuse sphere of albedo `albedo` seen at a pixel of `size`.
fn lambert(albedo: f64, size: usize, at: [usize; 2]) -> [u8; PIXEL] {
    let source = SphereSource::One(diffuse(albedo));
    let bytes = sphere_image(&source, &SphereView::default(), size);
    let start = (at[1] * size + at[0]) * PIXEL;
    std::array::from_fn(|k| bytes[start + k])
}

#[test]
fn a_diffuse_sphere_is_its_closed_form() {
    let (size, at) = (64, [40, 20]);
    let unit = |k: usize| (k as f64 + 0.5 - 32.0) / 32.0 * (1.0 + 2.0 / 32.0);
    let (x, y) = (unit(at[0]), -unit(at[1]));
    let n = DVec3::new(x, y, (1.0 - x * x - y * y).sqrt());
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
    let source = SphereSource::One(unmeasured());
    let bytes = sphere_image(&source, &SphereView::default(), 32);
    let tones = HATCH.map(|tone| tone.map(|x| (255.0 * x).round() as u8));
    let inside = bytes.chunks_exact(PIXEL).filter(|pixel| pixel[3] == 255);
    let hatched = inside.filter(|pixel| tones.iter().any(|tone| tone == pixel));
    assert!(hatched.count() > 300);
    assert!(sphere_image(&source, &SphereView::default(), 0).is_empty());
}

/// The light of a whole picture and how much of it is covered, over their closed forms: ∫ ρ √(1 − r²) over the disk
/// is 2π/3 ρ, its area π.
fn against_the_integrals(picture: &[[f32; 4]], size: usize, albedo: f64) -> (f64, f64) {
    let sum = |k: usize| picture.iter().map(|pixel| f64::from(pixel[k])).sum::<f64>();
    let area = PI * radius_px(size).powi(2);
    (sum(0) / (2.0 / 3.0 * area * albedo), sum(3) / area)
}

#[test]
fn light_and_area_of_a_picture_are_the_integrals_over_the_sphere() {
    for size in [7, 64, 301] {
        let picture = render(&SphereSource::One(diffuse(0.7)), &frontal(), size).to_linear();
        let (light, area) = against_the_integrals(&picture, size, 0.7);
        let tolerance = 0.3 / (size as f64).powf(1.5);
        assert!((light - 1.0).abs() < tolerance, "{size} {light}");
        assert!((area - 1.0).abs() < 3.0 * tolerance, "{size} {area}");
        let (planted, _) = against_the_integrals(&picture, size, 0.72);
        assert!((planted - 1.0).abs() > tolerance, "3 % went unnoticed");
    }
}

#[test]
fn an_enlarged_part_has_the_light_of_its_place() {
    let (size, source) = (41, SphereSource::One(diffuse(0.7)));
    let sight = Sight::default().zoomed(4.0, [0.5, -0.3]);
    let seen = |sight| render_part(&source, &frontal(), sight, size).to_linear();
    let (part, planted) = (seen(sight), seen(Sight::default()));
    let mut whole_is_off = 0.0_f64;
    for at in [[5, 5], [20, 20], [35, 8], [12, 33]] {
        let unit = |place: usize| (place as f64 + 0.5 - 20.5) / radius_px(size);
        let (x, y) = sight.point(unit(at[0]), -unit(at[1]));
        let expected = 0.7 * (1.0 - x * x - y * y).sqrt();
        let of = |picture: &[[f32; 4]]| f64::from(picture[at[1] * size + at[0]][0]);
        assert!((of(&part) - expected).abs() < 1e-3, "{at:?}");
        whole_is_off = whole_is_off.max((of(&planted) - expected).abs());
    }
    assert!(whole_is_off > 0.1, "the whole sphere went unnoticed");
}

#[test]
fn exposure_scales_and_nothing_is_clamped_before_the_bytes() {
    let source = SphereSource::One(diffuse(0.9));
    let mut view = frontal();
    let plain = render(&source, &view, 40);
    view.exposure_stops = 3.0;
    let bright = render(&source, &view, 40);
    for (a, b) in plain.to_linear().iter().zip(bright.to_linear()) {
        for k in 0..3 {
            assert!((8.0 * a[k] - b[k]).abs() <= 1e-6 * b[k]);
        }
        assert_eq!(a[3], b[3]);
    }
    let middle = (20 * 40 + 20) * PIXEL;
    assert_eq!(bright.to_rgba8()[middle..middle + 4], [255; 4]);
    assert!(bright.to_linear()[20 * 40 + 20][0] > 7.0);
}

/// The largest distance of a channel between two pictures.
fn worst(a: &LinearImage, b: &LinearImage) -> f32 {
    let (a, b) = (a.to_linear(), b.to_linear());
    let distances = a.iter().flatten().zip(b.iter().flatten());
    distances.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn more_samples_come_closer_to_the_truth_at_edges() {
    // The rim, and a line that cuts through pixels.
    let source = SphereSource::Split {
        left: diffuse(0.1),
        right: diffuse(0.9),
        at: 0.123,
    };
    let at = |side| sampled(&source, &frontal(), Sight::default(), 24, side);
    let truth = at(64);
    let [one, four, sixteen] = [1, 4, 16].map(|side| worst(&at(side), &truth));
    println!("1, 16, 256 samples: {one:.4}, {four:.4}, {sixteen:.4} from 4096");
    assert!(one > 0.3, "{one}");
    // A straight edge moves by at most half a column of samples.
    assert!(four < 0.5 / 4.0 && sixteen < 0.5 / 16.0, "{four} {sixteen}");
    let drawn = render(&source, &frontal(), 24).to_linear();
    assert_eq!(drawn, at(SAMPLES_A_SIDE).to_linear());
    assert_ne!(drawn, at(SAMPLES_A_SIDE + 1).to_linear());
}

#[test]
fn a_split_shows_one_left_and_the_other_right() {
    let size = 60;
    let [dark, light] = [0.1, 0.9].map(diffuse);
    let alone =
        |source: &Source| render(&SphereSource::One(source.clone()), &frontal(), size).to_linear();
    let split = SphereSource::Split {
        left: dark.clone(),
        right: light.clone(),
        at: 0.0,
    };
    let split = render(&split, &frontal(), size).to_linear();
    let (dark, light) = (alone(&dark), alone(&light));
    for k in 0..size * size {
        let side = if k % size < size / 2 { &dark } else { &light };
        assert_eq!(split[k], side[k], "pixel {k}");
    }
    assert_ne!(dark, light);
}

#[test]
fn what_was_not_measured_is_hatched_in_bytes_and_absent_in_linear_light() {
    let size = 300;
    let split = SphereSource::Split {
        left: unmeasured(),
        right: diffuse(0.5),
        at: 0.0,
    };
    let picture = render(&split, &frontal(), size);
    let (bytes, linear) = (picture.to_rgba8(), picture.to_linear());
    let tones = HATCH.map(|tone| tone.map(|x| (255.0 * x).round() as u8));
    let at = |x: usize, y: usize| (y * size + x) * PIXEL;
    let row: Vec<&[u8]> = (40..140)
        .map(|x| &bytes[at(x, 150)..at(x + 1, 150)])
        .collect();
    for tone in tones {
        let count = row.iter().filter(|pixel| **pixel == tone).count();
        assert!(count > 30, "{count} of {tone:?}");
    }
    assert!((40..140).all(|x| linear[150 * size + x] == [0.0; 4]));
    assert_eq!(linear[150 * size + 200][3], 1.0);
    // Half of the rim's pixels are covered in part, hatched or not.
    let rim: Vec<u8> = bytes.chunks_exact(PIXEL).map(|pixel| pixel[3]).collect();
    let partial = |from: usize| (0..size * size / 2).any(|k| (1..255).contains(&rim[from + k]));
    assert!(partial(0) && partial(size * size / 2));
}

#[test]
fn a_background_lies_behind_the_sphere_in_linear_light() {
    let split = SphereSource::Split {
        left: unmeasured(),
        right: diffuse(0.5),
        at: 0.0,
    };
    let size = 50;
    let mut picture = render(&split, &frontal(), size);
    let clear = picture.to_linear();
    picture.background = Some([0.25; 3]);
    for (k, (over, clear)) in picture.to_linear().iter().zip(clear).enumerate() {
        assert!((over[0] - clear[0] - 0.25 * (1.0 - clear[3])).abs() < 1e-6);
        assert!((over[3] - 1.0).abs() < 1e-6, "pixel {k}");
    }
    let bytes = picture.to_rgba8();
    assert_eq!(bytes[..4], [137, 137, 137, 255]);
    assert!(bytes.chunks_exact(PIXEL).all(|pixel| pixel[3] == 255));
    let tone = HATCH[0].map(|x| (255.0 * x).round() as u8);
    assert!(bytes.chunks_exact(PIXEL).any(|pixel| pixel == tone));
}

#[test]
fn an_exr_is_read_back_as_the_same_floats() {
    let view = SphereView {
        exposure_stops: 2.5,
        ..SphereView::default()
    };
    let picture = render(&SphereSource::One(diffuse(0.8)), &view, 37);
    let mut file = Cursor::new(Vec::new());
    picture.write_exr(&mut file).expect("memory takes it");
    let read = image::load_from_memory_with_format(file.get_ref(), image::ImageFormat::OpenExr);
    let read = read.expect("an EXR").into_rgba32f();
    assert_eq!(read.dimensions(), (37, 37));
    let linear = picture.to_linear();
    assert_eq!(read.as_raw().as_slice(), linear.as_flattened());
    assert!(read.as_raw().iter().any(|value| *value > 2.0), "unclamped");
    let mut planted = picture.clone();
    planted.background = Some([0.0; 3]);
    assert_ne!(read.as_raw().as_slice(), planted.to_linear().as_flattened());
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let source = SphereSource::Compared {
        measured: diffuse(0.4),
        model: diffuse(0.5),
        error: SphereError::Ratio,
    };
    let draw = || render(&source, &SphereView::default(), 33).to_linear();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    assert_eq!(pool.expect("a thread").install(draw), draw());
}

#[test]
fn a_large_picture_is_drawn_in_bands_that_fit() {
    // More rows than one band has.
    let size = 1100;
    let picture = sampled(
        &SphereSource::One(diffuse(0.8)),
        &frontal(),
        Sight::default(),
        size,
        1,
    );
    let (linear, bytes) = (picture.to_linear(), picture.to_rgba8());
    assert_eq!(linear.len(), size * size);
    assert_eq!(bytes.len(), PIXEL * size * size);
    let mut file = Cursor::new(Vec::new());
    picture.write_exr(&mut file).expect("memory takes it");
    let read = image::load_from_memory_with_format(file.get_ref(), image::ImageFormat::OpenExr);
    assert_eq!(
        read.expect("an EXR").into_rgba32f().as_raw().as_slice(),
        linear.as_flattened()
    );
    // It is as bright above as below, and as a picture of one band at the same places.
    let row = |y: usize| &linear[size * y..size * (y + 1)];
    for y in [0, 300, 500] {
        let far = row(y)
            .iter()
            .flatten()
            .zip(row(size - 1 - y).iter().flatten());
        assert!(
            far.into_iter().all(|(a, b)| (a - b).abs() < 1e-5),
            "row {y}"
        );
    }
    assert!(row(550)[550][0] > 0.5 && row(1060)[550][0] > 0.0);
}
