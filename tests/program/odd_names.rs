//! Measured files whose names are not UTF-8, on the command line: fit files, their CSV, figures and their specs.
//!
//! Linux takes any bytes as a name; other systems refuse these.
#![cfg(target_os = "linux")]

use crate::common::folder::Folder;
use crate::common::program::{failed, grazing, stderr, succeeded};
use grazing::files::fits;
use serde_json::{Value, json};
use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};

const NAME: &[u8] = b"gr\xe9\xe9n 5%.binary";

fn sample(folder: &Folder) -> PathBuf {
    let data = folder.path(OsStr::from_bytes(NAME));
    succeeded(&grazing(&[&"sample", &"green-lacquer", &"-o", &data]));
    data
}

/// The path in files, as `docs/formats.md` has it.
fn in_files(folder: &Folder) -> Value {
    let folder = folder.root().to_str().expect("UTF-8");
    json!({"bytes": format!("{folder}/gr%E9%E9n 5%25.binary")})
}

#[test]
fn a_fit_file_and_its_csv_lead_to_the_measured_file() {
    let folder = Folder::new();
    let data = sample(&folder);
    let [fits, csv] = ["fits.json", "fits.csv"].map(|name| folder.path(name));
    let quick = ["--model", "phong", "--fresnel", "none", "--stages", "1"];
    let mut args: Vec<&dyn AsRef<OsStr>> = vec![&"fit", &data, &"-o", &fits, &"--csv", &csv];
    args.extend(quick.iter().map(|arg| arg as &dyn AsRef<OsStr>));
    let output = grazing(&args);
    assert!(output.status.success(), "{}", stderr(&output));

    let text = fs::read_to_string(&fits).expect("a fit file");
    let value: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(value[0]["source"]["path"], in_files(&folder));
    let read = fits::by_material(&fits, fits::entries(&text).expect("fits"));
    assert_eq!(read[0].found.as_ref(), Some(&data));

    let mut csv = csv::Reader::from_path(&csv).expect("a CSV");
    let column = csv
        .headers()
        .expect("names")
        .iter()
        .position(|name| name == "path");
    let row = csv.records().next().expect("a row").expect("text");
    let cell: Value = serde_json::from_str(&row[column.expect("a path")]).expect("JSON");
    assert_eq!(cell, in_files(&folder));
}

#[test]
fn a_figure_is_drawn_again_from_its_spec_there_and_moved() {
    let folder = Folder::new();
    let data = sample(&folder);
    let fits = format!(
        r#"[{{"model": "combined", "fresnel": "exact", "material": "lacquer", "source": {{"path": {}}}, "error": 0.1,
              "rho_d": [0.02, 0.1, 0.05], "k_s": [30, 31, 32], "s": 80, "alpha": 0.4, "eta": 1.5}}]"#,
        in_files(&folder)
    );
    let fits = folder.file("fits.json", fits);
    let figure = |input: &Path, output: &Path, preset: bool| {
        let mut args: Vec<&dyn AsRef<OsStr>> = vec![&"figure", &input, &"-o", &output, &"--force"];
        if preset {
            args.extend([&"--preset" as &dyn AsRef<OsStr>, &"lobes"]);
        }
        grazing(&args)
    };
    let first = folder.path("lobes.svg");
    succeeded(&figure(&fits, &first, true));
    let spec = folder.path("lobes.figure.json");
    let text = fs::read_to_string(&spec).expect("a spec");
    let value: Value = serde_json::from_str(&text).expect("JSON");
    let file = &value["subjects"][0]["source"]["measured"]["file"];
    assert_eq!(file["path"], in_files(&folder));
    let bytes = fs::read(&first).expect("a figure");
    let again = folder.path("again.svg");
    succeeded(&figure(&spec, &again, false));
    assert!(fs::read(&again).expect("a figure") == bytes);

    // Moved along with the figure it is found; without it, it is named in one line.
    let moved = Folder::new();
    let spec = moved.file("lobes.figure.json", text);
    let there = moved.path(OsStr::from_bytes(NAME));
    fs::rename(&data, &there).expect("moved");
    let again = moved.path("again.svg");
    succeeded(&figure(&spec, &again, false));
    assert!(fs::read(&again).expect("a figure") == bytes);
    fs::remove_file(&there).expect("removed");
    // What is said is text: the path in it is as it looks.
    let output = figure(&spec, &again, false);
    let line = stderr(&output);
    assert!(
        line.contains("is missing") && line.contains('\u{fffd}'),
        "{line}"
    );
    failed(&output, &data, "is missing");
}
