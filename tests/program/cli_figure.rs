//! `grazing figure` as an author meets it: files that other programs read, the same bytes again, one line for what is
//! wrong.
#![cfg(target_os = "linux")]

use crate::common::folder::Folder;
use crate::common::program::{failed, grazing, stderr, succeeded};
use grazing::export::preset::PRESETS;
use resvg::usvg;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A sample as a file, and a fit file that says all three models of it: nothing is fitted.
fn material(folder: &Folder) -> (PathBuf, PathBuf) {
    let data = folder.path("lacquer.binary");
    succeeded(&grazing(&[&"sample", &"green-lacquer", &"-o", &data]));
    let model = |model: &str, alpha: &str, s: f64| {
        format!(
            r#"{{"model": "{model}", "fresnel": "exact", "material": "lacquer",
                "source": {{"path": "lacquer.binary"}}, "error": 0.1,
                "rho_d": [0.02, 0.1, 0.05], "k_s": [30, 31, 32], "s": {s}, "alpha": {alpha}, "eta": 1.5}}"#
        )
    };
    let fits = [
        model("phong", "null", 60.0),
        model("blinn-phong", "null", 250.0),
        model("combined", "0.4", 80.0),
    ];
    let fits = folder.file("fits.json", format!("[{}]", fits.join(",")));
    (data, fits)
}

fn figure(input: &Path, output: &Path, options: &str) -> Output {
    let mut args: Vec<&dyn AsRef<std::ffi::OsStr>> = vec![&"figure", &input, &"-o", &output];
    let options: Vec<&str> = options.split_whitespace().collect();
    for option in &options {
        args.push(option);
    }
    grazing(&args)
}

fn run(program: &str, args: &[&str], path: &Path) -> String {
    let output = Command::new(program).args(args).arg(path).output();
    let output =
        output.unwrap_or_else(|error| panic!("{program}: {error}; apt install poppler-utils"));
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// The text that `pdftotext` finds in a PDF.
fn text_of(pdf: &Path, layout: &str) -> String {
    let txt = pdf.with_extension("txt");
    let said = Command::new("pdftotext")
        .arg(layout)
        .args([pdf, &txt])
        .output();
    assert!(said.expect("poppler-utils").status.success());
    fs::read_to_string(txt).expect("text")
}

#[test]
fn every_preset_is_a_pdf_that_other_programs_read() {
    let folder = Folder::new();
    let (_, fits) = material(&folder);
    let cases = [
        (
            "poster",
            vec![
                "lacquer",
                "Measured",
                "Blinn-Phong",
                "30°",
                "sr−1",
                "luminance",
            ],
        ),
        ("sphere", vec!["measured", "model"]),
        ("lobes", vec!["lacquer", "Combined", "ωi", "cube root"]),
        ("slices", vec!["θo [°]", "model / measured", "log10"]),
        ("image-slice", vec!["θh", "θd", "90°", "model − measured"]),
        ("disc", vec!["θi = 60°", "θo = 30°", "model / measured"]),
        ("albedo", vec!["albedo", "θi", "measured share"]),
        ("lobe3d", vec!["fr [sr−1]", "θi = 60°"]),
        ("error-map", vec!["E =", "θo"]),
        ("landscape", vec!["α (0 Phong, 1 Blinn-Phong)", "η = 1.5"]),
        ("scatter", vec!["lacquer", "Blinn-Phong", "α over s"]),
        (
            "ranking",
            vec!["lacquer", "Combined: ", "materials by E of Phong"],
        ),
    ];
    assert_eq!(cases.len(), PRESETS.len());
    for (preset, words) in cases {
        let pdf = folder.path(format!("{preset}.pdf"));
        let said = figure(&fits, &pdf, &format!("--preset {preset} --dpi 60"));
        succeeded(&said);
        let fonts = Command::new("pdffonts")
            .arg(&pdf)
            .output()
            .expect("poppler-utils");
        let fonts = String::from_utf8_lossy(&fonts.stdout).into_owned();
        assert!(fonts.contains("LiberationSans"), "{preset}: {fonts}");
        let embedded = fonts
            .lines()
            .skip(2)
            .all(|line| line.contains(" yes yes yes "));
        assert!(embedded, "{preset}: {fonts}");
        let text = text_of(&pdf, "-layout");
        // Scripts are lines of their own there.
        let plain = text_of(&pdf, "-raw").replace(['\n', ' '], "");
        for word in words {
            let found = plain.contains(&word.replace(' ', "")) || text.contains(word);
            assert!(found, "{preset} lacks {word}: {text}");
        }
        let png = run("pdftoppm", &["-r", "40", "-png"], &pdf);
        assert!(png.len() > 500, "{preset}");
        assert!(folder.path(format!("{preset}.figure.json")).is_file());
    }
}

#[test]
fn the_scatter_is_of_the_model_that_is_asked_for() {
    let folder = Folder::new();
    let (_, fits) = material(&folder);
    let columns = |options: &str| {
        let csv = folder.path("scatter.csv");
        succeeded(&figure(
            &fits,
            &csv,
            &format!("--preset scatter --force {options}"),
        ));
        let text = fs::read_to_string(csv).expect("a table");
        assert_eq!(text.lines().count(), 2, "{text}");
        text.lines().next().expect("a head").to_owned()
    };
    assert_eq!(columns(""), "panel,material,s,alpha");
    assert_eq!(columns("--model phong"), "panel,material,s,eta");
    // Without a Fresnel factor η says nothing.
    let plain = columns("--model phong --fresnel none");
    assert_eq!(plain, "panel,material,s,k_s");
    assert_eq!(columns("--model lafortune"), "panel,material,s,c_z");
}

#[test]
fn a_figure_is_drawn_again_byte_by_byte_from_its_spec() {
    let folder = Folder::new();
    let (_, fits) = material(&folder);
    for format in ["pdf", "svg", "png", "csv"] {
        let first = folder.path(format!("lobes.{format}"));
        succeeded(&figure(
            &fits,
            &first,
            "--preset lobes --theta-i 20,55.5 --force",
        ));
        let spec = folder.path("lobes.figure.json");
        let text = fs::read_to_string(&spec).expect("a spec");
        let again = folder.path(format!("again.{format}"));
        succeeded(&figure(&spec, &again, "--force"));
        assert!(fs::read(&first).expect("a figure") == fs::read(&again).expect("a figure"));
        let value: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(
            value["rows"][0]["panels"][0]["view"]["lobes"]["theta_i"][1],
            55.5
        );
        assert_eq!(
            value["subjects"][0]["source"]["measured"]["file"]["bytes"],
            34_992_012
        );
        // Planted: another option is another figure.
        let other = folder.path(format!("other.{format}"));
        let options = if format == "csv" {
            "--preset slices"
        } else {
            "--font 7"
        };
        let source = if format == "csv" { &fits } else { &spec };
        succeeded(&figure(source, &other, &format!("{options} --force")));
        assert!(fs::read(&first).expect("a figure") != fs::read(&other).expect("a figure"));
    }
}

#[test]
fn several_models_are_in_one_figure_where_that_makes_sense() {
    let folder = Folder::new();
    let (_, fits) = material(&folder);
    let svg = folder.path("lobes.svg");
    let two = "--preset lobes --model combined,phong --force";
    succeeded(&figure(&fits, &svg, two));
    let spec = fs::read_to_string(folder.path("lobes.figure.json")).expect("a spec");
    let spec: Value = serde_json::from_str(&spec).expect("JSON");
    let subjects = spec["subjects"].as_array().expect("subjects");
    let labels: Vec<&str> = subjects
        .iter()
        .filter_map(|s| s["label"].as_str())
        .collect();
    assert_eq!(labels, ["lacquer", "Phong", "Combined"]);
    assert_ne!(subjects[1]["series"], subjects[2]["series"]);
    // Below slices each has a residual, whatever its line.
    let models = "phong,blinn-phong,combined,ggx";
    let fits_of_four = {
        let text = fs::read_to_string(&fits).expect("fits");
        let mut fits: Vec<Value> = serde_json::from_str(&text).expect("JSON");
        fits.push(serde_json::json!({
            "model": "ggx", "fresnel": "exact", "material": "lacquer",
            "source": {"path": "lacquer.binary"}, "error": 0.1,
            "rho_d": [0.02, 0.1, 0.05], "k_s": [1, 1, 1], "roughness": 0.2, "eta": 1.5
        }));
        folder.file("four.json", Value::from(fits).to_string())
    };
    let csv = folder.path("slices.csv");
    let options = format!("--preset slices --model {models}");
    succeeded(&figure(&fits_of_four, &csv, &options));
    let csv = fs::read_to_string(csv).expect("a CSV");
    for name in ["Phong", "Blinn-Phong", "Combined", "GGX"] {
        let row = format!(",model / measured,luminance,{name},");
        assert!(csv.contains(&row), "{name}");
    }
    for (options, said) in [
        ("--preset lobes --model=", "there is no model \"\""),
        ("--preset lobes --model ,", "there is no model \"\""),
        (
            "--preset sphere --model phong-family",
            "--model names 3 models; the preset sphere shows one",
        ),
        (
            "--preset scatter --model all",
            "the preset scatter shows one: name one of them",
        ),
        (
            "--preset landscape --model phong",
            "the preset landscape shows the combined model only",
        ),
        ("--preset lobes --model fong", "there is no model \"fong\""),
    ] {
        let result = figure(&fits, &folder.path("refused.svg"), options);
        assert_eq!(result.status.code(), Some(2), "{}", stderr(&result));
        assert!(stderr(&result).contains(said), "{}", stderr(&result));
        assert!(!folder.path("refused.svg").exists());
    }
}

#[test]
fn a_ranking_takes_its_errors_from_a_fit_file_and_fits_what_is_missing() {
    let folder = Folder::new();
    let data = folder.path("lacquer.binary");
    succeeded(&grazing(&[&"sample", &"green-lacquer", &"-o", &data]));
    let fits = folder.path("fits.json");
    let staged = [&"--stages" as &dyn AsRef<std::ffi::OsStr>, &"1"];
    let combined: [&dyn AsRef<std::ffi::OsStr>; 4] = [&"fit", &data, &"-o", &fits];
    succeeded(&grazing(&[&combined[..], &staged[..]].concat()));
    let csv = folder.path("ranking.csv");
    let ranked = |options: &str| {
        let options = format!("--preset ranking --force {options}");
        succeeded(&figure(&fits, &csv, &options));
        let text = fs::read_to_string(&csv).expect("a table");
        let rows = text.lines().skip(1).map(|line| {
            let fields = line.split(',').map(str::to_owned);
            fields.collect::<Vec<String>>()
        });
        rows.collect::<Vec<_>>()
    };
    let rows = ranked("");
    let models: Vec<&str> = rows.iter().map(|row| row[3].as_str()).collect();
    assert_eq!(models, ["phong", "blinn-phong", "combined"]);
    let percent = |row: &[String]| row[5].parse::<f64>().expect("a number");
    // The file has the combined model: its E is taken as it stands there.
    let text = fs::read_to_string(&fits).expect("fits");
    let mut value: Value = serde_json::from_str(&text).expect("JSON");
    let record = match &mut value {
        Value::Array(all) => &mut all[0],
        one => one,
    };
    assert!((percent(&rows[2]) - 100.0 * record["error"].as_f64().expect("E")).abs() < 1e-9);
    record["error"] = Value::from(0.125);
    fs::write(&fits, value.to_string()).expect("written");
    let rows = ranked("--model combined");
    assert!((percent(&rows[0]) - 12.5).abs() < 1e-9, "{rows:?}");
    // Without the measured file it is drawn all the same, as long as nothing has to be fitted.
    fs::remove_file(data).expect("removed");
    assert_eq!(ranked("--model combined"), rows);
    let refused = figure(&fits, &csv, "--preset ranking --model ward --force");
    assert!(!refused.status.success());
    let said = stderr(&refused);
    assert!(
        said.contains("the measured file of lacquer is missing"),
        "{said}"
    );
}

/// The corners of the paths of an SVG with a stroke of a colour, longest first, in points.
fn curves(svg: &str, color: [u8; 3]) -> Vec<Vec<[f32; 2]>> {
    fn walk(group: &usvg::Group, color: [u8; 3], out: &mut Vec<Vec<[f32; 2]>>) {
        for node in group.children() {
            match node {
                usvg::Node::Group(group) => walk(group, color, out),
                usvg::Node::Path(path) => {
                    let stroke = path.stroke().map(|stroke| stroke.paint());
                    let [r, g, b] = color;
                    if stroke == Some(&usvg::Paint::Color(usvg::Color::new_rgb(r, g, b))) {
                        let points = path.data().points();
                        out.push(points.iter().map(|p| [p.x, p.y]).collect());
                    }
                }
                _ => {}
            }
        }
    }
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).expect("an SVG");
    let mut out = Vec::new();
    walk(tree.root(), color, &mut out);
    out.sort_by_key(|points| std::cmp::Reverse(points.len()));
    out
}

#[test]
fn curves_in_the_svg_are_what_eval_says() {
    let folder = Folder::new();
    let model = r#"{"model": "combined", "fresnel": "none", "rho_d": [0.5, 0.5, 0.5],
                    "k_s": [2, 2, 2], "s": 25, "alpha": 0.3}"#;
    let source = folder.file("model.json", model);
    let axis = r#"{"theta_i": [40], "scale": "linear", "limits": [0, 4], "window": [-60, 60]}"#;
    let spec = format!(
        r#"{{"subjects": [{{"label": "m", "source": {{"model": {model}}}}}],
            "rows": [{{"panels": [{{"subjects": [0], "view": {{"slices": {axis}}}}}]}}]}}"#
    );
    let spec = folder.file("slice.figure.json", spec);
    let svg = folder.path("slice.svg");
    succeeded(&figure(&spec, &svg, ""));
    let svg = fs::read_to_string(&svg).expect("an SVG");
    // The first series' blue. Solid or dashed, the curve is one path; the legend's piece of line is short.
    let curve = &curves(&svg, [0x00, 0x68, 0xb0])[0];
    assert!(curve.len() > 30, "{} corners", curve.len());
    // The frame of the plot: where −60° and 60°, 0 and 4 are, from the ends of the curve and two of its values.
    let eval = |theta_o: f64| -> f64 {
        let phi_o = if theta_o < 0.0 { 180 } else { 0 };
        let rows = format!(
            "theta_i,phi_i,theta_o,phi_o\n40,180,{},{phi_o}\n",
            theta_o.abs()
        );
        let directions = folder.file("d.csv", rows);
        let said = succeeded(&grazing(&[&"eval", &source, &"--directions", &directions]));
        let last = said.lines().last().expect("a row");
        last.rsplit(',')
            .next()
            .expect("a value")
            .parse()
            .expect("a number")
    };
    let (first, last) = (curve[0], curve[curve.len() - 1]);
    let angle = |x: f32| -60.0 + 120.0 * f64::from(x - first[0]) / f64::from(last[0] - first[0]);
    let top = curve
        .iter()
        .min_by(|a, b| a[1].total_cmp(&b[1]))
        .expect("corners");
    assert!((angle(top[0]) - 40.0).abs() < 0.2);
    let (low, high) = (eval(-60.0), eval(angle(top[0])));
    let per_point = (high - low) / f64::from(first[1] - top[1]);
    let value = |y: f32| low + per_point * f64::from(first[1] - y);
    let mut worst = 0.0_f64;
    for [x, y] in curve.iter().step_by(curve.len() / 25) {
        worst = worst.max((value(*y) - eval(angle(*x))).abs() / 4.0);
    }
    assert!(worst < 1e-4, "{worst} of the axis");
    // Planted: a curve that is 1 % off.
    let [x, y] = curve[curve.len() / 2];
    assert!((1.01 * value(y) - eval(angle(x))).abs() / 4.0 > 1e-4);
}

#[test]
fn a_source_that_is_missing_or_changed_is_named() {
    let folder = Folder::new();
    let (data, fits) = material(&folder);
    let out = folder.path("lobes.svg");
    succeeded(&figure(&fits, &out, "--preset lobes"));
    let spec = folder.path("lobes.figure.json");
    let again = folder.path("again.svg");
    let mut bytes = fs::read(&data).expect("the data");
    bytes[20_000_000] ^= 1;
    fs::write(&data, &bytes).expect("is written");
    failed(
        &figure(&spec, &again, ""),
        &data,
        "not the one that the figure was drawn from",
    );
    assert!(!again.exists());
    succeeded(&figure(&spec, &again, "--changed"));
    fs::remove_file(&data).expect("is removed");
    failed(&figure(&spec, &again, "--force"), &data, "is missing");
    // Moved along with the figure it is found.
    let moved = Folder::new();
    bytes[20_000_000] ^= 1;
    moved.file("lacquer.binary", &bytes);
    let spec = moved.file("lobes.figure.json", fs::read(&spec).expect("a spec"));
    let there = moved.path("there.svg");
    succeeded(&figure(&spec, &there, ""));
    assert_eq!(
        fs::read(&there).expect("a figure"),
        fs::read(&out).expect("a figure")
    );
}

#[test]
fn what_is_there_is_not_replaced_unasked() {
    let folder = Folder::new();
    let (_, fits) = material(&folder);
    let out = folder.file("lobes.svg", "mine");
    failed(
        &figure(&fits, &out, "--preset lobes"),
        &out,
        "exists already; --force replaces it",
    );
    assert_eq!(fs::read(&out).expect("is there"), b"mine");
    fs::remove_file(&out).expect("is removed");
    let spec = folder.file("lobes.figure.json", "mine too");
    failed(
        &figure(&fits, &out, "--preset lobes"),
        &spec,
        "exists already",
    );
    assert!(!out.exists());
    succeeded(&figure(&fits, &out, "--preset lobes --force"));
    let nowhere = folder.path("no/lobes.svg");
    failed(
        &figure(&fits, &nowhere, "--preset lobes"),
        &nowhere,
        "no directory",
    );
}

#[test]
fn a_figure_is_written_in_several_formats_or_in_none() {
    let folder = Folder::new();
    let (_, fits) = material(&folder);
    let [svg, pdf, csv] = ["svg", "pdf", "csv"].map(|end| folder.path(format!("lobes.{end}")));
    let both = |first: &Path, second: &Path, preset: &str| {
        grazing(&[
            &"figure",
            &"--preset",
            &preset,
            &fits,
            &"-o",
            &first,
            &"-o",
            &second,
        ])
    };
    succeeded(&both(&svg, &pdf, "lobes"));
    let spec = folder.path("lobes.figure.json");
    let drawn = fs::read(&spec).expect("a spec");
    // The same figure once more in another format: its spec is the one that is there.
    succeeded(&figure(&fits, &csv, "--preset lobes"));
    assert_eq!(fs::read(&spec).expect("a spec"), drawn);
    let lone = folder.path("again.pdf");
    succeeded(&figure(&fits, &lone, "--preset lobes"));
    assert!(fs::read(&lone).expect("a PDF") == fs::read(&pdf).expect("a PDF"));
    // Planted: another figure under this name.
    let png = folder.path("lobes.png");
    let other = figure(&fits, &png, "--preset lobes --theta-i 10");
    failed(&other, &spec, "exists already");
    assert!(!png.exists() && fs::read(&spec).expect("a spec") == drawn);
    // One of two cannot be written: by its place, by its spec, by what is on it.
    let fresh = folder.path("fresh.svg");
    failed(&both(&fresh, &pdf, "lobes"), &pdf, "exists already");
    failed(&both(&fresh, &png, "slices"), &spec, "exists already");
    let exr = both(&fresh, &folder.path("fresh.exr"), "lobes");
    assert!(stderr(&exr).contains("EXR holds one sphere"), "{exr:?}");
    assert!(!fresh.exists() && !folder.path("fresh.figure.json").exists());
    let twice = both(&fresh, &fresh, "lobes");
    assert_eq!(twice.status.code(), Some(2));
    assert!(stderr(&twice).contains("given twice"), "{twice:?}");
}

#[test]
fn materials_of_the_same_bytes_or_the_same_name_are_all_drawn() {
    let folder = Folder::new();
    let (data, fits) = material(&folder);
    for name in ["old", "new"] {
        fs::create_dir(folder.path(name)).expect("a folder");
    }
    let copies = ["old/lacquer.binary", "new/lacquer.binary", "copy.binary"];
    for copy in copies {
        fs::hard_link(&data, folder.path(copy)).expect("a second name");
    }
    // Another name of the same file.
    std::os::unix::fs::symlink("copy.binary", folder.path("link.binary")).expect("a link");
    let sha256 = succeeded(
        &Command::new("sha256sum")
            .arg(&data)
            .output()
            .expect("sha256sum"),
    );
    let sha256 = sha256.split_whitespace().next().expect("a sum");
    let one = fs::read_to_string(&fits).expect("fits");
    let all: Vec<Value> = copies
        .iter()
        .chain(&["link.binary"])
        .flat_map(|copy| {
            let mut fits: Vec<Value> = serde_json::from_str(&one).expect("JSON");
            for fit in &mut fits {
                fit["source"] = serde_json::json!({"path": copy, "sha256": sha256});
            }
            fits
        })
        .collect();
    let fits = folder.file("all.json", Value::from(all).to_string());
    let out = folder.path("all.svg");
    succeeded(&figure(&fits, &out, "--preset lobes"));
    let spec = fs::read_to_string(folder.path("all.figure.json")).expect("a spec");
    let spec: Value = serde_json::from_str(&spec).expect("JSON");
    let headings: Vec<&Value> = spec["rows"]
        .as_array()
        .expect("rows")
        .iter()
        .map(|row| &row["panels"][0]["heading"])
        .collect();
    assert_eq!(headings, ["old/lacquer", "new/lacquer", "copy", "link"]);
    let labels = spec["subjects"].as_array().expect("subjects");
    let labels: Vec<&str> = labels.iter().filter_map(|s| s["label"].as_str()).collect();
    for name in ["old/lacquer", "new/lacquer, Combined", "copy, Combined"] {
        assert!(labels.contains(&name), "{labels:?}");
    }
}

#[test]
fn wrong_options_and_files_have_one_line_each() {
    let folder = Folder::new();
    let (data, fits) = material(&folder);
    let out = folder.path("f.svg");
    let usage = |input: &Path, output: &Path, options: &str, said: &str| {
        let result = figure(input, output, options);
        assert_eq!(result.status.code(), Some(2), "{}", stderr(&result));
        assert!(stderr(&result).contains(said), "{}", stderr(&result));
    };
    usage(
        &fits,
        &folder.path("f.gif"),
        "--preset lobes",
        "expected one of .svg, .pdf",
    );
    usage(&fits, &out, "--preset picture", "possible values: poster");
    usage(
        &fits,
        &out,
        "--preset lobes --theta-i 95",
        "expected 0 to less than 90 degrees",
    );
    // Before anything is fitted: there is no such measured file.
    let unread = folder.path("none.binary");
    for (options, said) in [
        ("--width 5", "expected a number from 20 to 2000"),
        ("--font 0", "expected a number from 3 to 72"),
        ("--line -1", "expected a number from 0.05 to 20"),
        ("--dpi 1e9", "expected a number from 30 to 2400"),
        ("--dpi NaN", "expected a number from 30 to 2400"),
    ] {
        usage(&unread, &out, &format!("--preset lobes {options}"), said);
    }
    let png = folder.path("f.png");
    let said = "a PNG of 94488 pixels in a row; expected at most 20000";
    usage(
        &unread,
        &png,
        "--preset lobes --width 1000 --dpi 2400",
        said,
    );
    usage(&fits, &fits, "--preset lobes", "expected one of .svg");
    usage(&fits, &out, "--theta-i 20", "--preset");
    let fails = |code: i32, input: &Path, options: &str, said: &str| {
        let result = figure(input, &out, options);
        let line = stderr(&result);
        assert_eq!(result.status.code(), Some(code), "{line}");
        assert!(line.contains(said) && line.lines().count() == 1, "{line}");
        assert!(!out.exists());
    };
    fails(1, &data, "", "not valid JSON");
    fails(2, &fits, "", "this is no figure");
    fails(1, &folder.path("none.json"), "", "no such file");
    let spec = |text: &str| folder.file("bad.figure.json", text);
    let lobes = r#"{"panels": [{"subjects": [], "view": {"lobes": {"theta": [3]}}}]}"#;
    let text = format!(r#"{{"subjects": [], "rows": [{lobes}]}}"#);
    fails(2, &spec(&text), "", "unknown field `theta`");
    fails(2, &spec(&text), "", "; did you mean `theta_i`?");
    let survey = r#"{"panels": [{"subjects": [], "view": {"landscape": {}}}]}"#;
    let text = format!(r#"{{"subjects": [], "rows": [{survey}]}}"#);
    fails(1, &spec(&text), "", "needs a measured material");
}
