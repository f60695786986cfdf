//! The lobes in space in the real window.

use crate::common::window::{Window, drag, run, send, settings, settle, window};
use egui::Rect;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::probe::Probe;
use grazing::app::state::views::ViewId;
use grazing::app::views::lobe3d::settings::Lobe3dSettings;
use grazing::figure::lobe3d::Camera;
use grazing::figure::scale::RadialScale;
use grazing::geom::direction;

/// A window with this tile in front.
fn opened() -> Window {
    let mut window = window(vec![], vec![]);
    settle(&mut window, |state| state.current().is_some());
    send(&mut window, Msg::Run(Command::ToggleTile(ViewId::Lobe3d)));
    if window
        .query_by_role_and_label(Role::Image, "3D lobe")
        .is_none()
    {
        // It was open behind another one.
        run(&mut window, Command::ToggleTile(ViewId::Lobe3d));
    }
    window
}

fn rect(window: &Window) -> Rect {
    window.get_by_role_and_label(Role::Image, "3D lobe").rect()
}

fn view(window: &Window) -> Lobe3dSettings {
    *settings::<Lobe3dSettings>(window)
}

/// The picture of the tile.
fn pixels(window: &mut Window) -> Vec<[u8; 4]> {
    let rect = rect(window);
    let picture = window.render().expect("a picture");
    let inside = |x: u32, y: u32| rect.contains(egui::pos2(x as f32 + 0.5, y as f32 + 0.5));
    let pixels = picture.enumerate_pixels();
    pixels
        .filter(|(x, y, _)| inside(*x, *y))
        .map(|(_, _, pixel)| pixel.0)
        .collect()
}

fn differing(a: &[[u8; 4]], b: &[[u8; 4]]) -> usize {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_drag_turns_the_lobe_and_a_double_click_puts_it_back() {
    let mut window = opened();
    let center = rect(&window).center();
    let before = pixels(&mut window);
    assert!(before.iter().filter(|p| **p != before[0]).count() > 5000);
    drag(&mut window, &[center, center + egui::vec2(70.0, 20.0)]);
    window.hover_at(egui::Pos2::ZERO);
    window.run_steps(3);
    assert_ne!(view(&window).camera, Camera::default());
    let turned = pixels(&mut window);
    assert!(
        differing(&before, &turned) > 2000,
        "it turned on screen as well"
    );
    run(&mut window, Command::Undo);
    assert_eq!(view(&window).camera, Camera::default());
    assert_eq!(differing(&before, &pixels(&mut window)), 0);
    drag(&mut window, &[center, center + egui::vec2(70.0, 20.0)]);
    let corner = rect(&window).left_bottom() + egui::vec2(12.0, -12.0);
    for _ in 0..2 {
        window.drag_at(corner);
        window.step();
        window.drop_at(corner);
        window.step();
    }
    window.run_steps(2);
    assert_eq!(view(&window).camera, Camera::default());
}

/// Points at the lobes, upwards along a line a little left of their foot: first comes what is in front.
fn hover_the_front(window: &mut Window) -> Probe {
    let bottom = rect(window).center_bottom() + egui::vec2(-6.0, -4.0);
    let found = (0..120).find_map(|k| {
        window.hover_at(bottom - egui::vec2(0.0, 2.0 * k as f32));
        window.run_steps(2);
        window.state().state().hovered
    });
    found.expect("there is a lobe")
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_probe_goes_round() {
    let mut window = opened();
    let blank = pixels(&mut window);
    let hovered = hover_the_front(&mut window);
    assert!((hovered.theta_i().to_degrees() - 45.0).abs() < 1e-6);
    assert!(hovered.wi.x < 0.0 && hovered.wo.y < 0.0 && hovered.wo.z > 0.0);
    assert!(differing(&blank, &pixels(&mut window)) > 40, "it is marked");

    window.hover_at(egui::Pos2::ZERO);
    window.run_steps(3);
    assert_eq!(window.state().state().probe(), None);
    assert_eq!(differing(&blank, &pixels(&mut window)), 0);

    // From elsewhere, with the light from another side: the lobe is that of its light.
    let probe = Probe {
        wi: direction(1.1, 0.7),
        wo: direction(0.4, 2.0),
    };
    send(&mut window, Msg::Pin(Some(probe)));
    assert!(differing(&blank, &pixels(&mut window)) > 1000);
    let hovered = hover_the_front(&mut window);
    assert!((hovered.theta_i() - 1.1).abs() < 1e-9);
    assert_eq!(window.state().state().probe(), Some(probe), "pinned");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn settings_change_the_picture() {
    let mut window = opened();
    let before = pixels(&mut window);
    let logarithmic = Lobe3dSettings {
        scale: RadialScale::Log,
        ..view(&window)
    };
    send(&mut window, Msg::set_view(logarithmic));
    let changed = pixels(&mut window);
    assert!(differing(&before, &changed) > 2000);
    send(&mut window, Msg::Run(Command::Undo));
    assert_eq!(differing(&before, &pixels(&mut window)), 0);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn it_repaints_nothing_while_nothing_happens() {
    let mut window = opened();
    window.run_steps(30);
    let output = window.output();
    let delay = output
        .viewport_output
        .values()
        .map(|output| output.repaint_delay)
        .min();
    assert!(
        delay.is_some_and(|delay| delay > std::time::Duration::from_secs(3600)),
        "{delay:?}"
    );
}
