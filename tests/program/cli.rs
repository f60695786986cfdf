//! The command line as a person meets it: what is printed, and one clear line for every bad input.

use crate::common::folder::Folder;
use crate::common::program::{failed, grazing, stderr, stdout, succeeded};
use std::fs;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// A MERL file made by hand: every stored number of a plane is the same.
fn merl(bins: [i32; 3], planes: [f64; 3]) -> Vec<u8> {
    let mut bytes: Vec<u8> = bins.iter().flat_map(|n| n.to_le_bytes()).collect();
    let cells = bins.iter().map(|n| *n as usize).product();
    for stored in planes {
        bytes.extend(std::iter::repeat_n(stored.to_le_bytes(), cells).flatten());
    }
    bytes
}

const FOLDED: [i32; 3] = [90, 90, 180];
const ROWS: &str = "theta_i,phi_i,theta_o,phi_o\n30,0,40,170\n";

#[test]
fn every_bad_file_has_its_line() {
    let folder = Folder::new();
    let good = merl(FOLDED, [1.0; 3]);
    let header = |bins: [i32; 3]| {
        bins.iter()
            .flat_map(|n| n.to_le_bytes())
            .collect::<Vec<_>>()
    };
    let mut long = good.clone();
    long.push(0);
    let png = [b"\x89PNG\r\n\x1a\n".as_slice(), &[0; 100]].concat();
    let cases: [(&str, Vec<u8>, &str); 13] = [
        ("empty", vec![], "empty"),
        (
            "header",
            header(FOLDED),
            "it has 12 bytes, expected 34,992,012",
        ),
        (
            "cut",
            good[..34_992_011].to_vec(),
            "it has 34,992,011 bytes, expected 34,992,012",
        ),
        ("long", long, "it has 34,992,013 bytes, expected 34,992,012"),
        ("dims", merl([90, 45, 180], [1.0; 3]), "90 × 45 × 180"),
        ("swapped", merl([180, 90, 90], [1.0; 3]), "180 × 90 × 90"),
        ("overflow", header([i32::MAX; 3]), "2147483647 × 2147483647"),
        ("wraps", header([65536, 65536, 1]), "65536 × 65536 × 1 "),
        ("negative", header([-90, -90, 180]), "-90 × -90 × 180"),
        (
            "invalid",
            merl(FOLDED, [1.0, -1.0, 1.0]),
            "all 1,458,000 cells are invalid",
        ),
        (
            "nan",
            merl(FOLDED, [1.0, f64::NAN, f64::INFINITY]),
            "all 1,458,000 cells are invalid",
        ),
        ("png", png, "PNG"),
        ("text", ROWS.into(), "text"),
    ];
    let rows = folder.file("rows.csv", ROWS);
    for (name, bytes, said) in cases {
        let path = folder.file(format!("{name}.binary"), bytes);
        failed(&grazing(&[&"info", &path]), &path, said);
        failed(
            &grazing(&[&"eval", &path, &"--directions", &rows]),
            &path,
            said,
        );
    }
    let missing = folder.path("missing.binary");
    failed(&grazing(&[&"info", &missing]), &missing, "no such file");
    let directory = folder.path("");
    failed(&grazing(&[&"info", &directory]), &directory, "directory");
    let inside = rows.join("x.binary");
    failed(&grazing(&[&"info", &inside]), &inside, "no directory");
}

#[test]
#[cfg(unix)]
fn a_file_without_permission_has_its_line() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = Folder::new();
    let path = folder.file("secret.binary", merl(FOLDED, [1.0; 3]));
    fs::set_permissions(&path, fs::Permissions::from_mode(0o000)).expect("is set");
    if fs::File::open(&path).is_ok() {
        eprintln!("skipped: this user may read everything");
        return;
    }
    failed(&grazing(&[&"info", &path]), &path, "no permission");
}

#[test]
fn a_name_with_a_line_break_stays_on_one_line() {
    let folder = Folder::new();
    let output = grazing(&[&"info", &folder.path("a\nb.binary")]);
    assert_eq!(stderr(&output).lines().count(), 1);
    assert!(stderr(&output).ends_with("a\\nb.binary\n"));
}

#[test]
fn a_session_is_named_where_models_or_data_are_wanted() {
    let folder = Folder::new();
    let path = folder.file(
        "a.grazing.json",
        r#"{"grazing_session": 1, "materials": []}"#,
    );
    let directions = folder.file("d.csv", "theta_i,phi_i,theta_o,phi_o\n0,0,0,0\n");
    failed(&grazing(&[&"info", &path]), &path, "this is a session");
    let eval = grazing(&[&"eval", &path, &"--directions", &directions]);
    failed(&eval, &path, "this is a session");
}

#[test]
fn info_counts_and_measures() {
    let folder = Folder::new();
    let mut bytes = merl(FOLDED, [1500.0; 3]);
    // Red of the first three cells: 2, invalid, not finite.
    for (cell, stored) in [3000.0, -1.0, f64::INFINITY].into_iter().enumerate() {
        bytes[12 + 8 * cell..20 + 8 * cell].copy_from_slice(&f64::to_le_bytes(stored));
    }
    let path = folder.file("half brass.binary", bytes);
    let text = succeeded(&grazing(&[&"info", &path]));
    assert!(
        text.contains("half brass\n") && text.contains("1457998"),
        "{text}"
    );
    let json = succeeded(&grazing(&[&"info", &path, &"--json"]));
    let value: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(value["name"], "half brass");
    assert_eq!(value["phi_d_bins"], 180);
    assert_eq!(value["cells"], 1_458_000);
    assert_eq!(value["valid_cells"], 1_457_998);
    for (channel, median) in [("red", 1.0), ("green", 1.15), ("blue", 1.66)] {
        let found = value["f_r"][channel]["median"].as_f64().expect("a number");
        assert!((found - median).abs() < 1e-6, "{channel}: {found}");
    }
    assert_eq!(value["f_r"]["red"]["max"], 2.0);
    assert_eq!(value["f_r"]["red"]["min"], 1.0);
}

#[test]
fn files_with_the_whole_turn_are_read() {
    let folder = Folder::new();
    let path = folder.file("full.binary", merl([90, 90, 360], [1.0; 3]));
    let text = succeeded(&grazing(&[&"info", &path]));
    assert!(text.contains("360") && text.contains("2916000"), "{text}");
}

#[test]
fn samples_are_listed_written_and_not_overwritten() {
    let folder = Folder::new();
    let list = succeeded(&grazing(&[&"sample", &"--list", &"--json"]));
    let list: serde_json::Value = serde_json::from_str(&list).expect("JSON");
    let list = list.as_array().expect("an array");
    assert!(list.len() >= 3);
    for row in list {
        assert!(
            row["name"]
                .as_str()
                .is_some_and(|name| name.contains("(synthetic)"))
        );
    }
    let key = list[0]["key"].as_str().expect("a key");
    let listed = succeeded(&grazing(&[&"sample", &"--list"]));
    assert!(listed.contains(key));

    let path = folder.path("sample.binary");
    succeeded(&grazing(&[&"sample", &key, &"-o", &path]));
    assert_eq!(fs::metadata(&path).expect("is there").len(), 34_992_012);
    succeeded(&grazing(&[&"info", &path]));
    failed(
        &grazing(&[&"sample", &key, &"-o", &path]),
        &path,
        "exists already",
    );
    succeeded(&grazing(&[&"sample", &key, &"-o", &path, &"--force"]));
    let nowhere = folder.path("no/sample.binary");
    failed(
        &grazing(&[&"sample", &key, &"-o", &nowhere]),
        &nowhere,
        "no directory",
    );

    let unknown = grazing(&[&"sample", &"violet-flet", &"-o", &path]);
    assert!(stderr(&unknown).ends_with("; did you mean `violet-felt`?\n"));
    let unknown = grazing(&[&"sample", &"chrome", &"-o", &path]);
    assert_eq!(unknown.status.code(), Some(1));
    assert!(stderr(&unknown).contains("expected one of"));
}

#[test]
fn eval_adds_columns_and_leaves_gaps() {
    let folder = Folder::new();
    let mut bytes = merl(FOLDED, [1500.0, 3000.0, 150.0]);
    // wi = wo = n is in the first cell of the first rows, whatever φ_d is: make all of them invalid.
    for phi in 0..180 {
        bytes[12 + 8 * phi..20 + 8 * phi].copy_from_slice(&f64::to_le_bytes(-1.0));
    }
    let source = folder.file("flat.binary", bytes);
    let rows = "id,theta_o,phi_o,theta_i,phi_i\n\
                a,40,170,30,0\n\"b, c\",0,0,0,0\nd,95,0,10,0\n";
    let rows = folder.file("rows.csv", rows);
    for lookup in ["nearest", "smooth"] {
        let text = succeeded(&grazing(&[
            &"eval",
            &source,
            &"--directions",
            &rows,
            &"--lookup",
            &lookup,
        ]));
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[0], "id,theta_o,phi_o,theta_i,phi_i,r,g,b");
        let numbers: Vec<f64> = lines[1]
            .strip_prefix("a,40,170,30,0,")
            .expect("the row as it was")
            .split(',')
            .map(|number| number.parse().expect("a number"))
            .collect();
        for (found, expected) in numbers.iter().zip([1.0, 2.3, 0.166]) {
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
        assert_eq!(lines[2], "\"b, c\",0,0,0,0,,,");
        assert_eq!(lines[3], "d,95,0,10,0,,,");
        assert_eq!(lines.len(), 4);
    }
    let json = succeeded(&grazing(&[
        &"eval",
        &source,
        &"--directions",
        &rows,
        &"--json",
    ]));
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json[0]["theta_o"], 40.0);
    assert_eq!(json[0]["r"], 1.0);
    assert_eq!(json[1]["id"], "b, c");
    assert!(json[1]["g"].is_null() && json[2]["b"].is_null());
    let output = folder.path("out.csv");
    let to_file = |force: &str| {
        let mut args: Vec<&dyn AsRef<std::ffi::OsStr>> =
            vec![&"eval", &source, &"--directions", &rows, &"-o", &output];
        if !force.is_empty() {
            args.push(&"--force");
        }
        grazing(&args)
    };
    assert_eq!(succeeded(&to_file("")), "");
    let written = fs::read_to_string(&output).expect("is written");
    assert_eq!(written.lines().count(), 4);
    failed(&to_file(""), &output, "exists already");
    succeeded(&to_file("--force"));
}

#[test]
fn eval_knows_models_and_their_place_in_an_array() {
    let folder = Folder::new();
    let model = |rho_d: f64| {
        format!(
            r#"{{"model": "phong", "fresnel": "none", "rho_d": [{rho_d}, 0, 0], "k_s": [1, 2, 4], "s": 3}}"#
        )
    };
    let one = folder.file("one.json", format!("\n  {}", model(0.0)));
    let many = folder.file(
        "many.json",
        format!("[{}, {}]", model(0.0), model(std::f64::consts::PI)),
    );
    // The mirror direction, where the lobe is 1; 60° from it, where it is 1/8; below the horizon.
    let rows = folder.file(
        "rows.csv",
        "theta_i,phi_i,theta_o,phi_o\n40,0,40,180\n0,0,60,33\n0,0,91,0\n",
    );
    let eval = |source: &PathBuf, index: &str| -> Vec<Vec<f64>> {
        let output = grazing(&[&"eval", source, &"--directions", &rows, &"--index", &index]);
        let text = succeeded(&output);
        assert!(text.ends_with("0,0,91,0,,,\n"), "{text}");
        text.lines()
            .skip(1)
            .take(2)
            .map(|line| {
                line.split(',')
                    .skip(4)
                    .map(|x| x.parse().expect("a number"))
                    .collect()
            })
            .collect()
    };
    let near = |found: &[f64], expected: [f64; 3]| {
        assert_eq!(found.len(), 3);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    };
    for (values, diffuse) in [
        (eval(&one, "0"), 0.0),
        (eval(&many, "0"), 0.0),
        (eval(&many, "1"), 1.0),
    ] {
        near(&values[0], [1.0 + diffuse, 2.0, 4.0]);
        near(&values[1], [0.125 + diffuse, 0.25, 0.5]);
    }
    let run = |source: &PathBuf, index: &str| {
        grazing(&[&"eval", source, &"--directions", &rows, &"--index", &index])
    };
    failed(&run(&many, "2"), &many, "no entry 2");
    failed(&run(&one, "1"), &one, "no entry 1");
    let broken = folder.file("broken.json", "{\"model\": \"pho");
    failed(&run(&broken, "0"), &broken, "not valid JSON");
    let unknown = folder.file("unknown.json", r#"{"model": "wa\nrd"}"#);
    failed(&run(&unknown, "0"), &unknown, "unknown model");
}

#[test]
fn a_bad_row_is_named_and_nothing_is_printed() {
    let folder = Folder::new();
    let model = r#"{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": 3}"#;
    let source = folder.file("model.json", model);
    for (text, said) in [
        (
            "theta_i,phi_i,theta_o,phi_o\n1,2,3,4\n1,2,abc,4\n",
            "line 3, column theta_o: \"abc\"",
        ),
        (
            "theta_i,phi_i,theta_o,phi_o\n1,2,3\n",
            "line 2: the row has 3 columns",
        ),
        ("theta_i,phi_i,theta_o\n1,2,3\n", "no column phi_o"),
        ("", "empty"),
    ] {
        let rows = folder.file("rows.csv", text);
        failed(
            &grazing(&[&"eval", &source, &"--directions", &rows]),
            &rows,
            said,
        );
    }
    let bytes = folder.file("bytes.csv", [0xff, 0xfe, 0x00]);
    failed(
        &grazing(&[&"eval", &source, &"--directions", &bytes]),
        &bytes,
        "UTF-8",
    );
    let missing = folder.path("missing.csv");
    failed(
        &grazing(&[&"eval", &source, &"--directions", &missing]),
        &missing,
        "no such file",
    );
}

#[test]
fn directions_come_from_standard_input_and_a_closed_pipe_is_quiet() {
    let folder = Folder::new();
    let model = r#"{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": 3}"#;
    let source = folder.file("model.json", model);
    let start = || {
        let mut child = Command::new(env!("CARGO_BIN_EXE_grazing"))
            .arg("eval")
            .arg(&source)
            .args(["--directions", "-"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let input = child.stdin.take().expect("a pipe");
        (child, input)
    };
    let (child, mut input) = start();
    input.write_all(ROWS.as_bytes()).expect("is taken");
    drop(input);
    let output = child.wait_with_output().expect("ends");
    assert_eq!(succeeded(&output).lines().count(), 2);

    let (mut child, mut input) = start();
    drop(child.stdout.take());
    let mut many = String::from("theta_i,phi_i,theta_o,phi_o\n");
    many.push_str(&"30,0,40,170\n".repeat(20_000));
    input.write_all(many.as_bytes()).expect("is taken");
    drop(input);
    let output = child.wait_with_output().expect("ends");
    assert_eq!(stderr(&output), "");
}

#[test]
fn a_wrong_command_line_is_exit_code_2() {
    for args in [
        &["eval", "x.binary"][..],
        &["eval", "x", "--directions", "y", "--lookup", "cubic"],
        &["sample"],
        &["sample", "copper-glaze"],
        &["info"],
        &["info", "x", "--frob"],
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
            .args(args)
            .output()
            .expect("the program starts");
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert_eq!(stdout(&output), "");
    }
    let version = succeeded(&grazing(&[&"--version"]));
    assert_eq!(version, format!("grazing {}\n", env!("CARGO_PKG_VERSION")));
}
