//! The tiles of the real window: the probe they share, their legends, their places.

use crate::common::window::{Window, drag, press, run, settings, wheel, window};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::state::subject_key::What;
use grazing::app::state::views::ViewId;
use grazing::app::views::lobes::settings::LobeSettings;
use grazing::app::views::sphere::settings::SphereSettings;
use grazing::figure::lobes::LobeScale;

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_click_pins_the_probe_and_copies_its_row() {
    let mut window = window(vec![], vec![]);
    let rect = window
        .get_by_role_and_label(Role::Image, "Polar lobes")
        .rect();
    let at = |dx: f32| rect.center() + egui::vec2(dx, 40.0);
    window.hover_at(at(30.0));
    window.run_steps(2);
    let hovered = window.state().state().probe().expect("a probe");
    assert!(hovered.signed_theta_o() > 0.0);
    drag(&mut window, &[at(30.0), at(30.0)]);
    window.hover_at(at(-60.0));
    window.run_steps(2);
    assert_eq!(window.state().state().probe(), Some(hovered));
    window.event(egui::Event::Copy);
    window.step();
    let copied = window.output().platform_output.commands.clone();
    let row = copied.into_iter().find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text),
        _ => None,
    });
    let row = row.expect("a row");
    let lines: Vec<Vec<&str>> = row.lines().map(|line| line.split('\t').collect()).collect();
    assert_eq!(lines[0].len(), lines[1].len());
    let theta_o = lines[0].iter().position(|name| *name == "theta_o_deg");
    let theta_o: f64 = lines[1][theta_o.expect("named")].parse().expect("degrees");
    assert!((theta_o - hovered.signed_theta_o().to_degrees()).abs() < 1e-5);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().state().pinned, None);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_wheel_enlarges_the_sphere_around_the_pointer() {
    let mut window = window(vec![], vec![]);
    let rect = window.get_by_role_and_label(Role::Image, "Sphere").rect();
    let at = rect.center() + egui::vec2(20.0, -30.0);
    window.hover_at(at);
    window.run_steps(2);
    let sight = |window: &Window| settings::<SphereSettings>(window).sight;
    let probe = |window: &Window| window.state().state().probe().expect("a probe");
    let before = probe(&window);
    wheel(&mut window, 240.0);
    assert!(sight(&window).zoom > 2.0, "{:?}", sight(&window));
    let after = probe(&window);
    assert!(after.wi.angle_between(before.wi) < 1e-3 && after.wo.angle_between(before.wo) < 1e-3);
    // Elsewhere the same step of the pointer is a smaller one on the sphere.
    window.hover_at(at + egui::vec2(30.0, 0.0));
    window.run_steps(2);
    let near = probe(&window).wo.angle_between(before.wo);
    for _ in 0..2 {
        window.drag_at(at);
        window.drop_at(at);
        window.run_steps(1);
    }
    window.run_steps(3);
    assert_eq!(sight(&window).zoom, 1.0);
    window.hover_at(at + egui::vec2(30.0, 0.0));
    window.run_steps(2);
    let far = probe(&window).wo.angle_between(before.wo);
    assert!(far > 2.0 * near, "{far} {near}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_name_in_the_legend_hides_its_curves() {
    let mut window = window(vec![], vec![]);
    let hidden = |window: &Window| window.state().state().scene.hidden.len();
    let click = |window: &mut Window, name: &str| {
        window.get_by_role_and_label(Role::CheckBox, name).click();
        window.run_steps(3);
    };
    let model = "Show Combined";
    click(&mut window, model);
    assert_eq!(hidden(&window), 1);
    // Long enough for the next click to be one of its own.
    window.run_steps(20);
    click(&mut window, model);
    assert_eq!(hidden(&window), 0);
    window.run_steps(20);
    click(&mut window, model);
    click(&mut window, model);
    let state = window.state().state();
    let what: Vec<What> = state.scene.hidden.iter().map(|key| key.what).collect();
    assert_eq!(what, [What::Measured], "alone");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn tiles_close_and_come_back() {
    let mut window = window(vec![], vec![]);
    let toggle = Command::ToggleTile(ViewId::Lobes);
    let lobes = |window: &Window| {
        window
            .query_by_role_and_label(Role::Image, "Polar lobes")
            .is_some()
    };
    assert!(lobes(&window));
    run(&mut window, toggle);
    assert!(!lobes(&window));
    run(&mut window, toggle);
    assert!(lobes(&window));
    run(&mut window, toggle);
    run(&mut window, Command::ResetLayout);
    assert!(lobes(&window));
    window
        .get_by_role_and_label(Role::Button, "Help: Polar lobes")
        .click();
    window.run_steps(3);
    let help = ViewId::Lobes.about().help[0];
    window.get_by_label(help);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_wheel_zooms_the_lobes_and_a_double_click_puts_them_back() {
    let mut window = window(vec![], vec![]);
    run(&mut window, Command::UseScale(LobeScale::CubeRoot));
    let rect = window
        .get_by_role_and_label(Role::Image, "Polar lobes")
        .rect();
    let at = rect.center() + egui::vec2(30.0, 40.0);
    let wheel = |window: &mut Window, by: f32| {
        window.hover_at(at);
        window.run_steps(1);
        window.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: egui::vec2(0.0, by),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        });
        window.run_steps(12);
        let limits = settings::<LobeSettings>(window).limits;
        limits.expect("limits")[1]
    };
    let near = wheel(&mut window, 120.0);
    let far = wheel(&mut window, -240.0);
    // 240 points are a factor of e; on this scale radii are cube roots.
    assert!((far / near / 3f64.exp() - 1.0).abs() < 0.05, "{near} {far}");
    run(&mut window, Command::Undo);
    assert_eq!(
        settings::<grazing::figure::lobes::LobeSpec>(&window)
            .limits
            .map(|ends| ends[1]),
        Some(near)
    );
    for _ in 0..2 {
        window.drag_at(at);
        window.drop_at(at);
        window.run_steps(1);
    }
    window.run_steps(3);
    let state = window.state().state();
    assert_eq!(state.scene.views.get::<LobeSettings>().limits, None);
    assert_eq!(state.pinned, None, "the second click lets go");
}
