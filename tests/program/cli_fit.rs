//! `grazing fit` as a person meets it: what the files hold, and one clear line for everything that is wrong.

use crate::common::folder::Folder;
use crate::common::merl::merl_file;
use crate::common::program::{failed, grazing, stderr, stdout, succeeded};
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, COMBINED, Fresnel, MODELS, PHONG_FAMILY, Params};
use grazing::geom::direction;
use serde_json::Value;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

/// A small made-up material: the combined model as data, unmeasured below the horizon.
fn material(folder: &Folder, name: &str, s: f64) -> PathBuf {
    let brdf = Brdf {
        model: &COMBINED,
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.3, 0.2, 0.1],
            k_s: [20.0, 25.0, 30.0],
            lobe: lobe_values([s, 0.5]),
            eta: 1.5,
        },
    };
    folder.file(name, merl_file(|c| Some(brdf.eval(c))))
}

fn fit(files: &[&Path], options: &str) -> Output {
    let mut args: Vec<&dyn AsRef<OsStr>> = vec![&"fit"];
    for file in files {
        args.push(file);
    }
    let options: Vec<&str> = options.split_whitespace().collect();
    for option in &options {
        args.push(option);
    }
    grazing(&args)
}

fn json(text: &str) -> Vec<Value> {
    serde_json::from_str(text).expect("an array")
}

fn keys(value: &Value) -> Vec<&str> {
    let object = value.as_object().expect("an object");
    object.keys().map(String::as_str).collect()
}

fn sorted<const N: usize>(mut keys: [&str; N]) -> Vec<&str> {
    keys.sort_unstable();
    keys.to_vec()
}

/// Three finite numbers.
fn is_color(value: &Value) -> bool {
    value
        .as_array()
        .is_some_and(|items| items.len() == 3 && items.iter().all(Value::is_f64))
}

const PARAMETERS: [&str; 5] = ["rho_d", "k_s", "s", "alpha", "eta"];

/// Every key with its type. `has` says whether the model has α and η.
#[track_caller]
fn check_fit(fit: &Value, has: [bool; 2]) {
    let all = [
        "material",
        "source",
        "program",
        "version",
        "options",
        "model",
        "fresnel",
        "rho_d",
        "k_s",
        "s",
        "alpha",
        "eta",
        "error",
        "error_grazing",
        "error_channels",
        "stages",
        "albedo",
        "albedo_above_one",
        "evaluations",
        "ended_because",
        "concerns",
    ];
    assert_eq!(keys(fit), sorted(all));
    let number_where = |value: &Value, there: bool| {
        assert!(
            if there {
                value.is_f64()
            } else {
                value.is_null()
            },
            "{value}"
        );
    };
    let parameters = |of: &Value| {
        assert!(is_color(&of["rho_d"]) && is_color(&of["k_s"]), "{of}");
        number_where(&of["s"], true);
        number_where(&of["alpha"], has[0]);
        number_where(&of["eta"], has[1]);
    };
    parameters(fit);
    for key in ["material", "program", "version", "ended_because"] {
        assert!(fit[key].is_string(), "{key}");
    }
    assert_eq!(fit["program"], "grazing");
    assert_eq!(fit["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(keys(&fit["source"]), sorted(["path", "bytes", "sha256"]));
    assert_eq!(fit["source"]["bytes"], 34_992_012);
    let sha256 = fit["source"]["sha256"].as_str().expect("a text");
    assert!(sha256.len() == 64 && sha256.chars().all(|c| c.is_ascii_hexdigit()));
    let options = &fit["options"];
    let all = ["weight", "limit", "stages", "start", "held", "bounds"];
    assert_eq!(keys(options), sorted(all));
    for key in ["start", "held", "bounds"] {
        assert_eq!(keys(&options[key]), sorted(PARAMETERS));
    }
    for (key, has) in PARAMETERS.iter().zip([true, true, true, has[0], has[1]]) {
        let bounds = &options["bounds"][key];
        let pair = bounds.as_array().map(Vec::len) == Some(2);
        assert_eq!((pair, bounds.is_null()), (has, !has), "{key}: {bounds}");
    }
    assert!(fit["error"].is_f64() && fit["error_grazing"].is_f64());
    assert!(is_color(&fit["error_channels"]));
    for stage in fit["stages"].as_array().expect("an array") {
        let all = ["stage", "start_error", "error", "evaluations", "parameters"];
        assert_eq!(keys(stage), sorted(all));
        assert!(stage["stage"].is_u64() && stage["evaluations"].is_u64());
        assert!(stage["start_error"].is_f64() && stage["error"].is_f64());
        assert_eq!(keys(&stage["parameters"]), sorted(PARAMETERS));
        parameters(&stage["parameters"]);
    }
    assert_eq!(keys(&fit["albedo"]), sorted(["0", "45", "80"]));
    assert!(
        ["0", "45", "80"]
            .iter()
            .all(|angle| is_color(&fit["albedo"][*angle]))
    );
    assert!(fit["albedo_above_one"].is_boolean() && fit["evaluations"].is_u64());
    assert!(
        fit["concerns"]
            .as_array()
            .is_some_and(|all| all.iter().all(Value::is_string))
    );
}

#[test]
fn good_files_are_fitted_and_a_bad_one_between_them_is_named() {
    let folder = Folder::new();
    let first = material(&folder, "first one.binary", 12.0);
    let second = material(&folder, "second.binary", 80.0);
    let bad = folder.file("bad.binary", "no table");
    let (out, table) = (folder.path("fits.json"), folder.path("fits.csv"));
    let output = grazing(&[
        &"fit",
        &first,
        &bad,
        &second,
        &"--model",
        &"phong-family",
        &"--stages",
        &"1",
        &"-o",
        &out,
        &"--csv",
        &table,
        &"--threads",
        &"2",
    ]);
    // Standard error is no terminal: no bar, one line for the bad file.
    failed(&output, &bad, "not a MERL file");
    let fits = json(&fs::read_to_string(&out).expect("is written"));
    let variants: Vec<_> = fits
        .iter()
        .map(|fit| ["material", "model", "fresnel"].map(|key| fit[key].as_str().unwrap_or("?")))
        .collect();
    let expected: Vec<_> = ["first one", "second"]
        .into_iter()
        .flat_map(|name| {
            PHONG_FAMILY
                .iter()
                .map(move |model| [name, model.key, "exact"])
        })
        .collect();
    assert_eq!(variants, expected);
    for fit in &fits {
        check_fit(fit, [fit["model"] == "combined", true]);
        assert_eq!(fit["options"]["stages"], serde_json::json!([1]));
        assert_eq!(fit["options"]["weight"], "cosine");
        assert_eq!(fit["options"]["limit"], 90.0);
        assert_eq!(fit["stages"].as_array().map(Vec::len), Some(1));
    }
    let path = |fit: &Value| PathBuf::from(fit["source"]["path"].as_str().unwrap_or("?"));
    assert_eq!((path(&fits[0]), path(&fits[3])), (first, second));
    assert_ne!(fits[0]["source"]["sha256"], fits[3]["source"]["sha256"]);
    csv_agrees(&fits, &fs::read_to_string(&table).expect("is written"));
    listed_and_evaluated(&folder, &out, &fits);
}

/// Every number of the CSV is the one of the JSON.
fn csv_agrees(fits: &[Value], text: &str) {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let rows: Vec<_> = reader.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), fits.len());
    let colors = [
        "rho_d",
        "k_s",
        "albedo_0",
        "albedo_45",
        "albedo_80",
        "error",
    ];
    for (row, fit) in rows.iter().zip(fits) {
        let column = |name: &str| {
            let at = header.iter().position(|title| title == name);
            &row[at.unwrap_or_else(|| panic!("no column {name}"))]
        };
        let agrees = |name: &str, value: &Value| match value.as_f64() {
            Some(number) => assert_eq!(column(name).parse(), Ok(number), "{name}"),
            None => assert_eq!(column(name), value.as_str().unwrap_or(""), "{name}"),
        };
        for key in [
            "material",
            "model",
            "fresnel",
            "error",
            "error_grazing",
            "s",
            "alpha",
            "eta",
            "evaluations",
            "ended_because",
        ] {
            agrees(key, &fit[key]);
        }
        for color in colors {
            let values = match color.split_once('_') {
                _ if color == "error" => &fit["error_channels"],
                Some(("albedo", angle)) => &fit["albedo"][angle],
                _ => &fit[color],
            };
            for (channel, name) in ["r", "g", "b"].iter().enumerate() {
                agrees(&format!("{color}_{name}"), &values[channel]);
            }
        }
        agrees("path", &fit["source"]["path"]);
        agrees("sha256", &fit["source"]["sha256"]);
        agrees("weight", &fit["options"]["weight"]);
        agrees("limit", &fit["options"]["limit"]);
        assert_eq!(column("stages"), "1");
    }
}

#[test]
fn the_table_of_info_aligns_and_tells_materials_apart() {
    let folder = Folder::new();
    let long = "x".repeat(3000);
    let fit = |material: &str, path: &str, s: f64, error: f64| {
        serde_json::json!({
            "material": material, "source": {"path": path}, "model": "phong", "fresnel": "none",
            "rho_d": [0, 0, 0], "k_s": [1, 1, 1], "s": s, "error": error,
        })
    };
    let fits = [
        fit("steel", "/data/old/steel.binary", 7.5, 0.25),
        fit("steel", "/data/new/steel.binary", 120.0, 1.5),
        fit(&long, "/data/x.binary", 1.0, 0.125),
    ];
    let path = folder.file("fits.json", serde_json::json!(fits).to_string());
    let text = succeeded(&grazing(&[&"info", &path]));
    let lines: Vec<&str> = text.lines().collect();
    assert!(
        lines[1].contains("old/steel ") && lines[2].contains("new/steel "),
        "{text}"
    );
    assert!(
        lines.iter().all(|line| line.chars().count() < 100),
        "{text}"
    );
    // E and s at their points, and each under its head.
    let point = |line: &str, k: usize| {
        let before = line.chars().enumerate().filter(|(_, c)| *c == '.');
        before.map(|(at, _)| at).nth(k)
    };
    for k in 0..2 {
        let at: Vec<_> = lines[1..].iter().map(|line| point(line, k)).collect();
        assert!(at[0].is_some() && at.iter().all(|x| *x == at[0]), "{text}");
    }
    let head = |word: &str| lines[0].find(word).expect("a head");
    assert!(head("index") < head("material") && head("material") < head("model"));
    assert!(lines[1].contains("phong  none"), "{text}");
}

/// `info` lists the fits with the index under which `eval` takes them; `eval` gives the model's own numbers.
fn listed_and_evaluated(folder: &Folder, path: &Path, fits: &[Value]) {
    let text = succeeded(&grazing(&[&"info", &path]));
    assert_eq!(text.lines().count(), 1 + fits.len());
    let last = text.lines().last().expect("a line");
    for word in ["5", "second", "combined", "exact"] {
        assert!(last.split_whitespace().any(|found| found == word), "{last}");
    }
    let listed = json(&succeeded(&grazing(&[&"info", &path, &"--json"])));
    for (index, (row, fit)) in listed.iter().zip(fits).enumerate() {
        assert_eq!(row["index"], index);
        for key in ["material", "model", "fresnel", "error"] {
            assert_eq!(row[key], fit[key], "{key}");
        }
    }
    let angles = [[30.0, 0.0, 40.0, 170.0_f64], [80.0, 10.0, 79.0, 191.0]];
    let mut rows = String::from("theta_i,phi_i,theta_o,phi_o\n");
    for [a, b, c, d] in angles {
        rows.push_str(&format!("{a},{b},{c},{d}\n"));
    }
    let rows = folder.file("rows.csv", rows);
    for (index, fit) in fits.iter().enumerate() {
        let brdf = grazing::brdf::json::from_value(fit).expect("a model");
        let index = index.to_string();
        let text = succeeded(&grazing(&[
            &"eval",
            &path,
            &"--directions",
            &rows,
            &"--index",
            &index,
        ]));
        for (line, angles) in text.lines().skip(1).zip(angles) {
            let [theta_i, phi_i, theta_o, phi_o] = angles.map(f64::to_radians);
            let f_r = brdf.f_r(direction(theta_i, phi_i), direction(theta_o, phi_o));
            let numbers = line
                .split(',')
                .skip(4)
                .map(|x| x.parse().expect("a number"));
            assert_eq!(
                numbers.collect::<Vec<f64>>(),
                f_r.expect("above the horizon")
            );
        }
    }
}

#[test]
fn options_are_kept_and_a_model_without_a_parameter_does_without() {
    let folder = Folder::new();
    let file = material(&folder, "a.binary", 12.0);
    let output = fit(
        &[&file],
        "--model phong-family --fresnel none --weight solid-angle --limit 80.5 --stages 2,1 \
         --start alpha=0.25,s=33.3 --hold k_s=1:2:3,rho_d=0.1 --threads 1",
    );
    let fits = json(&succeeded(&output));
    assert_eq!(fits.len(), 3);
    for fit in &fits {
        let combined = fit["model"] == "combined";
        check_fit(fit, [combined, false]);
        let options = &fit["options"];
        assert_eq!(options["weight"], "solid-angle");
        assert_eq!(options["limit"], 80.5);
        assert_eq!(options["stages"], serde_json::json!([1, 2]));
        assert_eq!(options["start"]["s"], 33.3);
        let alpha = if combined {
            Value::from(0.25)
        } else {
            Value::Null
        };
        assert_eq!(options["start"]["alpha"], alpha);
        assert!(options["start"]["eta"].is_null() && options["held"]["s"].is_null());
        assert_eq!(options["held"]["k_s"], serde_json::json!([1.0, 2.0, 3.0]));
        assert_eq!(options["held"]["rho_d"], serde_json::json!([0.1, 0.1, 0.1]));
    }
}

#[test]
fn what_is_held_comes_back() {
    let folder = Folder::new();
    let file = material(&folder, "a.binary", 12.0);
    let output = fit(
        &[&file],
        "--hold s=7,eta=1.25,rho_d=0.3:0.2:0.1 --stages 1,2,3",
    );
    let fits = json(&succeeded(&output));
    assert_eq!(fits[0]["s"], 7.0);
    assert_eq!(fits[0]["eta"], 1.25);
    assert_eq!(fits[0]["rho_d"], serde_json::json!([0.3, 0.2, 0.1]));
    let error = fits[0]["error"].as_f64().expect("a number");
    // With what it was made of it is nearly exact; s = 7 is not that.
    assert!(error > 0.001 && error < 1.0, "{error}");
    let truth = "--hold s=12,alpha=0.5,eta=1.5 --stages 1";
    let fits = json(&succeeded(&fit(&[&file], truth)));
    assert!(fits[0]["error"].as_f64().is_some_and(|error| error < 1e-5));
}

#[test]
fn the_same_bytes_whatever_the_number_of_threads() {
    let folder = Folder::new();
    let file = material(&folder, "a.binary", 12.0);
    let with = |threads: &str| {
        let options = format!("--model phong --stages 1,2 --threads {threads}");
        succeeded(&fit(&[&file], &options))
    };
    let one = with("1");
    assert_eq!(one, with("2"));
    // A planted difference of the data is seen.
    material(&folder, "a.binary", 13.0);
    assert_ne!(one, with("1"));
}

#[test]
fn output_that_cannot_be_written_is_refused_before_fitting() {
    let folder = Folder::new();
    // Fitting would fail: what is said first is checked first.
    let missing = folder.path("missing.binary");
    let there = folder.file("there.json", "kept");
    let nowhere = folder.path("no/fits.csv");
    let run = |option: &str, path: &PathBuf| grazing(&[&"fit", &missing, &option, path]);
    failed(&run("-o", &there), &there, "exists already; --force");
    failed(&run("--csv", &there), &there, "exists already; --force");
    failed(&run("--csv", &nowhere), &nowhere, "no directory");
    failed(&run("-o", &folder.path("")), &folder.path(""), "directory");
    assert_eq!(fs::read_to_string(&there).expect("is there"), "kept");
    // All files fail: nothing is written, what was there stays.
    let forced = grazing(&[&"fit", &missing, &"-o", &there, &"--force"]);
    failed(&forced, &missing, "no such file");
    let fresh = folder.path("fresh.json");
    failed(&run("-o", &fresh), &missing, "no such file");
    failed(&grazing(&[&"fit", &missing]), &missing, "no such file");
    assert!(!fresh.exists());
    assert_eq!(fs::read_to_string(&there).expect("is there"), "kept");
    // A fit file is no measured one.
    let model = folder.file("model.json", r#"{"model": "phong"}"#);
    failed(&grazing(&[&"fit", &model]), &model, "not a MERL file");
}

#[test]
fn what_is_overwritten_by_force_is_whole() {
    let folder = Folder::new();
    let file = material(&folder, "a.binary", 12.0);
    let out = folder.file("fits.json", "old");
    let output = grazing(&[
        &"fit",
        &file,
        &"--model",
        &"phong",
        &"--stages",
        &"1",
        &"-o",
        &out,
        &"--force",
    ]);
    assert_eq!(succeeded(&output), "");
    let text = fs::read_to_string(&out).expect("is written");
    assert_eq!(json(&text).len(), 1);
    assert!(text.starts_with("[\n  {") && text.ends_with("}\n]\n"));
}

#[test]
fn every_model_is_fitted_and_its_parameters_stand_under_their_keys() {
    let folder = Folder::new();
    let file = material(&folder, "a.binary", 12.0);
    let csv = folder.path("fits.csv");
    let fits = |models: &str| {
        json(&succeeded(&fit(
            &[&file],
            &format!("--model {models} --stages 1"),
        )))
    };
    let all = fits("all");
    assert_eq!(all.len(), MODELS.len());
    for (fit, model) in all.iter().zip(MODELS) {
        assert_eq!(fit["model"], model.key);
        for row in model.rows() {
            assert!(!fit[row.key()].is_null(), "{}: {}", model.key, row.key());
        }
        // Keys that every file has ever had, and no other model's.
        let keys = keys(fit);
        assert!(["s", "alpha", "eta"].iter().all(|key| keys.contains(key)));
        let of_ggx = keys.contains(&"roughness");
        assert_eq!(
            of_ggx,
            model.params[0].key() == "roughness",
            "{}",
            model.key
        );
    }
    // In the order of the list, each once, whatever the order asked.
    let two: Vec<_> = fits("ward,ggx,ward")
        .iter()
        .map(|fit| fit["model"].clone())
        .collect();
    assert_eq!(two, ["ggx", "ward"]);
    let output = grazing(&[
        &"fit",
        &file,
        &"--model",
        &"all",
        &"--stages",
        &"1",
        &"--csv",
        &csv,
    ]);
    assert_eq!(succeeded(&output), "");
    let text = fs::read_to_string(&csv).expect("is written");
    let columns: Vec<&str> = text.lines().next().expect("a header").split(',').collect();
    for key in ["s", "alpha", "c_z", "roughness", "b", "c", "eta"] {
        assert!(columns.contains(&key), "{key}: {columns:?}");
    }
    assert_eq!(text.lines().count(), 1 + MODELS.len());
}

#[test]
fn every_bad_option_has_its_line() {
    let folder = Folder::new();
    let file = folder.file("never read.binary", "");
    for (options, said) in [
        (
            "--limit 0",
            "out of range; expected more than 0 and at most 90 degrees",
        ),
        ("--limit 90.5", "out of range"),
        ("--limit -5", "out of range"),
        ("--limit inf", "out of range"),
        ("--limit nan", "not a number"),
        ("--limit flat", "not a number; expected degrees"),
        ("--stages 0", "\"0\" is no stage; expected some of 1,2,3,4"),
        ("--stages 1,5", "\"5\" is no stage"),
        ("--stages -1", "\"-1\" is no stage"),
        ("--stages 1,2,1", "stage 1 is given twice"),
        ("--stages 1,,2", "\"\" is no stage"),
        ("--stages=", "no stage is given"),
        (
            "--start shininess=3",
            "there is no parameter \"shininess\"; expected one of rho_d, k_s, s, alpha, c_z",
        ),
        ("--start s", "\"s\" has no value; expected KEY=VALUE"),
        ("--start s=wide", "s: \"wide\" is no number"),
        ("--start s=nan", "s: \"nan\" is no number"),
        (
            "--start s=0",
            "s = 0 is out of range; expected 0.000001 to 10000000",
        ),
        (
            "--start alpha=1.5",
            "alpha = 1.5 is out of range; expected 0 to 1",
        ),
        ("--start eta=0.9", "eta = 0.9 is out of range"),
        ("--start s=1,s=2", "s is given twice"),
        ("--start s=1:2:3", "s has 3 values; expected one number"),
        (
            "--hold rho_d=1:2",
            "rho_d has 2 values; expected one number or three: R:G:B",
        ),
        ("--hold k_s=-1", "k_s = -1 is out of range"),
        ("--hold k_s=1:x:3", "k_s: \"x\" is no number"),
        (
            "--start s=1 --hold s=2",
            "s is given in --start and in --hold",
        ),
        (
            "--model phong --start alpha=0.5",
            "--start: the chosen model has no alpha",
        ),
        (
            "--fresnel none --hold eta=1.5",
            "--hold: the chosen model has no eta",
        ),
        (
            "--model wart",
            "there is no model \"wart\"; expected one of phong, blinn-phong, combined, lafortune,",
        ),
        ("--model ggx,,ward", "there is no model \"\""),
        ("--model blin-phong", "; did you mean `blinn-phong`?"),
        (
            "--model ggx --hold alpha=0.5",
            "--hold: the chosen model has no alpha; it has rho_d, k_s, roughness, eta",
        ),
        (
            "--model ggx --start roughness=20",
            "roughness = 20 is out of range",
        ),
        (
            "--fresnel metal",
            "possible values: none, exact, schlick, all",
        ),
        (
            "--weight heavy",
            "possible values: cells, solid-angle, cosine",
        ),
        ("--start alhpa=0.5", "; did you mean `alpha`?"),
        ("--hold ks=1", "; did you mean `k_s`?"),
        ("--threads 0", "0 is not in 1..=1024"),
        ("--threads many", "invalid digit"),
        ("-o same --csv same", "-o and --csv name the same file"),
        ("-o same --csv ./same", "-o and --csv name the same file"),
    ] {
        let output = fit(&[&file], options);
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{options}: {text}");
        assert_eq!(stdout(&output), "", "{options}");
        let errors = text.lines().filter(|line| line.starts_with("error: "));
        assert_eq!(errors.count(), 1, "{options}: {text}");
        assert!(text.contains(said), "{options}: {text}");
    }
    let over = grazing(&[&"fit", &file, &"--force", &"-o", &file]);
    assert_eq!(over.status.code(), Some(2));
    assert!(stderr(&over).contains("would replace an input"));
    assert_eq!(grazing(&[&"fit"]).status.code(), Some(2));
}
