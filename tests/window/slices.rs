//! The slices in the real window.

use crate::common::window::{Window, click, drag, press, run, settings, wheel, window};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::probe::Probe;
use grazing::app::state::views::ViewId;
use grazing::app::views::slices::settings::SliceSettings;
use grazing::figure::slices::{Over, Residual};

fn opened() -> Window {
    let mut window = window(vec![], vec![]);
    if !has_plot(&window) {
        // Open behind another tile: closed and opened it is in front.
        run(&mut window, Command::ToggleTile(ViewId::Slices));
        run(&mut window, Command::ToggleTile(ViewId::Slices));
    }
    assert!(has_plot(&window));
    window
}

fn has_plot(window: &Window) -> bool {
    window
        .query_by_role_and_label(Role::Image, "Slices")
        .is_some()
}

fn view(window: &Window) -> SliceSettings {
    settings::<SliceSettings>(window).clone()
}

fn set(window: &mut Window, change: impl Fn(&mut SliceSettings)) {
    let mut view = view(window);
    change(&mut view);
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::set_view(view));
    window.run_steps(3);
}

/// A point of the plot in shares of its tile.
fn at(window: &Window, x: f32, y: f32) -> egui::Pos2 {
    let rect = window.get_by_role_and_label(Role::Image, "Slices").rect();
    rect.lerp_inside(egui::vec2(x, y))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_probe_is_what_is_under_the_pointer() {
    let mut window = opened();
    window.hover_at(at(&window, 0.75, 0.5));
    window.run_steps(2);
    let probe = window.state().state().probe().expect("a probe");
    assert!((probe.theta_i().to_degrees() - 60.0).abs() < 1e-6);
    assert!((20.0..80.0).contains(&probe.signed_theta_o().to_degrees()));
    set(&mut window, |view| {
        view.spec.over = Over::ThetaD;
        view.spec.theta_h = 10f64.to_radians();
        view.spec.phi_d = 1.0;
    });
    window.hover_at(at(&window, 0.5, 0.5));
    window.run_steps(2);
    let angles = window.state().state().probe().and_then(Probe::angles);
    let angles = angles.expect("angles");
    assert!((angles.theta_h.to_degrees() - 10.0).abs() < 1e-6);
    assert!((angles.phi_d - 1.0).abs() < 1e-6);
    assert!((30.0..60.0).contains(&angles.theta_d.to_degrees()));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_wheel_zooms_a_drag_pans_and_a_double_click_resets() {
    let mut window = opened();
    let wheel_at = |window: &mut Window, x: f32| {
        window.hover_at(at(window, x, 0.5));
        window.run_steps(1);
        wheel(window, 120.0);
    };
    wheel_at(&mut window, 0.6);
    let [low, high] = view(&window).spec.window.expect("a part");
    assert!(high - low < 0.8 * std::f64::consts::PI);
    assert_eq!(view(&window).spec.limits, None);
    let path = [
        at(&window, 0.6, 0.5),
        at(&window, 0.55, 0.5),
        at(&window, 0.5, 0.5),
    ];
    drag(&mut window, &path);
    let [moved, end] = view(&window).spec.window.expect("a part");
    assert!(moved > low && ((end - moved) - (high - low)).abs() < 1e-6);
    wheel_at(&mut window, 0.005);
    assert!(view(&window).spec.limits.is_some());
    let point = at(&window, 0.6, 0.5);
    for _ in 0..2 {
        window.drag_at(point);
        window.drop_at(point);
        window.run_steps(1);
    }
    window.run_steps(3);
    let spec = view(&window).spec;
    assert_eq!((spec.window, spec.limits), (None, None));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn settings_change_and_undo_takes_them_back() {
    let mut window = opened();
    click(&mut window, "θh");
    assert_eq!(view(&window).spec.over, Over::ThetaH);
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(view(&window).spec.over, Over::ThetaO);
    set(&mut window, |view| view.spec.residual = Residual::Ratio);
    click(&mut window, "+");
    assert_eq!(view(&window).spec.theta_i.len(), 2);
    assert_eq!(view(&window).spec.active, 1);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn slices_follow_a_pinned_probe() {
    let mut window = opened();
    set(&mut window, |view| {
        view.spec.over = Over::ThetaH;
        view.follow = true;
    });
    let ctx = window.ctx.clone();
    let probe = Probe::in_plane(0.9, 0.3);
    window.state_mut().handle(&ctx, Msg::Pin(Some(probe)));
    window.run_steps(3);
    window.state_mut().handle(&ctx, Msg::Pin(None));
    window.run_steps(3);
    window.hover_at(at(&window, 0.3, 0.5));
    window.run_steps(3);
    let found = window.state().state().probe().and_then(Probe::angles);
    let (found, wanted) = (found.expect("angles"), probe.angles().expect("angles"));
    assert!((found.theta_d - wanted.theta_d).abs() < 1e-6);
    assert!(found.theta_h > 0.1);
}
