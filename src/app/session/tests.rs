mod broken;

use crate::app::msg::Msg;
use crate::app::msg::session::SessionMsg;
use crate::app::reduce::apply;
use crate::app::reduce::fit::keep_fit;
use crate::app::session::file::SessionFile;
use crate::app::session::places::{FoundSession, find};
use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::table::Column;
use crate::app::state::material::{Material, MaterialId, Opened, Origin, Presence};
use crate::app::state::probe::Probe;
use crate::app::state::subject_key::{SubjectKey, What};
use crate::app::state::views::ViewId;
use crate::app::views::albedo::settings::AlbedoSettings;
use crate::app::views::error_map::settings::ErrorMapSettings;
use crate::app::views::image::settings::ImageSettings;
use crate::app::views::landscape::settings::LandscapeSettings;
use crate::app::views::lobe3d::settings::Lobe3dSettings;
use crate::app::views::lobes::settings::LobeSettings;
use crate::app::views::scatter::settings::ScatterSettings;
use crate::app::views::slices::settings::SliceSettings;
use crate::app::views::sphere::settings::{Show, SphereSettings};
use crate::brdf::COMBINED;
use crate::brdf::ParamId;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, MODELS, Params};
use crate::figure::error_map::Plane;
use crate::figure::lobes::LobeScale;
use crate::figure::scale::RadialScale;
use crate::figure::scatter::Quantity;
use crate::figure::shown::Shown;
use crate::figure::slices::{Over, Residual};
use crate::figure::{Channel, CosineFactor};
use crate::files::SourceFile;
use crate::fit::options::NO_LIMIT;
use crate::fit::{
    EndReason, Errors, FitOptions, Outcome, Stage, StageReport, StageSet, Variant, Weight,
};
use crate::geom::sphere_error::SphereError;
use crate::measured::Table;
use crate::measured::lookup::Lookup;
use glam::{DQuat, DVec3};
use serde_json::{Value, json};
use std::path::Path;

const PATH: &str = "/data/study.grazing.json";

fn brdf(model: usize, fresnel: Fresnel, s: f64) -> Brdf {
    let params = Params {
        rho_d: [0.1 + 0.2, 0.25, 1.0 / 3.0],
        k_s: [1e-3, 12.5, 7e5],
        lobe: lobe_values([s, 0.3]),
        eta: 1.33,
    };
    let model = MODELS[model];
    Brdf {
        model,
        fresnel,
        params,
    }
}

fn kept(brdf: Brdf, error: f64) -> KeptFit {
    let stage = StageReport {
        stage: Stage::Joint,
        start: brdf,
        start_error: 2.0 * error,
        end: brdf,
        error,
        evaluations: 17,
    };
    let mut options = FitOptions::default();
    options
        .held
        .shared
        .insert(ParamId("s"), brdf.params.lobe[0]);
    options.bounds.insert(ParamId::RHO_D, (0.0, 0.5));
    let mut setup = crate::app::state::fitting::settings::FitSettings::default().setup(&brdf);
    setup.options = options.clone();
    setup.limit = 77f64.to_radians();
    let albedo = [[0.5; 3], [0.6; 3], [1.1, 0.2, 0.3]];
    KeptFit {
        outcome: Outcome {
            brdf,
            errors: Errors {
                total: error,
                grazing: None,
                // A channel that is black has none.
                channels: [error, f64::NAN, 0.125],
            },
            stages: vec![stage],
            evaluations: 34,
            ended: EndReason::Limit,
            albedo,
            concerns: crate::fit::diagnostics::diagnose(&brdf, &options, &albedo),
        },
        setup,
        seconds: Some(1.75),
        trace: Vec::new(),
        on_opening: false,
        overlaid: true,
    }
}

fn add(state: &mut State, name: &str, origin: Origin, source: Option<SourceFile>, brdf: Brdf) {
    let id = MaterialId(state.fresh_id());
    let material = Material {
        fit_due: false,
        name: name.into(),
        own_name: name.into(),
        origin,
        source,
        table: Table::unmeasured(),
        presence: Presence::Loaded,
        last_shown: 0,
        guess: Brdf {
            params: COMBINED.default_params(),
            ..brdf
        },
        fits: Vec::new(),
    };
    state.materials.insert(id, material);
    let beside = false;
    state.scene.opened.push(Opened { id, brdf, beside });
}

/// A file, a sample and a model alone, and nothing as it is at first.
fn rich() -> State {
    let mut state = State::default();
    for (name, path) in [
        ("gold", "/data/merl/gold.binary"),
        ("tin", "/far/tin.binary"),
    ] {
        let source = SourceFile {
            path: path.into(),
            bytes: Some(34_992_012),
            sha256: Some(format!("{name}{}", "0".repeat(60))),
        };
        let brdf = brdf(2, Fresnel::Schlick, 12.0);
        add(
            &mut state,
            name,
            Origin::File(path.into()),
            Some(source),
            brdf,
        );
    }
    let phong = brdf(0, Fresnel::None, 0.1 + 0.7);
    add(
        &mut state,
        "Copper glaze (synthetic)",
        Origin::Sample(1),
        None,
        phong,
    );
    let alone = Origin::File("/data/models.json".into());
    add(
        &mut state,
        "my model",
        alone,
        None,
        brdf(1, Fresnel::Exact, 99.0),
    );
    let gold = state.scene.opened[0].id;
    keep_fit(&mut state, gold, kept(brdf(2, Fresnel::Exact, 20.0), 0.25));
    keep_fit(&mut state, gold, kept(brdf(0, Fresnel::None, 3.0), 0.5));

    let scene = &mut state.scene;
    scene.selected = 1;
    scene.opened[2].beside = true;
    let fit = Variant::from(&brdf(2, Fresnel::Exact, 1.0));
    for (material, what) in [(2, What::Measured), (0, What::Fit(fit)), (1, What::Model)] {
        let material = scene.opened[material].id;
        scene.hidden.push(SubjectKey { material, what });
    }
    scene.lookup = Lookup::Nearest;
    scene
        .views
        .get_mut::<SphereSettings>()
        .view
        .lights
        .truncate(1);
    scene.views.get_mut::<SphereSettings>().view.lights[0].direction =
        DVec3::new(0.1, -0.4, 0.3).normalize();
    scene.views.get_mut::<SphereSettings>().view.exposure_stops = -1.25;
    scene.views.get_mut::<SphereSettings>().show = Show::Error(SphereError::Ratio);
    scene.views.get_mut::<SphereSettings>().split = 0.3;
    scene.views.get_mut::<LobeSettings>().theta_i = [5.5, 88.0].map(f64::to_radians).to_vec();
    scene.views.get_mut::<LobeSettings>().active = 0;
    scene.views.get_mut::<LobeSettings>().scale = LobeScale::Log;
    scene.views.get_mut::<LobeSettings>().cosine = CosineFactor::BOTH;
    scene.views.get_mut::<LobeSettings>().channel = Channel::B;
    let spec = &mut scene.views.get_mut::<SliceSettings>().spec;
    spec.over = Over::PhiD;
    spec.theta_h = 0.3;
    spec.window = Some([0.5, 2.0]);
    spec.limits = Some([0.001, 40.0]);
    spec.residual = Residual::Ratio;
    scene.views.get_mut::<SliceSettings>().follow = true;
    scene.views.get_mut::<AlbedoSettings>().spec.window = Some([0.25, 1.0]);
    scene.views.get_mut::<Lobe3dSettings>().theta_i = 1.0;
    scene.views.get_mut::<Lobe3dSettings>().camera.rotation =
        DQuat::from_rotation_x(0.5) * DQuat::from_rotation_z(2.0);
    scene.views.get_mut::<Lobe3dSettings>().camera.zoom = 3.0;
    scene.views.get_mut::<ImageSettings>().shown = Shown::Ratio;
    scene.views.get_mut::<ImageSettings>().view.x = (0.25, 0.75);
    scene.views.get_mut::<ErrorMapSettings>().plane = Plane::HalfDiff;
    scene.views.get_mut::<LandscapeSettings>().solve_eta = true;

    state.fit.settings.weight = Weight::Cells;
    state.fit.settings.limit = 80f64.to_radians();
    state.fit.settings.stages = StageSet::from_iter([Stage::Amplitudes, Stage::ShapeAndSpecular]);
    state.fit.settings.held.insert(ParamId("alpha"));
    state.fit.settings.bounds.insert(ParamId("s"), (1.0, 500.0));
    state.fit.keep_optimal = true;
    state.fit.table.sort_by(Column::Grazing);
    state.fit.table.show(Column::Time, false);
    state.fit.table.show(Column::Evaluations, true);
    state.pinned = Some(Probe::in_plane(0.7, -0.2));
    state.tiles.toggle(ViewId::Scatter);
    state
}

fn text(state: &State) -> String {
    let session = SessionFile::of(state).placed(Path::new(PATH));
    session.text().expect("data that JSON has")
}

fn found(text: &str) -> FoundSession {
    find(Path::new(PATH), text).expect("a session")
}

fn opened(mut state: State, text: &str) -> State {
    let found = Box::new(found(text));
    assert_eq!(found.remarks, Vec::<String>::new());
    let path = PATH.into();
    apply(
        &mut state,
        Msg::Session(SessionMsg::Read {
            job: 0,
            path,
            found,
        }),
    );
    state
}

#[track_caller]
fn same(a: &str, b: &str, what: &str) {
    for (a, b) in a.lines().zip(b.lines()) {
        assert_eq!(a, b, "{what}");
    }
    assert_eq!(a.len(), b.len(), "{what}");
}

#[test]
fn what_old_sessions_said_of_grey_is_no_unknown_key() {
    let mut value: Value = serde_json::from_str(&text(&rich())).expect("JSON");
    let remarks = |value: &Value| {
        let read = crate::app::session::read::read(&value.to_string());
        read.expect("a session").1
    };
    value["grey"] = json!({ "rho_d": true, "k_s": false });
    assert_eq!(remarks(&value), Vec::<String>::new());
    value["gray"] = value["grey"].take();
    assert!(remarks(&value).iter().any(|line| line.contains("gray")));
}

/// Changes that a session keeps, one each.
const CHANGES: [fn(&mut State); 29] = [
    |s| s.scene.selected = 3,
    |s| s.scene.opened.truncate(2),
    |s| s.scene.opened[1].brdf.params.k_s[2] += 1e-9,
    |s| s.scene.opened[2].brdf.params.eta = 1.7,
    |s| s.scene.opened[0].beside = true,
    |s| s.scene.hidden.swap(0, 1),
    |s| s.scene.lookup = Lookup::Smooth,
    |s| s.scene.views.get_mut::<SphereSettings>().split = -0.5,
    |s| {
        s.scene.views.get_mut::<SphereSettings>().sight = s
            .scene
            .views
            .get::<SphereSettings>()
            .sight
            .zoomed(2.0, [0.25, 0.5]);
    },
    |s| s.scene.views.get_mut::<LobeSettings>().theta_i[1] = 0.5,
    |s| s.scene.views.get_mut::<SliceSettings>().spec.phi_d = 0.25,
    |s| s.scene.views.get_mut::<AlbedoSettings>().spec.channel = Channel::R,
    |s| s.scene.views.get_mut::<Lobe3dSettings>().camera.center = [0.5, -0.25],
    |s| s.scene.views.get_mut::<ImageSettings>().root = !s.scene.views.get::<ImageSettings>().root,
    |s| s.scene.views.get_mut::<ErrorMapSettings>().scale = RadialScale::Log,
    |s| s.scene.views.get_mut::<LandscapeSettings>().view.y = (0.5, 1.0),
    |s| s.scene.views.get_mut::<ScatterSettings>().window = Some([2.0, 50.0]),
    |s| s.scene.views.get_mut::<ScatterSettings>().model = MODELS[5],
    |s| s.scene.views.get_mut::<ScatterSettings>().y = Some(Quantity::Error),
    |s| s.fit.settings.from_sliders = true,
    |s| s.fit.settings.limit = NO_LIMIT,
    |s| s.fit.table.sort = Column::Name,
    |s| s.fit.table.descending = true,
    |s| s.fit.table.hidden.clear(),
    |s| s.pinned = None,
    |s| s.tiles.toggle(ViewId::Lobes),
    |s| s.materials.values_mut().next().expect("one").fits[0].overlaid = false,
    |s| {
        s.materials.values_mut().next().expect("one").fits[1]
            .outcome
            .errors
            .total = 0.4;
    },
    |s| {
        s.materials
            .values_mut()
            .last()
            .expect("one")
            .guess
            .params
            .lobe[0] = 7.0;
    },
];

#[test]
fn a_session_read_back_is_the_same_as_data() {
    let original = text(&rich());
    let again = opened(State::default(), &original);
    same(&text(&again), &original, "");
    assert_eq!(again.title(), "study — Grazing");
    assert!(!again.history.can_undo(), "the start is no step");
    for (index, change) in CHANGES.into_iter().enumerate() {
        let mut state = rich();
        change(&mut state);
        let changed = text(&state);
        assert!(changed != original, "change {index} is not in the file");
        let again = opened(rich(), &changed);
        same(&text(&again), &changed, &format!("change {index} is lost"));
    }
    // Planted: a state that lost one of them would be caught.
    let mut forgetful = opened(State::default(), &original);
    forgetful.scene.views.get_mut::<LobeSettings>().cosine = CosineFactor::NONE;
    assert!(text(&forgetful) != original);
}

#[test]
fn undo_brings_back_what_was_open_and_its_name() {
    let mut before = rich();
    before.session.files.insert(0, "/x/old.grazing.json".into());
    let scene = before.scene.clone();
    let mut text = serde_json::to_value(SessionFile::of(&State::default())).expect("data");
    text["lookup"] = json!("nearest");
    let mut after = opened(before, &text.to_string());
    assert!(after.scene.opened.is_empty() && after.title().starts_with("study"));
    apply(&mut after, Msg::Run(crate::app::command::Command::Undo));
    assert_eq!(after.scene, scene);
    assert!(after.title().starts_with("old"));
    assert_eq!(after.materials.len(), 4, "the data are still there");
}

#[test]
fn what_is_missing_is_kept_with_its_models_and_saved_again_as_it_was() {
    let original = text(&rich());
    let mut state = opened(State::default(), &original);
    let asked: Vec<MaterialId> = state.all_asked_for().map(|missing| missing.id).collect();
    assert_eq!(asked, [0, 1].map(|k| state.scene.opened[k].id));
    let tried = &state.asked_for().expect("the first").tried;
    let expected = ["/data/merl/gold.binary", "/data/gold.binary"];
    assert_eq!(tried[..], expected.map(std::path::PathBuf::from));
    apply(&mut state, Msg::Session(SessionMsg::Skip { all: false }));
    assert_eq!(state.asked_for().map(|missing| missing.id), Some(asked[1]));
    apply(&mut state, Msg::Session(SessionMsg::Skip { all: true }));
    assert_eq!(state.asked_for(), None);
    same(&text(&state), &original, "");
    // Found on another machine: the new place is what is saved.
    let located = vec![(asked[0], "/new/gold.binary".into())];
    let tasks = apply(&mut state, Msg::Session(SessionMsg::Located(located)));
    assert_eq!(tasks.len(), 1);
    let again: Value = serde_json::from_str(&text(&state)).expect("JSON");
    assert_eq!(again["materials"][0]["source"]["path"], "/new/gold.binary");
    assert_eq!(
        again["materials"][0]["source"]["relative"],
        "../new/gold.binary"
    );
    assert_eq!(
        again["materials"][0]["fits"].as_array().map(Vec::len),
        Some(2)
    );
}
