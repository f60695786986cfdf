//! Fit files opened in the real window.

use crate::common::folder::Folder;
use crate::common::records::{self, combined, only_named, write_fits, write_merl};
use crate::common::window::{Window, send};
use grazing::app::msg::Msg;
use grazing::app::state::State;
use grazing::app::state::notice::{Notice, Severity};
use grazing::brdf::COMBINED;
use grazing::brdf::{Brdf, Fresnel};
use grazing::files;
use grazing::files::fits::{FitRecord, SourceFile};
use std::ops::ControlFlow;
use std::path::Path;

fn window(files: &[&Path]) -> Window {
    let files = files.iter().map(|file| file.to_path_buf()).collect();
    crate::common::window::window(files, Vec::new())
}

/// Steps until nothing is loaded any more.
fn settle(window: &mut Window) {
    crate::common::window::settle(window, |state| state.jobs.is_empty());
}

fn open(window: &mut Window, file: &Path) {
    send(window, Msg::OpenFiles(vec![file.to_path_buf()]));
    settle(window);
}

/// A fit of this material with this E; s tells one from another.
fn record(name: &str, source: Option<SourceFile>, s: f64, error: f64) -> FitRecord {
    let brdf = Brdf {
        fresnel: Fresnel::Schlick,
        ..combined(s, COMBINED.default_lobe()[1])
    };
    records::record(name, source, brdf, error)
}

/// What the command line writes about this file.
fn source_of(path: &Path) -> SourceFile {
    let read = files::open_measured(path, &mut |_| ControlFlow::Continue(()));
    read.expect("is good").1
}

/// Names, s and whether anything was measured, of all open materials.
fn shown(state: &State) -> Vec<(&str, f64, bool)> {
    let opened = state.scene.opened.iter();
    let row = opened.map(|opened| {
        let material = &state.materials[&opened.id];
        let measured = material.table.valid_count() > 0;
        (material.name.as_str(), opened.brdf.params.lobe[0], measured)
    });
    row.collect()
}

#[track_caller]
fn said<'a>(state: &'a State, level: Severity, words: &str, path: &Path) -> &'a Notice {
    let [notice] = &state.notices[..] else {
        panic!("{:?}", state.notices)
    };
    assert_eq!(notice.level, level, "{}", notice.text);
    assert!(notice.text.contains(words), "{}", notice.text);
    assert!(
        notice.text.ends_with(&format!(": {}", path.display())),
        "{}",
        notice.text
    );
    assert_eq!(notice.text.lines().count(), 1);
    notice
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_best_fit_of_each_material_lies_over_its_measured_file() {
    let folder = Folder::new();
    let [gold, moved, fits] =
        ["gold.binary", "moved.binary", "fits.json"].map(|name| folder.path(name));
    write_merl(&gold);
    std::fs::copy(&gold, &moved).expect("is copied");
    let source = source_of(&gold);
    // Another name and no bytes known: it is found beside the fit file under the name it had elsewhere.
    let elsewhere = only_named("/somewhere/else/moved.binary");
    write_fits(
        &fits,
        &[
            record("gold", Some(source.clone()), 11.0, 0.3),
            record("gold", Some(source), 12.0, 0.1),
            record("moved", Some(elsewhere), 13.0, 0.2),
        ],
    );
    let window = window(&[&fits]);
    let state = window.state().state();
    assert_eq!(shown(state), [("gold", 12.0, true), ("moved", 13.0, true)]);
    assert_eq!(state.notices, []);
    assert_eq!(state.prefs.recent, [fits]);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn an_open_material_takes_the_model_as_one_step() {
    let folder = Folder::new();
    let [gold, copy, fits] =
        ["gold.binary", "copy of gold.binary", "fits.json"].map(|name| folder.path(name));
    write_merl(&gold);
    let source = source_of(&gold);
    write_fits(&fits, &[record("gold", Some(source.clone()), 77.0, 0.1)]);
    let mut window = window(&[&gold]);
    let before = window.state().state().scene.opened[0].brdf;
    open(&mut window, &fits);
    let state = window.state().state();
    assert_eq!(shown(state), [("gold", 77.0, true)]);
    assert_eq!(state.notices, []);
    window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    window.run_steps(3);
    let state = window.state().state();
    assert_eq!(state.scene.opened[0].brdf, before);
    assert!(!state.history.can_undo());

    // The same bytes under another name.
    std::fs::rename(&gold, &copy).expect("is moved");
    let mut window = self::window(&[&copy]);
    open(&mut window, &fits);
    assert_eq!(
        shown(window.state().state()),
        [("copy of gold", 77.0, true)]
    );

    // Other bytes and no file any more: the name is left, and the data have changed.
    let other = SourceFile {
        path: "/gone/copy of gold.binary.old".into(),
        sha256: Some("00".repeat(32)),
        bytes: None,
    };
    write_fits(&fits, &[record("copy of gold", Some(other), 5.0, 0.1)]);
    open(&mut window, &fits);
    let state = window.state().state();
    assert_eq!(shown(state), [("copy of gold", 5.0, true)]);
    said(
        state,
        Severity::Info,
        "copy of gold have changed since the fit",
        &copy,
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn two_materials_of_the_same_bytes_are_both_opened() {
    let folder = Folder::new();
    let [gold, brass, fits] =
        ["gold.binary", "brass.binary", "fits.json"].map(|name| folder.path(name));
    write_merl(&gold);
    write_merl(&brass);
    let fit = |path: &Path, name, s| record(name, Some(source_of(path)), s, 0.1);
    write_fits(
        &fits,
        &[fit(&gold, "gold", 77.0), fit(&brass, "brass", 78.0)],
    );
    let both = [("gold", 77.0, true), ("brass", 78.0, true)];
    let window = window(&[&fits]);
    assert_eq!(shown(window.state().state()), both);
    // Also where one of them is open before.
    let mut window = self::window(&[&gold]);
    open(&mut window, &fits);
    let state = window.state().state();
    assert_eq!(shown(state), both);
    assert_eq!(state.notices, []);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_measured_file_that_is_missing_or_changed_is_named() {
    let folder = Folder::new();
    let [gold, fits] = ["gold.binary", "fits.json"].map(|name| folder.path(name));
    let gone = SourceFile {
        path: gold.clone(),
        bytes: Some(1),
        sha256: Some("00".repeat(32)),
    };
    write_fits(&fits, &[record("gold", Some(gone), 9.0, 0.1)]);
    let window = window(&[&fits]);
    let state = window.state().state();
    assert_eq!(shown(state), [("gold", 9.0, false)]);
    said(
        state,
        Severity::Info,
        "the measured file of gold is missing",
        &gold,
    );

    write_merl(&gold);
    let window = self::window(&[&fits]);
    let state = window.state().state();
    assert_eq!(shown(state), [("gold", 9.0, true)]);
    said(
        state,
        Severity::Info,
        "gold have changed since the fit",
        &gold,
    );

    // What is there now is no measured file: that is said, and the model is shown.
    std::fs::write(&gold, "cut off").expect("is written");
    let window = self::window(&[&fits]);
    let state = window.state().state();
    assert_eq!(shown(state), [("gold", 9.0, false)]);
    said(state, Severity::Error, "not a MERL file", &gold);

    // A fit file that names itself as its data ends too.
    let circular = only_named(&fits);
    write_fits(&fits, &[record("gold", Some(circular), 9.0, 0.1)]);
    let window = self::window(&[&fits]);
    let state = window.state().state();
    assert_eq!(shown(state), [("gold", 9.0, false)]);
    said(state, Severity::Error, "not a MERL file", &fits);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn plain_models_open_alone_and_bad_json_is_one_line() {
    let folder = Folder::new();
    let file = |name: &str, text: &str| folder.file(name, text);
    let model =
        |s: f64| format!(r#"{{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": {s}}}"#);
    let one = file("my model.json", &model(3.0));
    let mut window = window(&[&one]);
    let state = window.state().state();
    assert_eq!(shown(state), [("my model", 3.0, false)]);
    assert!(!state.history.can_undo(), "the start is no step");
    said(state, Severity::Info, "my model has no measured file", &one);

    let id = window.state().state().notices[0].id;
    send(&mut window, Msg::Dismiss(id));
    let two = file("two.json", &format!("[{}, {}]", model(4.0), model(5.0)));
    open(&mut window, &two);
    let state = window.state().state();
    let expected = [
        ("my model", 3.0, false),
        ("two 0", 4.0, false),
        ("two 1", 5.0, false),
    ];
    assert_eq!(shown(state), expected);
    let id = said(
        state,
        Severity::Info,
        "2 models have no measured file",
        &two,
    )
    .id;
    send(&mut window, Msg::Dismiss(id));

    for (text, words) in [
        ("[{\"model\": \"pho", "not valid JSON"),
        (
            "[{\"model\": \"phong\"}]",
            "entry 0: \"rho_d\" (diffuse reflectance) is missing",
        ),
        ("[]", "the array of models is empty"),
    ] {
        let bad = file("bad.json", text);
        open(&mut window, &bad);
        let state = window.state().state();
        assert_eq!(shown(state), expected);
        let id = said(state, Severity::Error, words, &bad).id;
        send(&mut window, Msg::Dismiss(id));
    }
}
