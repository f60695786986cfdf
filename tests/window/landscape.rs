//! The error landscape in the real window.

use crate::common::window::{Window, drag, run, settle, value, window};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::state::views::ViewId;
use grazing::app::views::landscape::work::{LandscapeQuery, path};
use grazing::brdf::ParamId;
use grazing::fit::Problem;

fn open(window: &mut Window) {
    run(window, Command::ToggleTile(ViewId::Landscape));
    run(window, Command::ToggleTile(ViewId::Landscape));
}

fn made(window: &mut Window) {
    settle(window, |state| {
        let slot = state.caches.get::<LandscapeQuery>().expect("a cache");
        let last = slot.last().and_then(|(_, made)| made.as_ref().ok());
        last.is_some_and(|landscape| landscape.best.is_some()) && slot.progress().is_none()
    });
}

fn rect(window: &Window) -> egui::Rect {
    window
        .get_by_role_and_label(Role::Image, "Error landscape")
        .rect()
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_click_takes_the_best_model_there_as_one_step() {
    let mut window = window(vec![], vec![]);
    run(&mut window, Command::UseModel(0));
    open(&mut window);
    made(&mut window);
    let before = window.state().state().scene.clone();
    let point = rect(&window).center();
    drag(&mut window, &[point, point]);
    let taken = window.state().state().current().expect("one").1.brdf;
    assert_eq!(taken.model.key, "combined");
    assert!(
        taken.params.lobe[0] > 1.0 && taken.params.lobe[0] < 1e4,
        "{taken:?}"
    );
    assert!(taken.params.lobe[1] > 0.3 && taken.params.lobe[1] < 0.7);
    // ρ_d and k_s become those of all cells.
    let state = window.state().state();
    let (material, _) = state.current().expect("one");
    let settings = &state.fit.settings;
    let problem = Problem::new(&material.table, settings.weight, settings.limit).expect("cells");
    let best = problem.with_best_amplitudes(&taken);
    settle(&mut window, |state| {
        state
            .current()
            .is_some_and(|(_, opened)| opened.brdf == best)
    });
    run(&mut window, Command::Undo);
    assert_eq!(window.state().state().scene, before, "one step");
    let s = value(&window, ParamId("s"));
    window.run_steps(10);
    assert_eq!(value(&window, ParamId("s")), s);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_way_of_a_fit_is_kept_and_ends_at_its_model() {
    let mut window = window(vec![], vec![]);
    assert!(path(window.state().state()).is_empty());
    run(&mut window, Command::Fit);
    settle(&mut window, |state| state.fit.run.is_none());
    let state = window.state().state();
    let way = path(state);
    assert!(way.len() > 2 && way.len() <= 401, "{}", way.len());
    let params = state.current().expect("one").1.brdf.params;
    assert_eq!(way.last(), Some(&[params.lobe[0], params.lobe[1]]));
    open(&mut window);
    made(&mut window);
    let slot = window
        .state()
        .state()
        .caches
        .get::<LandscapeQuery>()
        .expect("a cache");
    let (_, landscape) = slot.last().expect("made");
    let (_, least) = landscape.as_ref().expect("cells").best.expect("finest");
    let fit = window.state().state().current_fit().expect("kept");
    // Nothing on the grid is better than the fit by more than the fit may miss.
    assert!(least > 0.999 * fit.outcome.errors.total);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn it_is_stopped_and_goes_on() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    window
        .get_by_role_and_label(Role::Button, "η solved")
        .click();
    window.run_steps(3);
    window.get_by_role_and_label(Role::Button, "Stop").click();
    window.run_steps(3);
    let slot = window
        .state()
        .state()
        .caches
        .get::<LandscapeQuery>()
        .expect("a cache");
    assert!(slot.progress().is_none());
    window.run_steps(5);
    window.get_by_role_and_label(Role::Button, "Go on").click();
    window.run_steps(3);
    assert!(
        window
            .state()
            .state()
            .caches
            .progress::<LandscapeQuery>()
            .is_some()
    );
}
