//! Figure specs as a hand may write them: what cannot be drawn is named and nothing is drawn; what was ever written is read.

use crate::common::folder::Folder;
use crate::common::program::{failed_with, grazing, stderr, succeeded};
use grazing::export::FigureSpec;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// A figure of a panel with a view, with a model and a sample as its subjects.
fn with_view(view: &str) -> String {
    format!(
        r#"{{"subjects": [
              {{"label": "a", "source": {{"sample": {{"key": "violet-felt", "lookup": "smooth"}}}}}},
              {{"label": "b", "source": {{"model": {{"model": "phong", "rho_d": [0.2, 0.2, 0.2],
                                                     "k_s": [1, 1, 1], "s": 9}}}}}}],
            "rows": [{{"panels": [{{"subjects": [0, 1], "view": {view}}}]}}],
            "style": {{"dpi": 40}}}}"#
    )
}

#[test]
fn what_cannot_be_drawn_is_named_and_nothing_is_drawn() {
    let at = "rows.0.panels.0.view";
    let light = |direction: &str| {
        format!(
            r#"{{"sphere": {{"view": {{"lights": [{{"direction": {direction}, "strength": [1, 1, 1]}}]}}}}}}"#
        )
    };
    let six = [r#"{"direction": [0, 0, 1], "strength": [1, 1, 1]}"#; 6].join(", ");
    let cases = [
        (
            r#"{"landscape": {"view": {"x": [0, 45], "y": [0, 1]}}}"#.into(),
            "landscape.view.x is [0, 45]; expected two shares from 0 to 1",
        ),
        (
            r#"{"image-slice": {"view": {"x": [0, 0]}}}"#.into(),
            "image-slice.view.x is [0, 0]",
        ),
        (
            r#"{"error-map": {"view": {"y": [0.5, 0.4]}}}"#.into(),
            "error-map.view.y is [0.5, 0.4]",
        ),
        (
            r#"{"error-map": {"weight": "cosin"}}"#.into(),
            "error-map.weight is \"cosin\"; expected one of cells, solid-angle, cosine; did you mean `cosine`?",
        ),
        (
            r#"{"landscape": {"eta": 0.5}}"#.into(),
            "landscape.eta is 0.5; expected 1 to 1000",
        ),
        (
            r#"{"landscape": {"limit": 91}}"#.into(),
            "landscape.limit is 91; expected 0 to 90",
        ),
        (
            light("[0, 0, 0]"),
            "sphere.view.lights.0.direction is [0, 0, 0]; expected a vector",
        ),
        (
            r#"{"sphere": {"view": {"lights": []}}}"#.into(),
            "sphere.view.lights.length is 0; expected 1 to 4",
        ),
        (
            format!(r#"{{"sphere": {{"view": {{"lights": [{six}]}}}}}}"#),
            "sphere.view.lights.length is 6; expected 1 to 4",
        ),
        (
            r#"{"sphere": {"sight": {"zoom": 0}}}"#.into(),
            "sphere.sight.zoom is 0; expected 1 to 50",
        ),
        (
            r#"{"sphere": {"split": 2}}"#.into(),
            "sphere.split is 2; expected -1 to 1",
        ),
        (
            r#"{"lobes": {"theta_i": [30, 120]}}"#.into(),
            "lobes.theta_i.1 is 120; expected 0 to 90",
        ),
        (
            r#"{"slices": {"theta_i": []}}"#.into(),
            "slices.theta_i.length is 0; expected 1 to 90",
        ),
        (
            r#"{"slices": {"window": [-100, 0]}}"#.into(),
            "slices.window is [-100, 0]; expected two angles from -90 to 90",
        ),
        (
            r#"{"albedo": {"limits": [1, 0]}}"#.into(),
            "albedo.limits is [1, 0]; expected two values",
        ),
        (
            r#"{"disc": {"theta_i": -5}}"#.into(),
            "disc.theta_i is -5; expected 0 to 90",
        ),
        (
            r#"{"lobe3d": {"camera": {"rotation": [0, 0, 0, 0]}}}"#.into(),
            "lobe3d.camera.rotation is [0, 0, 0, 0]; expected a quaternion",
        ),
        (
            r#"{"lobe3d": {"camera": {"zoom": 0}}}"#.into(),
            "lobe3d.camera.zoom is 0; expected 0.5 to 60",
        ),
        (
            r#"{"scatter": {"window": [5, 5]}}"#.into(),
            "scatter.window is [5, 5]; expected two values",
        ),
        (
            r#"{"scatter": {"y_window": [0.5, 7]}}"#.into(),
            "scatter.y_window is [0.5, 7]; expected two values from -0.1 to 1.1",
        ),
        (
            r#"{"scatter": {"model": "ggx", "y": "alpha"}}"#.into(),
            "scatter.y is \"alpha\"; expected one of rho_d, k_s, roughness, eta, error, which ggx has",
        ),
        (
            r#"{"scatter": {"y": "error"}}"#.into(),
            "scatter.errors.length is 0; expected 2, the E of each subject",
        ),
        (
            r#"{"scatter": {"y": "error", "errors": [0.1, -2]}}"#.into(),
            "scatter.errors.1 is -2; expected 0 to",
        ),
    ];
    let folder = Folder::new();
    let out = folder.path("out.svg");
    for (view, said) in &cases {
        let spec = folder.file("bad.figure.json", with_view(view));
        let result = grazing(&[&"figure", &spec, &"-o", &out]);
        failed_with(&result, 2, &spec, &format!("{at}.{said}"));
        assert!(!out.exists(), "{view}");
    }
    let unknown = [
        (
            r#"{"sphere": {"view": {"exposure": 1}}}"#,
            "sphere.view.exposure: unknown field `exposure`",
            "`exposure_stops`",
        ),
        (
            r#"{"sphere": {"view": {"lights": [{"direction": [0, 0, 1], "strenght": [1, 1, 1]}]}}}"#,
            "sphere.view.lights.0.strenght: unknown field",
            "`strength`",
        ),
        (
            r#"{"sphere": {"sight": {"centre": [0, 0]}}}"#,
            "sphere.sight.centre: unknown field",
            "`center`",
        ),
        (
            r#"{"lobe3d": {"camera": {"zom": 2}}}"#,
            "lobe3d.camera.zom: unknown field",
            "`zoom`",
        ),
        (
            r#"{"image-slice": {"view": {"z": [0, 1]}}}"#,
            "image-slice.view.z: unknown field",
            "expected `x` or `y`",
        ),
        (
            r#"{"landscape": {"fresnel": "exakt"}}"#,
            "landscape.fresnel: unknown variant",
            "did you mean `exact`?",
        ),
        (
            r#"{"scatter": {"model": "cook-torance"}}"#,
            "scatter.model: unknown variant",
            "did you mean `cook-torrance`?",
        ),
        (
            r#"{"scatter": {"x": "rougness"}}"#,
            "scatter.x: unknown variant",
            "did you mean `roughness`?",
        ),
        (
            r#"{"lobe3d": {"camera": {"zoom": 1e999}}}"#,
            "number out of range",
            "line",
        ),
    ];
    for (view, said, also) in unknown {
        let spec = folder.file("bad.figure.json", with_view(view));
        let result = grazing(&[&"figure", &spec, &"-o", &out]);
        failed_with(&result, 2, &spec, said);
        failed_with(&result, 2, &spec, also);
        assert!(!out.exists(), "{view}");
    }
    let whole = [
        (
            r#"{"subjects": [], "rows": []}"#.to_owned(),
            "rows.panels is 0; expected at least one",
        ),
        (
            with_view("\"scatter\"").replace("[0, 1]", "[0, 7]"),
            "rows.0.panels.0.subjects.1 is 7; expected one of the 2 subjects",
        ),
        (
            with_view("\"scatter\"").replace("violet-felt", "violett-felt"),
            "subjects.0.source.sample.key is \"violett-felt\"; expected one of copper-glaze",
        ),
        (
            with_view("\"scatter\"").replace("\"dpi\": 40", "\"dpi\": 4, \"width_mm\": 1e300"),
            "style.width_mm is 1e300; expected 20 to 2000; style.dpi is 4",
        ),
    ];
    for (text, said) in whole {
        let spec = folder.file("bad.figure.json", text);
        let result = grazing(&[&"figure", &spec, &"-o", &out]);
        failed_with(&result, 2, &spec, said);
        assert!(!out.exists());
    }
    // More curves than memory is for: 4000 subjects at the three angles of a plot of lobes.
    let many = (0..4000)
        .map(|k| (k % 2).to_string())
        .collect::<Vec<_>>()
        .join(", ");
    let text = with_view("\"lobes\"").replace("[0, 1]", &format!("[{many}]"));
    let spec = folder.file("bad.figure.json", text);
    let result = grazing(&[&"figure", &spec, &"-o", &out]);
    failed_with(
        &result,
        2,
        &spec,
        "rows.curves is 12000; expected at most 10000 in a figure",
    );
    let angles = vec!["30"; 3000].join(",");
    let args: [&dyn AsRef<std::ffi::OsStr>; 7] = [
        &"figure",
        &"--preset",
        &"slices",
        &"--theta-i",
        &angles,
        &"-o",
        &out,
    ];
    let result = grazing(&args);
    assert_eq!(result.status.code(), Some(2), "{}", stderr(&result));
    let said = "--theta-i has 3000 angles; expected at most 90";
    assert!(stderr(&result).contains(said), "{}", stderr(&result));
    assert!(!out.exists());
    // Planted: nothing is wrong with any of the views.
    for view in ["sphere", "lobes", "lobe3d", "scatter"] {
        let spec = folder.file("good.figure.json", with_view(&format!("\"{view}\"")));
        succeeded(&grazing(&[&"figure", &spec, &"-o", &out, &"--force"]));
    }
}

#[test]
fn the_length_of_a_direction_means_nothing() {
    let folder = Folder::new();
    let drawn = |length: f64| {
        let view = format!(
            r#"{{"sphere": {{"view": {{"lights": [{{"direction": [0, 0, {length}], "strength": [1, 1, 1]}}]}}}}}}"#
        );
        let spec = folder.file("light.figure.json", with_view(&view));
        let out = folder.path("light.svg");
        succeeded(&grazing(&[&"figure", &spec, &"-o", &out, &"--force"]));
        fs::read(out).expect("an SVG")
    };
    assert!(drawn(1.0) == drawn(2.0));
}

#[test]
fn specs_that_were_ever_written_are_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/program/figures");
    let mut views = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let spec = FigureSpec::open(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(spec.settled(), spec);
        let text = fs::read_to_string(&path).expect("a spec");
        let given: Value = serde_json::from_str(&text).expect("JSON");
        let written: Value = serde_json::from_str(&spec.to_json()).expect("JSON");
        assert_eq!(written, given, "{}", path.display());
        let panels = spec.rows.iter().flat_map(|row| &row.panels);
        views.extend(panels.map(|panel| panel.view.key()));
    }
    for view in grazing::figure::ViewSpec::defaults() {
        assert!(views.contains(&view.key()), "{}", view.key());
    }
}
