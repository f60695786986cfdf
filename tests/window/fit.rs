//! Fitting in the real window, driven by accessible names.

use crate::common::window::{Window, click, press, s, set_slider, settle, value, window};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::fit::FitMsg;
use grazing::app::state::State;
use grazing::app::state::fitting::kept::variant_name;
use grazing::app::state::fitting::settings::FitSettings;
use grazing::brdf::PHONG_FAMILY;
use grazing::brdf::{Brdf, Fresnel, MODELS, Model, ParamId};
use grazing::fit::options::NO_LIMIT;
use grazing::fit::{self, EndReason, FitOptions, Outcome, Problem, STAGES, Stage, Variant, Weight};
use grazing::measured::samples::SAMPLES;
use std::ops::ControlFlow;

fn shown(state: &State) -> Brdf {
    state.current().expect("a material").1.brdf
}

/// Leaves these stages ticked.
fn only(window: &mut Window, stages: &[Stage]) {
    for stage in STAGES.into_iter().filter(|stage| !stages.contains(stage)) {
        let name = format!("stage {}", stage.number());
        window.get_by_role_and_label(Role::CheckBox, &name).click();
        window.run_steps(2);
    }
    window.run_steps(2);
}

fn options(stages: &[Stage]) -> FitOptions {
    FitOptions {
        stages: stages.iter().copied().collect(),
        ..FitOptions::default()
    }
}

/// What the window starts with.
fn first_problem(weight: Weight) -> Problem {
    let table = SAMPLES[0].synthesize();
    Problem::new(&table, weight, NO_LIMIT).expect("a problem")
}

fn is_running(state: &State) -> bool {
    state.fit.run.as_ref().is_some_and(|run| !run.stopping)
}

/// How many words the run under way has said.
fn words(state: &State) -> usize {
    let run = state.fit.run.as_ref();
    run.map_or(0, |run| {
        run.parts.iter().map(|part| part.updates.len()).sum()
    })
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_fit_is_started_watched_and_ends_where_the_engine_does() {
    let mut window = window(vec![], vec![]);
    let before = shown(window.state().state());
    let stages = [Stage::Amplitudes, Stage::Shape];
    only(&mut window, &stages);
    click(&mut window, "Start the fit");
    assert!(is_running(window.state().state()));
    settle(&mut window, |state| {
        words(state) > 3 || state.fit.run.is_none()
    });
    let state = window.state().state();
    if let Some(live) = state.fit.run.as_ref().and_then(|run| run.live) {
        assert_eq!(shown(state), live.brdf, "the sliders follow");
    }
    settle(&mut window, |state| state.fit.run.is_none());
    let wanted = fit::fit(
        &first_problem(Weight::Cosine),
        Variant::from(&before),
        &options(&stages),
        &mut |_| ControlFlow::Continue(()),
    );
    let kept = window.state().state().current_fit().expect("a fit").clone();
    assert_eq!(kept.outcome, wanted);
    assert_eq!(shown(window.state().state()), wanted.brdf);
    assert!(kept.trace.len() >= stages.len(), "every word is kept");
    for report in &kept.outcome.stages {
        assert!(report.error <= report.start_error, "{report:?}");
        let end = format!("{:.2}", 100.0 * report.error);
        assert!(window.query_all_by_label(&end).next().is_some(), "{end}");
    }
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(shown(window.state().state()), before);
    assert!(!window.state().state().history.can_undo());
    click(&mut window, "Show fit");
    assert_eq!(shown(window.state().state()), wanted.brdf);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn escape_stops_a_fit_and_keeps_its_best() {
    let mut window = window(vec![], vec![]);
    let before = shown(window.state().state());
    // An engine that ends in the very frames of the key leaves nothing to stop; then once more.
    for _ in 0..20 {
        window.key_press_modifiers(Modifiers::COMMAND, Key::F);
        window.step();
        while is_running(window.state().state()) && words(window.state().state()) == 0 {
            window.step();
        }
        let live = shown(window.state().state());
        window.key_press(Key::Escape);
        window.step();
        let state = window.state().state();
        assert!(!is_running(state));
        assert_eq!(state.scene.opened[0].brdf.model, live.model);
        assert_ne!(state.scene.opened[0].brdf, before, "the best so far stays");
        settle(&mut window, |state| state.fit.run.is_none());
        let state = window.state().state();
        let kept = state.current_fit().expect("what it came to");
        assert_eq!(shown(state), kept.outcome.brdf);
        let ended = kept.outcome.ended;
        press(&mut window, Modifiers::COMMAND, Key::Z);
        assert_eq!(shown(window.state().state()), before);
        if ended == EndReason::Cancelled {
            return;
        }
    }
    panic!("twenty fits ran to their ends");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_dialog_has_escape_before_the_fit() {
    let mut window = window(vec![], vec![]);
    press(&mut window, Modifiers::COMMAND, Key::F);
    press(&mut window, Modifiers::NONE, Key::F1);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().state().dialog, None);
    settle(&mut window, |state| state.fit.run.is_none());
    let kept = window.state().state().current_fit().expect("a fit");
    assert_eq!(kept.outcome.ended, EndReason::Converged);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_second_fit_replaces_the_first() {
    let mut window = window(vec![], vec![]);
    only(&mut window, &[Stage::Amplitudes]);
    // Without a frame between them: the first one cannot end before the second begins.
    let ctx = window.ctx.clone();
    let start = |window: &mut Window| window.state_mut().handle(&ctx, Msg::Run(Command::Fit));
    start(&mut window);
    let first = window.state().state().fit.run.as_ref().map(|run| run.job);
    let settings = FitSettings {
        weight: Weight::Cells,
        ..window.state().state().fit.settings.clone()
    };
    window
        .state_mut()
        .handle(&ctx, Msg::Fit(FitMsg::Settings(settings)));
    start(&mut window);
    let second = window.state().state().fit.run.as_ref().map(|run| run.job);
    assert!(second > first && first.is_some());
    settle(&mut window, |state| state.fit.run.is_none());
    window.run_steps(10);
    let state = window.state().state();
    let (material, opened) = state.current().expect("a material");
    let [kept] = &material.fits[..] else {
        panic!("{:?}", material.fits)
    };
    assert_eq!(kept.setup.weight, Weight::Cells);
    let variant = Variant::from(&opened.brdf);
    let wanted = fit::fit(
        &first_problem(Weight::Cells),
        variant,
        &options(&[Stage::Amplitudes]),
        &mut |_| ControlFlow::Continue(()),
    );
    assert_eq!(kept.outcome, wanted);
}

/// Places of the rows of the table from the top.
fn rows(window: &Window) -> Vec<String> {
    let mut rows: Vec<(f32, String)> = window
        .query_all_by_role(Role::Button)
        .filter_map(|node| {
            let label = node.accesskit_node().label()?;
            let name = label.strip_prefix("Show ")?.to_string();
            name.contains("Fresnel").then(|| (node.rect().top(), name))
        })
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    rows.into_iter().map(|(_, name)| name).collect()
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_models_to_compare_fill_a_table_that_sorts_shows_and_overlays() {
    let mut window = window(vec![], vec![]);
    only(&mut window, &[Stage::Amplitudes]);
    let before = shown(window.state().state());
    click(&mut window, "Start to compare");
    settle(&mut window, |state| {
        words(state) > 0 || state.fit.run.is_none()
    });
    assert_eq!(rows(&window).len(), 6, "the table is there from the start");
    settle(&mut window, |state| state.fit.run.is_none());
    let state = window.state().state();
    let (material, opened) = state.current().expect("a material");
    assert_eq!((material.fits.len(), opened.brdf), (6, before));
    let mut wanted = fit::fit_all(
        &first_problem(Weight::Cosine),
        &Variant::of(PHONG_FAMILY, before.fresnel),
        &options(&[Stage::Amplitudes]),
        &mut |_, _| ControlFlow::Continue(()),
    );
    for outcome in &wanted {
        let kept = material.fit(Variant::from(&outcome.brdf)).expect("a row");
        assert_eq!(kept.outcome, *outcome);
    }
    let name = |outcome: &Outcome| variant_name(Variant::from(&outcome.brdf));
    // Ties stay in the order of the variants.
    wanted.sort_by(|a, b| a.errors.total.total_cmp(&b.errors.total));
    assert_eq!(rows(&window), wanted.iter().map(name).collect::<Vec<_>>());
    click(&mut window, "Sort by variant");
    let by_name: Vec<String> = Variant::of(PHONG_FAMILY, before.fresnel)
        .into_iter()
        .map(variant_name)
        .collect();
    assert_eq!(rows(&window), by_name);

    click(&mut window, "Show Blinn-Phong, no Fresnel");
    let blinn_phong = Variant {
        model: MODELS[1],
        fresnel: Fresnel::None,
    };
    let brdf = |window: &Window| shown(window.state().state());
    let outcome = wanted
        .iter()
        .find(|outcome| Variant::from(&outcome.brdf) == blinn_phong)
        .expect("a variant");
    assert_eq!(brdf(&window), outcome.brdf);
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(brdf(&window), before);
    assert!(!window.state().state().history.can_undo());

    let picture = window.render().expect("a picture");
    window
        .get_by_role_and_label(Role::CheckBox, "Overlay Blinn-Phong, no Fresnel")
        .click();
    window.run_steps(3);
    let state = window.state().state();
    let overlaid = |state: &State| {
        let fits = &state.current().expect("a material").0.fits;
        fits.iter().filter(|kept| kept.overlaid).count()
    };
    assert_eq!(overlaid(state), 1);
    let lobes = window
        .get_by_role_and_label(Role::Image, "Polar lobes")
        .rect();
    let after = window.render().expect("a picture");
    let changed = after
        .enumerate_pixels()
        .filter(|(x, y, pixel)| {
            lobes.contains(egui::pos2(*x as f32, *y as f32)) && *pixel != picture.get_pixel(*x, *y)
        })
        .count();
    assert!(changed > 200, "a curve and a name change {changed} pixels");

    let stale = |window: &Window| {
        let state = window.state().state();
        let fits = &state.current().expect("a material").0.fits;
        fits.iter().filter(|kept| state.is_stale(kept)).count()
    };
    assert_eq!(stale(&window), 0);
    window.get_by_role_and_label(Role::SpinButton, "Grazing limit");
    let ctx = window.ctx.clone();
    let command = Command::UseWeight(Weight::SolidAngle);
    window.state_mut().handle(&ctx, Msg::Run(command));
    window.run_steps(3);
    assert_eq!(stale(&window), 6);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn ticking_keeps_the_amplitudes_at_their_best() {
    let mut window = window(vec![], vec![]);
    let problem = first_problem(Weight::Cosine);
    window
        .get_by_role_and_label(Role::CheckBox, "keep rho_d, k_s optimal")
        .click();
    window.run_steps(3);
    assert!(window.state().state().fit.keep_optimal);
    assert!(
        window
            .get_by_role_and_label(Role::Slider, "k_s")
            .accesskit_node()
            .is_disabled()
    );
    for s_wanted in [12.0, 150.0] {
        set_slider(&mut window, "s", s_wanted);
        let s_now = s(&window);
        let best = |state: &State| {
            let brdf = shown(state);
            problem.with_best_amplitudes(&brdf).params.k_s == brdf.params.k_s
        };
        settle(&mut window, best);
        assert_eq!(s(&window), s_now);
    }
    let (k_s, at_best) = (value(&window, ParamId::K_S), s(&window));
    press(&mut window, Modifiers::COMMAND, Key::Z);
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!((value(&window, ParamId::K_S), s(&window)), (k_s, at_best));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_window_goes_in_the_middle_of_a_fit() {
    let mut window = window(vec![], vec![]);
    press(&mut window, Modifiers::COMMAND, Key::F);
    settle(&mut window, |state| words(state) > 0);
    let cancel = window
        .state()
        .state()
        .fit
        .run
        .as_ref()
        .map(|run| run.cancel.clone());
    eframe::App::on_exit(window.state_mut());
    assert!(cancel.is_none_or(|cancel| cancel.is_set()));
}

/// Labels of the check boxes whose name passes.
fn ticks(window: &Window, wanted: impl Fn(&str) -> bool) -> Vec<String> {
    window
        .query_all_by_role(Role::CheckBox)
        .filter_map(|node| node.accesskit_node().label())
        .filter(|label| wanted(label))
        .collect()
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn models_to_compare_are_ticked_and_columns_chosen() {
    let mut window = window(vec![], vec![]);
    only(&mut window, &[Stage::Amplitudes]);
    click(&mut window, "Models to compare");
    let is_model = |label: &str| MODELS.iter().any(|model| model.name == label);
    assert_eq!(ticks(&window, is_model).len(), MODELS.len());
    // The menu stays open from tick to tick.
    for name in ["GGX", "Phong", "None"] {
        window.get_by_role_and_label(Role::CheckBox, name).click();
        window.run_steps(2);
    }
    let ggx = Model::by_key("ggx").expect("a model");
    let wanted: Vec<Variant> = [MODELS[1], MODELS[2], ggx]
        .map(|model| Variant {
            model,
            fresnel: Fresnel::Exact,
        })
        .into();
    assert_eq!(window.state().state().prefs.comparison.variants(), wanted);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(ticks(&window, is_model).is_empty());
    click(&mut window, "Start to compare");
    settle(&mut window, |state| state.fit.run.is_none());
    assert_eq!(rows(&window).len(), wanted.len());

    // Only what these models have can be chosen, and what is hidden has no head.
    click(&mut window, "Columns");
    let columns = ticks(&window, |label| label.starts_with("column "));
    let has = |key: &str| {
        columns
            .iter()
            .any(|label| label == &format!("column {key}"))
    };
    assert!(
        has("roughness") && has("alpha") && !has("c_z"),
        "{columns:?}"
    );
    for key in ["roughness", "evaluations"] {
        let label = format!("column {key}");
        window.get_by_role_and_label(Role::CheckBox, &label).click();
        window.run_steps(2);
    }
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.query_by_label("Sort by a, m").is_none());
    click(&mut window, "Sort by evaluations");
    click(&mut window, "Sort by evaluations");
    let kept = |name: &String| {
        let fits = &window.state().state().current().expect("a material").0.fits;
        let kept = fits
            .iter()
            .find(|kept| variant_name(kept.variant()) == *name);
        kept.expect("a row").outcome.evaluations
    };
    let evaluations: Vec<usize> = rows(&window).iter().map(kept).collect();
    assert!(evaluations.is_sorted_by(|a, b| a >= b), "{evaluations:?}");
}
