//! The image slice in the real window.

use crate::common::window::{Window, drag, run, settings, wheel, window};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::probe::Probe;
use grazing::app::state::views::ViewId;
use grazing::app::views::image::settings::ImageSettings;
use grazing::app::views::slices::settings::SliceSettings;
use grazing::figure::heatmap::{HeatFrame, HeatMap};
use grazing::figure::shown::Shown;
use grazing::figure::subject::Source;
use grazing::geom::HalfDiff;

fn open(window: &mut Window) {
    // Closed and opened again it is in front.
    run(window, Command::ToggleTile(ViewId::Image));
    run(window, Command::ToggleTile(ViewId::Image));
}

fn rect(window: &Window) -> egui::Rect {
    window
        .get_by_role_and_label(Role::Image, "Image slice")
        .rect()
}

/// Where values are in the tile: the figure that it draws, made again.
fn frame(window: &Window) -> HeatFrame {
    let state = window.state().state();
    let (material, opened) = state.current().expect("a material");
    let measured = Source::Measured(material.table.clone(), state.scene.lookup);
    let model = Source::Model(opened.brdf);
    let spec = state.scene.views.get::<ImageSettings>().clone();
    let field = spec.field(Some(&measured), Some(&model));
    let heat = spec.heat_spec(&material.name, &field, &field);
    HeatMap::new(&heat, &field, rect(window).size().into()).frame
}

fn on_screen(window: &Window, at: [f64; 2]) -> egui::Pos2 {
    rect(window).min + egui::Vec2::from(frame(window).point(at))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_cell_under_the_pointer_is_the_probe() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    for at in [[20.0, 50.0], [3.0, 10.0]] {
        let point = on_screen(&window, at);
        window.hover_at(point);
        window.run_steps(2);
        let angles = window.state().state().probe().and_then(Probe::angles);
        let angles = angles.expect("a probe");
        assert!((angles.theta_h.to_degrees() - at[0]).abs() < 0.05);
        assert!((angles.theta_d.to_degrees() - at[1]).abs() < 0.05);
        assert!((angles.phi_d.to_degrees() - 90.0).abs() < 1e-6);
    }
    // Below the horizon there is no probe.
    window.hover_at(on_screen(&window, [88.0, 88.0]));
    window.run_steps(2);
    let probe = window.state().state().probe();
    assert!(probe.is_some(), "at φd = 90° all is above");
    let mut view = settings::<ImageSettings>(&window).clone();
    view.phi_d = 0.0;
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::set_view(view));
    window.run_steps(3);
    assert_eq!(window.state().state().probe(), None);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_click_pins_and_a_probe_from_elsewhere_is_marked() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    let point = on_screen(&window, [30.0, 40.0]);
    drag(&mut window, &[point, point]);
    let pinned = window.state().state().pinned.expect("pinned");
    let angles = pinned.angles().expect("angles");
    assert!((angles.theta_d.to_degrees() - 40.0).abs() < 0.05);
    let slices = &settings::<SliceSettings>(&window).spec;
    assert!((slices.theta_h.to_degrees() - 30.0).abs() < 0.05);
    assert!((slices.theta_d.to_degrees() - 40.0).abs() < 0.05);
    assert_eq!(slices.phi_d, settings::<ImageSettings>(&window).phi_d);
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::Pin(None));
    window.hover_at(egui::pos2(3.0, 3.0));
    window.run_steps(3);
    let before = window.render().expect("a picture");
    let elsewhere = HalfDiff {
        theta_h: 0.2,
        theta_d: 1.0,
        phi_d: 0.3,
    };
    let probe = Probe::from_angles(elsewhere).expect("above");
    window.state_mut().handle(&ctx, Msg::Pin(Some(probe)));
    window.run_steps(3);
    let after = window.render().expect("a picture");
    let changed = |at: [f64; 2]| {
        let [x, y]: [f32; 2] = on_screen(&window, at).into();
        let pixels = (-4..=4).flat_map(|dx| (-4..=4).map(move |dy| (dx, dy)));
        let pixels = pixels.map(|(dx, dy)| ((x as i32 + dx) as u32, (y as i32 + dy) as u32));
        pixels
            .filter(|(x, y)| before.get_pixel(*x, *y) != after.get_pixel(*x, *y))
            .count()
    };
    assert!(changed([0.2f64.to_degrees(), 1f64.to_degrees()]) > 10);
    assert_eq!(changed([60.0, 20.0]), 0, "planted: not there");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn settings_zoom_and_reset() {
    let mut window = window(vec![], vec![]);
    open(&mut window);
    // The sphere has buttons of these names too.
    run(&mut window, Command::ToggleTile(ViewId::Sphere));
    window.get_by_role_and_label(Role::Button, "Ratio").click();
    window.run_steps(3);
    assert_eq!(settings::<ImageSettings>(&window).shown, Shown::Ratio);
    run(&mut window, Command::Undo);
    assert_eq!(settings::<ImageSettings>(&window).shown, Shown::Measured);
    let at = [20.0, 50.0];
    let point = on_screen(&window, at);
    window.hover_at(point);
    window.step();
    wheel(&mut window, 200.0);
    let view = settings::<ImageSettings>(&window).view;
    assert!(view.x.1 - view.x.0 < 0.8, "{view:?}");
    // What was under the pointer still is.
    let now = on_screen(&window, at);
    assert!((now - point).length() < 1.5, "{now} {point}");
    drag(&mut window, &[point, point + egui::vec2(40.0, 0.0)]);
    let moved = on_screen(&window, at);
    assert!(
        (moved - point - egui::vec2(40.0, 0.0)).length() < 8.0,
        "{moved} {point}"
    );
}
