//! `grazing render` as a person meets it: the pictures as numbers, and one clear line for everything that is wrong.

use crate::common::folder::Folder;
use crate::common::merl::merl_file;
use crate::common::program::{failed, grazing, stderr, stdout, succeeded};
use grazing::geom::Cosines;
use grazing::geom::color::srgb_encode;
use image::{Rgba, Rgba32FImage, RgbaImage};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const DIFFUSE: &str = r#"{"model": "phong", "rho_d": [0.6, 0.4, 0.2], "k_s": [0, 0, 0], "s": 10}"#;

fn render(source: &Path, output: &Path, options: &str) -> Output {
    let options: Vec<&str> = options.split_whitespace().collect();
    let mut args: Vec<&dyn AsRef<std::ffi::OsStr>> = vec![&"render", &source, &"-o", &output];
    for option in &options {
        args.push(option);
    }
    grazing(&args)
}

fn png(source: &Path, output: &Path, options: &str) -> RgbaImage {
    assert_eq!(succeeded(&render(source, output, options)), "");
    image::open(output).expect("a picture").into_rgba8()
}

fn exr(source: &Path, output: &Path, options: &str) -> Rgba32FImage {
    assert_eq!(succeeded(&render(source, output, options)), "");
    image::open(output).expect("a picture").into_rgba32f()
}

/// A pixel's place in units of the radius; a pixel is free around the sphere.
fn place(size: u32, x: u32, y: u32) -> (f64, f64) {
    let half = 0.5 * f64::from(size);
    let unit = |k: u32| (f64::from(k) + 0.5 - half) / half * (1.0 + 2.0 / half);
    (unit(x), -unit(y))
}

/// A grey diffuse material in MERL layout; cells with a cosine below `limit` are unmeasured.
fn grey(folder: &Folder, name: &str, limit: f64) -> PathBuf {
    let f_r = |c: &Cosines| (c.cos_theta_i.min(c.cos_theta_o) >= limit).then_some([0.1; 3]);
    folder.file(name, merl_file(f_r))
}

#[test]
fn a_diffuse_sphere_is_its_closed_form_in_png_and_exr() {
    let folder = Folder::new();
    let model = folder.file("model.json", DIFFUSE);
    let options = "--size 90 --light viewer";
    let bytes = png(&model, &folder.path("a.png"), options);
    let floats = exr(
        &model,
        &folder.path("a.exr"),
        &format!("{options} --exposure 3"),
    );
    assert_eq!(
        (bytes.dimensions(), floats.dimensions()),
        ((90, 90), (90, 90))
    );
    let (mut worst_byte, mut worst_float, mut planted): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for (px, py, pixel) in bytes.enumerate_pixels() {
        let (x, y) = place(90, px, py);
        let radius = x.hypot(y);
        let Rgba([_, _, _, alpha]) = floats[(px, py)];
        if radius > 1.05 {
            assert_eq!((pixel.0, alpha), ([0; 4], 0.0));
        }
        if radius > 0.9 {
            continue;
        }
        // ρ/π · cos θ · π, with cos θ = √(1 − r²).
        let cos_theta = (1.0 - radius * radius).sqrt();
        for (k, albedo) in [0.6, 0.4, 0.2].into_iter().enumerate() {
            let light = albedo * cos_theta;
            let byte = f64::from(pixel[k]);
            worst_byte = worst_byte.max((byte - 255.0 * srgb_encode(light)).abs());
            planted = planted.max((byte - 255.0 * srgb_encode(1.03 * light)).abs());
            worst_float = worst_float.max((f64::from(floats[(px, py)][k]) - 8.0 * light).abs());
        }
        assert_eq!((pixel[3], alpha), (255, 1.0));
    }
    assert!(
        worst_byte < 1.0 && worst_float < 0.01,
        "{worst_byte} {worst_float}"
    );
    assert!(planted > 2.0, "3 % went unnoticed: {planted}");
}

#[test]
fn angles_of_lights_are_from_the_viewer_and_from_the_right() {
    let folder = Folder::new();
    let model = folder.file("model.json", DIFFUSE);
    let out = folder.path("a.png");
    let draw = |light: &str| png(&model, &out, &format!("--size 64 --force --light {light}"));
    let glancing = draw("glancing");
    // The direction (0.6, 0.6, 0.55) in degrees.
    let theta = (0.72_f64.sqrt() / 0.55).atan().to_degrees();
    let by_angles = draw(&format!("{theta},45"));
    assert_eq!(glancing, by_angles);
    assert_ne!(glancing, draw("45,45"), "a turn by 12° went unnoticed");
    let above = draw("90,90");
    assert!(
        above[(32, 8)][0] > 100 && above[(32, 50)][0] == 0,
        "from above"
    );
    let both = draw("90,90;90,180");
    assert!(
        both[(8, 32)][0] > 100 && both[(56, 32)][0] == 0,
        "and from the left"
    );
    assert_eq!(draw("poster"), png(&model, &out, "--size 64 --force"));
}

#[test]
fn a_split_shows_the_data_left_and_their_best_fit_right() {
    let folder = Folder::new();
    let data = grey(&folder, "grey.binary", 0.0);
    let entry = |source: &str, rho_d: f64, error: f64| {
        let source = if source.is_empty() {
            String::new()
        } else {
            format!(r#""source": {{"path": {:?}}}, "#, folder.path(source))
        };
        format!(
            r#"{{{source}"error": {error}, "model": "phong", "rho_d": [{rho_d}, 0, 0], "k_s": [0, 0, 0], "s": 10}}"#
        )
    };
    let fits = folder.file(
        "fits.json",
        format!(
            "[{}, {}, {}]",
            entry("other.binary", 0.1, 0.01),
            entry("grey.binary", 0.2, 0.5),
            entry("grey.binary", 0.3, 0.2)
        ),
    );
    let out = folder.path("a.exr");
    let draw = |options: &str| {
        let options = format!("--size 40 --light viewer --force --split {options}");
        let picture = exr(&data, &out, &options);
        // Left and right of the middle, where cos θ is 0.998.
        [picture[(17, 19)], picture[(22, 19)]].map(|Rgba([r, g, ..])| [r, g])
    };
    let near = |a: [f32; 2], b: [f32; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 0.01;
    let fits = fits.display();
    let grey = 0.1 * std::f32::consts::PI;
    let [left, right] = draw(&fits.to_string());
    assert!(near(left, [grey; 2]), "{left:?}");
    assert!(near(right, [0.3, 0.0]), "{right:?}");
    for (index, red) in [0.1, 0.2, 0.3].into_iter().enumerate() {
        let [left, right] = draw(&format!("{fits} --index {index}"));
        assert!(
            near(left, [grey; 2]) && near(right, [red, 0.0]),
            "{right:?}"
        );
    }
    let single = folder.file("single.json", DIFFUSE);
    let [_, right] = draw(&single.display().to_string());
    assert!(near(right, [0.6, 0.4]), "{right:?}");

    let strangers = format!("[{}, {}]", entry("a", 0.1, 0.1), entry("", 0.1, 0.1));
    let strangers = folder.file("strangers.json", strangers);
    let fresh = folder.path("b.png");
    let split = |path: &Path, more: &str| {
        let options = format!("--split {} {more}", path.display());
        render(&data, &fresh, &options)
    };
    failed(
        &split(&strangers, ""),
        &strangers,
        "none of the 2 models is a fit of SOURCE; --index",
    );
    failed(
        &split(&strangers, "--index 2"),
        &strangers,
        "there is no entry 2; the file has 2",
    );
    failed(
        &split(&data, ""),
        &data,
        "no JSON file; expected a model or a fit file",
    );
    assert!(!fresh.exists());
}

#[test]
fn unmeasured_parts_are_hatched_in_png_and_empty_in_exr() {
    let folder = Folder::new();
    // Under this light the right half has cosines below 0.5.
    let data = grey(&folder, "part.binary", 0.5);
    let options = "--size 64 --light 60,180 --lookup nearest";
    let bytes = png(&data, &folder.path("a.png"), options);
    let floats = exr(&data, &folder.path("a.exr"), options);
    let tones = bytes.pixels().filter(|pixel| pixel.0 == [92, 92, 102, 255]);
    assert!(tones.count() > 100, "the dark tone of the hatch");
    assert_eq!(floats[(35, 32)].0, [0.0; 4]);
    assert_eq!(floats[(20, 32)][3], 1.0);
    let white = png(
        &data,
        &folder.path("b.png"),
        &format!("{options} --background white"),
    );
    assert_eq!(white[(0, 0)].0, [255; 4]);
    let black = exr(
        &data,
        &folder.path("b.exr"),
        &format!("{options} --background black"),
    );
    assert_eq!(black[(35, 32)].0, [0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn neither_display_nor_adapter_is_needed_and_the_bytes_are_the_same() {
    let folder = Folder::new();
    let model = folder.file("model.json", DIFFUSE);
    let draw = |name: &str, threads: &str| {
        let path = folder.path(name);
        let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
            .args(["render", "--size", "50", "-o"])
            .args([&path, &model])
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env("VK_ICD_FILENAMES", "/nonexistent")
            .env("WGPU_BACKEND", "gl")
            .env("LIBGL_DRIVERS_PATH", "/nonexistent")
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .expect("the program starts");
        succeeded(&output);
        std::fs::read(path).expect("is there")
    };
    assert_eq!(draw("a.png", "1"), draw("b.png", "3"));
    assert_eq!(draw("a.exr", "1"), draw("b.exr", "3"));
}

#[test]
fn whatever_cannot_be_done_has_its_line() {
    let folder = Folder::new();
    let model = folder.file("model.json", DIFFUSE);
    let array = folder.file("array.json", format!("[{DIFFUSE}]"));
    let there = folder.file("there.png", "precious");
    let missing = folder.path("missing.binary");
    let fresh = folder.path("new.png");
    for (source, output, options, path, said) in [
        (&missing, &fresh, "", &missing, "there is no such file"),
        (
            &model,
            &there,
            "",
            &there,
            "the file exists already; --force",
        ),
        (
            &model,
            &folder.path("a.jpg"),
            "",
            &folder.path("a.jpg"),
            "expected .png or .exr",
        ),
        (
            &model,
            &folder.path("png"),
            "",
            &folder.path("png"),
            "expected .png or .exr",
        ),
        (
            &model,
            &folder.path("no/a.png"),
            "",
            &folder.path("no/a.png"),
            "no directory",
        ),
        (&array, &fresh, "--index 1", &array, "there is no entry 1"),
        (
            &model,
            &fresh,
            "--split nowhere",
            &PathBuf::from("nowhere"),
            "there is no such file",
        ),
    ] {
        failed(&render(source, output, options), path, said);
    }
    assert_eq!(std::fs::read(&there).expect("is there"), b"precious");
    assert!(!fresh.exists());
    for (options, said) in [
        ("--size 0", "0 is not in 1..=8192"),
        ("--size 8193", "8193 is not in 1..=8192"),
        ("--size big", "invalid digit"),
        (
            "--light sun",
            "\"sun\" is no light; expected poster, glancing, grazing, viewer",
        ),
        (
            "--light 200,0",
            "THETA = 200 is out of range; expected 0 to 180",
        ),
        ("--exposure 99", "out of range; expected -30 to 30 stops"),
        (
            "--background pink",
            "possible values: transparent, white, black",
        ),
        ("--lookup cubic", "possible values: nearest, smooth"),
    ] {
        let output = render(&model, &fresh, options);
        assert_eq!(output.status.code(), Some(2), "{options}");
        assert!(stderr(&output).contains(said), "{}", stderr(&output));
        assert_eq!(stdout(&output), "");
    }
    for size in ["1", "2", "3"] {
        let picture = png(&model, &fresh, &format!("--force --size {size}"));
        assert_eq!(picture.width().to_string(), size);
    }
}
