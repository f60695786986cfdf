//! The disc in the real window.

use crate::common::window::{Window, drag, run, send, settings, settle, wheel, window};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::sources::Sources;
use grazing::app::state::views::ViewId;
use grazing::app::views::disc::settings::DiscSettings;
use grazing::app::views::disc::work::DiscQuery;
use grazing::figure::disc::{DiscFrame, DiscPlot};
use grazing::figure::shown::Shown;
use grazing::geom::direction;
use std::f64::consts::PI;

/// Waits until the picture is that of the settings.
fn open(window: &mut Window) {
    // Closed and opened again it is in front.
    run(window, Command::ToggleTile(ViewId::Disc));
    run(window, Command::ToggleTile(ViewId::Disc));
    settle(window, |state| state.caches.last::<DiscQuery>().is_some());
    window.run_steps(2);
}

fn rect(window: &Window) -> egui::Rect {
    window.get_by_role_and_label(Role::Image, "Disc").rect()
}

/// Where directions are in the tile: the figure that it draws, made again.
fn frame(window: &Window) -> DiscFrame {
    let state = window.state().state();
    let (material, _) = state.current().expect("a material");
    let spec = settings::<DiscSettings>(window);
    let Sources { measured, model } = Sources::of(state);
    let field = spec.field(measured.as_ref(), model.as_ref(), 256);
    DiscPlot::new(spec, &material.name, &field, rect(window).size().into()).frame
}

fn at(window: &Window, theta: f64, phi: f64) -> egui::Pos2 {
    rect(window).min + egui::Vec2::from(frame(window).point(direction(theta, phi)))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_direction_under_the_pointer_is_the_probe_and_a_click_pins_it() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    for (theta, phi) in [(0.5, 1.0), (1.2, 5.0)] {
        let point = at(&window, theta, phi);
        window.hover_at(point);
        window.run_steps(2);
        let probe = window.state().state().probe().expect("a probe");
        assert!((probe.wo - direction(theta, phi)).length() < 0.01);
        assert!((probe.wi - direction(PI / 3.0, PI)).length() < 1e-9);
    }
    let point = at(&window, 0.5, 1.0);
    drag(&mut window, &[point, point]);
    assert!(window.state().state().pinned.is_some());
    // Outside the disc there is nothing to pin and nothing to read.
    let outside = rect(&window).left_bottom() + egui::vec2(3.0, -3.0);
    send(&mut window, Msg::Pin(None));
    drag(&mut window, &[outside, outside]);
    window.hover_at(outside);
    window.run_steps(2);
    assert_eq!(window.state().state().probe(), None);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_drag_moves_the_light_in_one_step_of_undo() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    let from = at(&window, PI / 3.0, PI);
    let to = at(&window, 0.4, 0.5 * PI);
    drag(&mut window, &[from, from + 0.5 * (to - from), to]);
    let settings_now = settings::<DiscSettings>(&window);
    assert!(
        (settings_now.theta_i - 0.4).abs() < 0.03,
        "{settings_now:?}"
    );
    assert!(
        (settings_now.phi_i - 0.5 * PI).abs() < 0.06,
        "{settings_now:?}"
    );
    // The picture follows.
    let wanted = settings_now.phi_i;
    settle(&mut window, |state| {
        let last = state.caches.last::<DiscQuery>();
        last.is_some_and(|(query, _)| query.spec.phi_i == wanted)
    });
    run(&mut window, Command::Undo);
    assert_eq!(*settings::<DiscSettings>(&window), DiscSettings::default());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_wheel_zooms_the_values_and_a_double_click_puts_all_back() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    let point = at(&window, 0.5, 1.0);
    window.hover_at(point);
    window.step();
    wheel(&mut window, 200.0);
    let near = settings::<DiscSettings>(&window).limits.expect("ends");
    wheel(&mut window, 200.0);
    let nearer = settings::<DiscSettings>(&window).limits.expect("ends");
    assert!(nearer[1] < near[1], "{near:?} {nearer:?}");
    for shown in [Shown::Residual, Shown::Ratio] {
        let set = DiscSettings {
            shown,
            ..DiscSettings::default()
        };
        send(&mut window, Msg::set_view(set));
        window.hover_at(point);
        window.run_steps(3);
        wheel(&mut window, 200.0);
        assert!(
            settings::<DiscSettings>(&window).limits.is_some(),
            "{shown:?}"
        );
    }
    drag(&mut window, &[point, point]);
    drag(&mut window, &[point, point]);
    window.run_steps(2);
    let back = settings::<DiscSettings>(&window);
    assert_eq!((back.limits, back.theta_i), (None, PI / 3.0));
}
