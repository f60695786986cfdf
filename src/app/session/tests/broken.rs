use crate::app::msg::Msg;
use crate::app::msg::session::SessionMsg;
use crate::app::reduce::apply;
use crate::app::session::places::{FoundSession, find};
use crate::app::session::read::read;
use crate::app::session::tests::{PATH, found, opened, rich, text};
use crate::app::state::notice::Severity;
use crate::app::state::views::ViewId;
use crate::app::views::lobes::settings::LobeSettings;
use serde_json::{Value, json};
use std::path::Path;

/// The rich session with one value replaced, and what is said of it.
fn with(pointer: &str, value: Value) -> FoundSession {
    let mut session: Value = serde_json::from_str(&text(&rich())).expect("JSON");
    match session.pointer_mut(pointer) {
        Some(place) => *place = value,
        None => {
            let (parent, key) = pointer.rsplit_once('/').expect("a place");
            session.pointer_mut(parent).expect("a parent")[key] = value;
        }
    }
    found(&session.to_string())
}

#[test]
fn what_cannot_be_is_replaced_and_named_in_one_line() {
    for (pointer, value, words) in [
        ("/shown", json!(99), "replaced: shown"),
        (
            "/views/lobes/active",
            json!(7),
            "replaced: views.lobes.active",
        ),
        (
            "/views/lobes/theta_i",
            json!([]),
            "replaced: views.lobes.theta_i",
        ),
        (
            "/views/lobes/theta_i/1",
            json!(120),
            "views.lobes.theta_i.1",
        ),
        ("/views/lobes/limits", json!([5, -1]), "views.lobes.limits"),
        ("/views/lobes/theta_i/1", json!(1e300), "an angle of"),
        ("/views/lobes/scale", json!("cubic"), "unknown variant"),
        (
            "/views/slices/spec/theta_i",
            json!([]),
            "views.slices.spec.theta_i",
        ),
        (
            "/views/slices/spec/window",
            json!([90, 10]),
            "views.slices.spec.window",
        ),
        (
            "/views/slices/spec/limits",
            json!([5, -1]),
            "views.slices.spec.limits",
        ),
        (
            "/views/lobe3d/camera/rotation",
            json!([0, 0, 0, 0]),
            "camera.rotation",
        ),
        ("/views/lobe3d/camera/zoom", json!(0), "camera.zoom"),
        (
            "/views/sphere/view/lights",
            json!([]),
            "views.sphere.view.lights",
        ),
        (
            "/views/sphere/view/lights/0/direction",
            json!([0, 0, 0]),
            "direction",
        ),
        (
            "/views/sphere/view/exposure_stops",
            json!(1e9),
            "exposure_stops",
        ),
        (
            "/views/image/view/x",
            json!([0.7, 0.2]),
            "views.image.view.x",
        ),
        (
            "/views/image/phi_d",
            json!("up"),
            "\"views.image\" is not understood",
        ),
        ("/fit/limit", json!(3), "fit.limit"),
        ("/fit/stages", json!([9, 1]), "fit.stages"),
        ("/fit/bounds/s", json!([500, 1]), "fit.bounds.s"),
        ("/fit/weight", json!("heavy"), "\"fit\" is not understood"),
        ("/probe/wi", json!([0, 0, 0]), "replaced: probe"),
        ("/hidden/0/material", json!(12), "hidden"),
        ("/materials/0/name", json!("\n"), "materials.0.name"),
        (
            "/materials/0/model/s",
            json!(-5),
            "\"materials.0.model\" is not understood",
        ),
        ("/materials/0/model/model", json!("wart"), "unknown model"),
        (
            "/materials/2/sample",
            json!("unobtainium"),
            "materials.2.sample",
        ),
        (
            "/materials/0/source",
            json!(5),
            "\"materials.0.source\" is not understood",
        ),
        (
            "/materials/0/fits/0/record/k_s",
            json!(1),
            "\"materials.0.fits.0\"",
        ),
        ("/materials/0/fits", json!({"a": 1}), "\"materials.0.fits\""),
        ("/layout/tree", json!([]), "\"layout\" is not understood"),
        (
            "/views/lobes/colour",
            json!("red"),
            "not known and left out: views.lobes.colour",
        ),
        (
            "/views/sphere/view/lights/0/colour",
            json!("red"),
            "not known and left out: views.sphere.view.lights.0.colour",
        ),
        (
            "/views/image/view/z",
            json!([0, 1]),
            "not known and left out: views.image.view.z",
        ),
        ("/zoo", json!([1]), "not known and left out: zoo"),
    ] {
        let found = with(pointer, value);
        let [remark] = &found.remarks[..] else {
            panic!("{pointer}: {:?}", found.remarks)
        };
        assert!(remark.contains(words), "{pointer}: {remark}");
        assert!(remark.ends_with(&format!(": {PATH}")), "{remark}");
        assert_eq!(remark.lines().count(), 1);
        // The rest opens, and what was replaced can be.
        let mut state = rich();
        let msg = SessionMsg::Read {
            job: 0,
            path: PATH.into(),
            found: Box::new(found),
        };
        apply(&mut state, Msg::Session(msg));
        assert_eq!(state.scene.opened.len(), 4);
        assert!(state.current().is_some());
        assert_eq!(state.notices.len(), 1);
        assert_eq!(state.notices[0].level, Severity::Info);
        let (_, remarks) = read(&text(&state)).expect("a session");
        assert_eq!(remarks, Vec::<String>::new(), "{pointer}");
    }
}

#[test]
fn hand_written_sessions_may_leave_almost_all_out() {
    let short = r#"{"grazing_session": 1, "materials": [{"name": "a", "sample": "copper-glaze"},
        {"model": {"model": "phong", "rho_d": [0, 0, 0], "k_s": [1, 1, 1], "s": 7}}]}"#;
    let state = opened(rich(), short);
    let names: Vec<&str> = state
        .scene
        .opened
        .iter()
        .map(|opened| state.materials[&opened.id].name.as_str())
        .collect();
    assert_eq!(names, ["a", "material 2"]);
    assert_eq!(state.scene.opened[1].brdf.params.lobe[0], 7.0);
    assert_eq!(
        *state.scene.views.get::<LobeSettings>(),
        LobeSettings::default()
    );
    assert!(!state.tiles.is_open(ViewId::Scatter), "the layout is left");
}

#[test]
fn a_view_that_is_null_is_as_if_left_out() {
    let found = with("/views/lobes", Value::Null);
    assert_eq!(found.remarks, [""; 0]);
    let lobes = found.session.views.get::<LobeSettings>();
    assert_eq!(*lobes, LobeSettings::default());
}

#[test]
fn what_is_no_session_is_refused_in_one_line() {
    let good = text(&rich());
    for (text, words) in [
        (good[..good.len() / 2].to_string(), "not valid JSON: EOF"),
        (
            good.replacen("_session\": 1", "_session\": 2", 1),
            "version 2; expected 1",
        ),
        (
            good.replacen("_session\": 1", "_session\": \"x\"", 1),
            "version \"x\"",
        ),
        (r#"{"grazing_session": 1}"#.into(), "no array \"materials\""),
        (
            r#"{"grazing_session": 1, "materials": [3]}"#.into(),
            "material 0",
        ),
        (r#"[{"model": "phong"}]"#.into(), "no session"),
        ("{}".into(), "no session"),
        (String::new(), "not valid JSON"),
    ] {
        let error = find(Path::new(PATH), &text)
            .expect_err("no session")
            .to_string();
        assert!(error.contains(words), "{error}");
        assert!(error.ends_with(&format!(": {PATH}")) && error.lines().count() == 1);
    }
    // Whatever is cut off or replaced, nothing panics.
    for end in (0..good.len()).step_by(97) {
        let _ = read(&good[..end]);
        let mut bytes = good.clone().into_bytes();
        bytes[end] = b'9';
        if let Ok(text) = String::from_utf8(bytes)
            && let Ok(found) = find(Path::new(PATH), &text)
        {
            let found = Box::new(found);
            let path = PATH.into();
            apply(
                &mut rich(),
                Msg::Session(SessionMsg::Read {
                    job: 0,
                    path,
                    found,
                }),
            );
        }
    }
}
