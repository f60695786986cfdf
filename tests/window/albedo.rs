//! The albedo in the real window.

use crate::common::window::{Window, run, set_slider, settings, settle, window};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::State;
use grazing::app::state::subjects::Subjects;
use grazing::app::state::views::ViewId;
use grazing::app::views::albedo::settings::AlbedoSettings;
use grazing::app::views::albedo::work::{MeasuredAlbedo, curves};
use grazing::brdf;
use grazing::figure::Channel;

fn known(state: &State) -> bool {
    let subjects = Subjects::of(state);
    let curves = curves(&state.caches, &subjects.list);
    curves
        .iter()
        .all(|curve| !curve.points.is_empty() && !curve.old)
}

fn opened() -> Window {
    let mut window = window(vec![], vec![]);
    let is_shown = |window: &Window| {
        window
            .query_by_role_and_label(Role::Image, "Albedo")
            .is_some()
    };
    if !is_shown(&window) {
        run(&mut window, Command::ToggleTile(ViewId::Albedo));
        run(&mut window, Command::ToggleTile(ViewId::Albedo));
    }
    assert!(is_shown(&window));
    settle(&mut window, known);
    window
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn curves_are_computed_and_follow_the_model() {
    let mut window = opened();
    let distance = |window: &Window| -> f64 {
        let state = window.state().state();
        let (_, opened) = state.current().expect("a material");
        let subjects = Subjects::of(state);
        let curves = curves(&state.caches, &subjects.list);
        let points = curves[1].points.iter();
        let off = |(found, wanted): (f64, f64)| (found - wanted).abs();
        points
            .map(|p| off((p.rgb[1], brdf::albedo(&opened.brdf, p.theta_i)[1])))
            .fold(0.0, f64::max)
    };
    assert_eq!(distance(&window), 0.0);
    set_slider(&mut window, "s", 12.0);
    settle(&mut window, known);
    assert_eq!(distance(&window), 0.0);
    let state = window.state().state();
    let subjects = Subjects::of(state);
    let measured = curves(&state.caches, &subjects.list)[0].points;
    assert!(measured.iter().all(|p| p.measured > 0.5 && p.rgb[0] > 0.0));
    // A model of other parameters is seen.
    let ctx = window.ctx.clone();
    let old = distance(&window);
    let change = Msg::SetParam {
        id: brdf::ParamId::RHO_D,
        channel: None,
        value: 0.9,
    };
    window.state_mut().handle(&ctx, change);
    assert!(distance(&window) > old + 0.01);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_probe_is_the_mirror_pair_at_the_angle() {
    let mut window = opened();
    let rect = window.get_by_role_and_label(Role::Image, "Albedo").rect();
    window.hover_at(rect.lerp_inside(egui::vec2(0.5, 0.5)));
    window.run_steps(2);
    let probe = window.state().state().probe().expect("a probe");
    assert!((35.0..60.0).contains(&probe.theta_i().to_degrees()));
    assert!((probe.theta_i() - probe.signed_theta_o()).abs() < 1e-9);
    let mut view = settings::<AlbedoSettings>(&window).clone();
    view.spec.channel = Channel::B;
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::set_view(view.clone()));
    window.run_steps(3);
    assert_eq!(*settings::<AlbedoSettings>(&window), view);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn another_material_has_its_own_curve() {
    let mut window = opened();
    let measured = |window: &Window| -> Vec<f64> {
        let state = window.state().state();
        let curves = curves(&state.caches, &Subjects::of(state).list);
        curves[0].points.iter().map(|p| p.rgb[0]).collect()
    };
    let first = measured(&window);
    run(&mut window, Command::OpenSample(1));
    settle(&mut window, |state| state.scene.opened.len() == 2);
    let now = measured(&window);
    assert!(now.is_empty() || now != first, "the other one's curve");
    settle(&mut window, known);
    let second = measured(&window);
    assert!(!second.is_empty() && second != first);
    assert_eq!(
        window.state().state().caches.progress::<MeasuredAlbedo>(),
        None
    );
}
