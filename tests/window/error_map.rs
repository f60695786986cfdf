//! The error map in the real window.

use crate::common::window::{Window, run, settings, settle, window};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::state::views::ViewId;
use grazing::app::views::error_map::settings::ErrorMapSettings;
use grazing::app::views::error_map::work::ErrorMapQuery;
use grazing::figure::error_map::Plane;
use grazing::fit::Problem;

fn open(window: &mut Window) {
    run(window, Command::ToggleTile(ViewId::ErrorMap));
    run(window, Command::ToggleTile(ViewId::ErrorMap));
    settle(window, |state| {
        state.caches.last::<ErrorMapQuery>().is_some()
            && state.caches.progress::<ErrorMapQuery>().is_none()
    });
}

fn total(window: &Window) -> f64 {
    let slot = window
        .state()
        .state()
        .caches
        .get::<ErrorMapQuery>()
        .expect("a cache");
    let (_, made) = slot.last().expect("made");
    made.as_ref().expect("cells").total
}

/// E of the shown model as a fit reports it.
fn error(window: &Window) -> f64 {
    let state = window.state().state();
    let (material, opened) = state.current().expect("a material");
    let settings = &state.fit.settings;
    let problem = Problem::new(&material.table, settings.weight, settings.limit);
    problem.expect("cells").errors(&opened.brdf).total
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn its_total_is_the_error_of_the_shown_model() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    let first = total(&window);
    assert!((first / error(&window) - 1.0).abs() < 1e-5);
    crate::common::window::set_slider(&mut window, "s", 900.0);
    settle(&mut window, |state| {
        let made = state
            .caches
            .last::<ErrorMapQuery>()
            .map(|(wish, _)| wish.brdf);
        let shown = state.current().map(|(_, opened)| opened.brdf);
        made == shown && state.caches.progress::<ErrorMapQuery>().is_none()
    });
    assert!((total(&window) / error(&window) - 1.0).abs() < 1e-5);
    assert!(
        (total(&window) / first - 1.0).abs() > 0.01,
        "planted: the old one"
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_bin_under_the_pointer_is_the_probe() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    let rect = window
        .get_by_role_and_label(Role::Image, "Error map")
        .rect();
    let mut seen = Vec::new();
    for offset in [[-20.0, 10.0], [10.0, 10.0], [10.0, -20.0]] {
        window.hover_at(rect.center() + egui::Vec2::from(offset));
        window.run_steps(2);
        let probe = window.state().state().probe().expect("a probe");
        seen.push((probe.theta_i(), probe.signed_theta_o()));
    }
    // θi to the right, θo upwards, on the side of the mirror direction.
    assert!(seen[1].0 > seen[0].0 && (seen[1].1 - seen[0].1).abs() < 1e-6);
    assert!(seen[2].1 > seen[1].1 && (seen[2].0 - seen[1].0).abs() < 1e-6);
    // Both axes are as long: 30 points are as many degrees on either.
    let (across, up) = (seen[1].0 - seen[0].0, seen[2].1 - seen[1].1);
    assert!((across / up - 1.0).abs() < 1e-3);
    window.get_by_role_and_label(Role::Button, "θh, θd").click();
    window.run_steps(3);
    let plane = settings::<ErrorMapSettings>(&window).plane;
    assert_eq!(plane, Plane::HalfDiff);
    window.hover_at(rect.center());
    window.run_steps(2);
    let angles = window
        .state()
        .state()
        .probe()
        .and_then(|probe| probe.angles())
        .expect("a probe");
    assert!((angles.phi_d.to_degrees() - 90.0).abs() < 1e-6);
}
