//! Files and arguments that are far too long, far too large or in another encoding: one short line, little memory.

use crate::common::folder::Folder;
use crate::common::program::{failed, grazing, stderr, stdout, succeeded};
use grazing::export::FigureSpec;
use serde_json::json;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Output};

/// Characters of a line that a person can take in; 120 of somebody's text, a path and the program's own words fit.
const LONGEST_LINE: usize = 500;

/// A model with all its keys and others.
fn model(others: &serde_json::Value) -> serde_json::Value {
    let mut model = json!({
        "model": "combined", "fresnel": "exact", "rho_d": [0.02, 0.1, 0.05], "k_s": [30, 31, 32],
        "s": 80, "alpha": 0.4, "eta": 1.5,
    });
    for (key, value) in others.as_object().expect("keys") {
        model[key] = value.clone();
    }
    model
}

#[track_caller]
fn short(text: &str) {
    for line in text.lines() {
        assert!(
            line.chars().count() <= LONGEST_LINE,
            "{} characters",
            line.len()
        );
        assert!(!line.contains(char::is_control), "{line:?}");
    }
}

/// An error in short lines, without an escape that steers the terminal.
#[track_caller]
fn refused(output: &Output, code: i32) -> String {
    let said = stderr(output);
    assert_eq!(output.status.code(), Some(code), "{said:.300}");
    assert_eq!(stdout(output), "");
    short(&said);
    said
}

#[test]
fn a_name_of_any_length_widens_nothing() {
    let folder = Folder::new();
    let name = format!("begin{}end", "N".repeat(70_000));
    let source = json!({"path": format!("/gone/{name}.binary"), "sha256": name});
    let entries = [
        model(&json!({"material": name, "error": 0.1})),
        model(&json!({"material": name, "error": 0.1, "source": source})),
    ];
    let models = folder.file("models.json", json!(entries).to_string());
    let info = succeeded(&grazing(&[&"info", &models]));
    assert!(info.contains("begin") && info.contains("end"), "{info}");
    short(&info);
    let directions = folder.file("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,0,30,180\n");
    short(&succeeded(&grazing(&[
        &"eval",
        &models,
        &"--directions",
        &directions,
    ])));
    for format in ["wgsl", "glsl", "disney"] {
        let text = succeeded(&grazing(&[&"export", &models, &"--format", &format]));
        short(&text.replace('\t', " "));
    }
    // A measured file cannot have such a name, but such a name can be asked for.
    for command in ["info", "fit"] {
        refused(&grazing(&[&command, &format!("{name}.binary")]), 1);
    }
    let figure = folder.path("a.svg");
    let line = refused(
        &grazing(&[&"figure", &"--preset", &"lobes", &models, &"-o", &figure]),
        1,
    );
    assert!(line.contains("begin") && line.contains('…'), "{line}");
}

#[test]
fn a_label_of_any_length_makes_no_large_figure() {
    let folder = Folder::new();
    let first = folder.path("first.svg");
    succeeded(&grazing(&[
        &"figure",
        &"--preset",
        &"slices",
        &"-o",
        &first,
    ]));
    let mut spec = FigureSpec::open(&folder.path("first.figure.json")).expect("a figure");
    for subject in &mut spec.subjects {
        subject.label = "N".repeat(70_000);
    }
    let spec = folder.file("long.figure.json", spec.to_json());
    for name in ["long.svg", "long.csv"] {
        let figure = folder.path(name);
        succeeded(&grazing(&[&"figure", &spec, &"-o", &figure, &"--force"]));
        let text = fs::read_to_string(&figure).expect("a figure");
        // The recipe has it whole.
        let drawn = text.rsplit("</metadata>").next().expect("a part");
        assert!(!drawn.contains(&"N".repeat(121)), "{name}");
    }
}

#[test]
fn what_is_quoted_is_short_and_in_one_line() {
    let folder = Folder::new();
    let long = "\u{1b}[31mlong\n".repeat(7000);
    let bad = [
        model(&json!({"model": long})),
        model(&json!({"fresnel": long})),
        model(&json!({"k_s": [long]})),
        model(&json!({"s": -1e300})),
        model(&json!({format!("Fresnel{}", "_".repeat(70_000)): 1})),
        json!({"subjects": [], "rows": [], long.as_str(): 1}),
        json!({"grazing_session": 1, "materials": []}),
    ];
    let directions = folder.file("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,0,30,180\n");
    for (k, model) in bad.iter().enumerate() {
        let file = folder.file(format!("{k}.json"), json!([model]).to_string());
        refused(&grazing(&[&"info", &file]), 1);
        refused(&grazing(&[&"eval", &file, &"--directions", &directions]), 1);
        let file = folder.file(format!("{k}.figure.json"), model.to_string());
        refused(
            &grazing(&[&"figure", &file, &"-o", &folder.path("a.svg")]),
            2,
        );
    }
    let source = folder.file("good.json", model(&json!({})).to_string());
    for text in [
        format!(
            "theta_i,phi_i,theta_o,phi_o\n1,2,3,\"{}",
            "x\n".repeat(100_000)
        ),
        format!(
            "theta_i,phi_i,theta_o,phi_o\n1,2,3,{}",
            "\u{1b}x".repeat(100_000)
        ),
        format!("theta_i,phi_i,theta_o,phi_o,{0},{0}\n", "x".repeat(100_000)),
        format!("theta_i,phi_i,theta_o,phi_o\n1,2,3,{}\n", "9".repeat(300)),
    ] {
        let file = folder.file("bad.csv", text);
        refused(&grazing(&[&"eval", &source, &"--directions", &file]), 1);
    }
}

#[test]
fn arguments_are_quoted_as_shortly() {
    let long = "\u{1b}[31mlong".repeat(7000);
    for args in [
        vec![format!("--{long}")],
        vec!["info".into(), "a".into(), long.clone()],
        vec!["info".into(), "a".into(), format!("--{long}")],
        vec!["fit".into(), "a".into(), format!("--model={long}")],
        vec!["fit".into(), "a".into(), format!("--threads={long}")],
        vec!["fit".into(), "a".into(), format!("--limit={long}")],
        vec!["fit".into(), "a".into(), format!("--stages={long}")],
        vec!["fit".into(), "a".into(), format!("--start={long}=1")],
        vec!["fit".into(), "a".into(), format!("--start=s={long}")],
        vec![
            "render".into(),
            "a".into(),
            "-o".into(),
            "a.png".into(),
            format!("--light={long}"),
        ],
        vec!["figure".into(), "a".into(), "-o".into(), long.clone()],
        vec![
            "figure".into(),
            "a".into(),
            "b".into(),
            "-o".into(),
            "a.svg".into(),
            "-o".into(),
            "a.svg".into(),
            format!("--font={long}"),
        ],
    ] {
        let args: Vec<&dyn AsRef<std::ffi::OsStr>> = args
            .iter()
            .map(|arg| arg as &dyn AsRef<std::ffi::OsStr>)
            .collect();
        refused(&grazing(&args), 2);
    }
    refused(&grazing(&[&"sample", &long, &"-o", &"a"]), 1);
}

#[test]
fn a_text_is_named_as_what_it_is() {
    let folder = Folder::new();
    let text = json!([model(&json!({}))]).to_string();
    let wide = |unit: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(unit).collect::<Vec<u8>>();
    let marked = [b"\xff\xfe".to_vec(), wide(u16::to_le_bytes)].concat();
    for (bytes, words) in [
        (marked, "UTF-16"),
        (wide(u16::to_be_bytes), "UTF-16"),
        (wide(u16::to_le_bytes), "UTF-16"),
        (
            format!("// a model\n{text}").into_bytes(),
            "begins with a comment",
        ),
        (
            b"model: phong".to_vec(),
            "begins with \"model: phong\"; expected {",
        ),
        (b" \n".repeat(10_000), "is empty; expected JSON"),
        (Vec::new(), "is empty; expected JSON"),
    ] {
        let file = folder.file("a.json", &bytes);
        let output = grazing(&[&"info", &file]);
        failed(&output, &file, words);
        assert!(!stderr(&output).contains("MERL"), "{}", stderr(&output));
        let file = folder.file("a.csv", &bytes);
        let source = folder.file("good.json", &text);
        refused(&grazing(&[&"eval", &source, &"--directions", &file]), 1);
    }
    // Blanks are none of its business, and neither is what a material is called.
    let file = folder.file("a.json", format!("{}{text}", " ".repeat(100_000)));
    succeeded(&grazing(&[&"info", &file]));
    let named = model(&json!({"material": "grazing_session", "about": {"subjects": "rows"}}));
    let file = folder.file("a.json", named.to_string());
    assert!(succeeded(&grazing(&[&"info", &file])).contains("grazing_session"));
    let directions = folder.file("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,0,30,180\n");
    succeeded(&grazing(&[&"eval", &file, &"--directions", &directions]));
}

/// The program where it may have no more than this many MiB of memory.
#[cfg(target_os = "linux")]
fn within(mib: usize, args: &[&Path]) -> Output {
    let mut shell = Command::new("sh");
    shell.args([
        "-c",
        &format!("ulimit -v {}; exec \"$0\" \"$@\"", mib * 1024),
    ]);
    shell.arg(env!("CARGO_BIN_EXE_grazing"));
    shell.args(args).output().expect("a shell")
}

#[cfg(target_os = "linux")]
#[test]
fn a_large_file_takes_no_more_memory_than_its_text() {
    const ROOM: usize = 256;
    let folder = Folder::new();
    let info = |file: &Path| within(ROOM, &["info".as_ref(), file]);
    let sparse = folder.file("sparse.json", "[");
    let file = File::options().write(true).open(&sparse);
    file.and_then(|file| file.set_len(4 << 30))
        .expect("a large file");
    failed(
        &info(&sparse),
        &sparse,
        "too large; JSON is read up to 64 MiB",
    );
    let much = "[],".repeat(8_000_000);
    let nested = folder.file("nested.json", format!("[{much}0]"));
    failed(&info(&nested), &nested, "entry 0: expected a JSON object");
    let inside = model(&json!({}))
        .to_string()
        .replacen("80", &format!("[{much}0]"), 1);
    let inside = folder.file("inside.json", format!("[{inside}]"));
    failed(
        &info(&inside),
        &inside,
        "entry 0: there are far more values",
    );
    // What is no part of a model may be as large as it likes.
    let other = model(&json!({"other": 0})).to_string().replacen(
        "\"other\":0",
        &format!("\"other\":[{much}0]"),
        1,
    );
    let other = folder.file("other.json", other);
    succeeded(&info(&other));

    let mut rows = String::from("theta_i,phi_i,theta_o,phi_o\n");
    rows.push_str(&"12.5,34.5,56.5,78.5\n".repeat(800_000));
    let rows = folder.file("rows.csv", rows);
    let source = folder.file("model.json", model(&json!({})).to_string());
    let values = folder.path("values.csv");
    let args = [
        "eval".as_ref(),
        &*source,
        "--directions".as_ref(),
        &*rows,
        "-o".as_ref(),
        &*values,
    ];
    succeeded(&within(ROOM, &args));
    let values = fs::read_to_string(&values).expect("values");
    assert_eq!(values.lines().count(), 800_001);
    assert!(
        values
            .lines()
            .skip(1)
            .all(|line| line == values.lines().nth(1).expect("a row"))
    );
}
