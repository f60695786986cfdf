//! One probe through every view of the real window: each sets it, all others mark it.

use crate::common::window::{Window, run, send, settle, window};
use egui::accesskit::Role;
use egui::{Pos2, Rect};
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::cache::stop;
use grazing::app::state::layout::Tiles;
use grazing::app::state::probe::Probe;
use grazing::app::views::albedo::work::{MeasuredAlbedo, ModelAlbedo};
use grazing::app::views::disc::work::DiscQuery;
use grazing::app::views::error_map::work::ErrorMapQuery;
use grazing::app::views::landscape::work::LandscapeQuery;
use image::RgbaImage;
use std::collections::HashMap;
use std::time::Duration;

/// The views that have directions in them, by the names of their pictures.
const VIEWS: [&str; 8] = [
    "Sphere",
    "Polar lobes",
    "Slices",
    "Albedo",
    "3D lobe",
    "Image slice",
    "Disc",
    "Error map",
];
/// Those that have none.
const OTHERS: [&str; 2] = ["Error landscape", "Scatter"];

/// A window with every tile in sight and nothing under way, one light on the sphere.
fn opened() -> Window {
    let mut window = window(vec![], vec![]);
    window.set_size(egui::vec2(1900.0, 1300.0));
    send(&mut window, Msg::SetLayout(Tiles::side_by_side()));
    // They would take a while, and the probe is marked without them.
    window.run_steps(2);
    send(&mut window, stop::<LandscapeQuery>());
    send(&mut window, stop::<MeasuredAlbedo>());
    run(&mut window, Command::UseLights(1));
    settle(&mut window, |state| {
        let caches = &state.caches;
        caches.last::<ErrorMapQuery>().is_some()
            && caches.last::<DiscQuery>().is_some()
            && caches.last::<ModelAlbedo>().is_some()
            && caches.progress::<MeasuredAlbedo>().is_none()
            && caches.progress::<LandscapeQuery>().is_none()
    });
    away(&mut window);
    window
}

fn away(window: &mut Window) {
    window.hover_at(egui::pos2(2.0, 2.0));
    window.run_steps(3);
}

fn rect(window: &Window, view: &str) -> Rect {
    window.get_by_role_and_label(Role::Image, view).rect()
}

/// The places in a view where two pictures of the window differ.
fn changed(window: &Window, view: &str, a: &RgbaImage, b: &RgbaImage) -> Vec<Pos2> {
    let rect = rect(window, view).shrink(1.0);
    let pixels = a.enumerate_pixels().zip(b.pixels());
    pixels
        .filter(|((_, _, a), b)| a != b)
        .map(|((x, y, _), _)| egui::pos2(x as f32 + 0.5, y as f32 + 0.5))
        .filter(|at| rect.contains(*at))
        .collect()
}

fn picture(window: &mut Window) -> RgbaImage {
    window.render().expect("a picture")
}

/// The probe under the pointer at the first of some points of a view where there is one.
fn hover(window: &mut Window, view: &str) -> Probe {
    let rect = rect(window, view);
    let shares = [
        [0.6, 0.4],
        [0.45, 0.55],
        [0.52, 0.75],
        [0.5, 0.85],
        [0.4, 0.7],
    ];
    let found = shares.into_iter().find_map(|[x, y]| {
        window.hover_at(rect.lerp_inside(egui::vec2(x, y)));
        window.run_steps(2);
        window.state().state().hovered
    });
    found.unwrap_or_else(|| panic!("{view} sets no probe"))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_one_view_points_at_all_others_mark() {
    let mut window = opened();
    let blank = picture(&mut window);
    for from in VIEWS {
        let probe = hover(&mut window, from);
        send(&mut window, Msg::Pin(Some(probe)));
        away(&mut window);
        assert_eq!(window.state().state().probe(), Some(probe));
        let marked = picture(&mut window);
        for view in VIEWS {
            let count = changed(&window, view, &blank, &marked).len();
            assert!(
                count > 12,
                "{view} does not mark the probe of {from}: {count}"
            );
        }
        for view in OTHERS {
            assert_eq!(changed(&window, view, &blank, &marked).len(), 0, "{view}");
        }
        send(&mut window, Msg::Pin(None));
        away(&mut window);
        let again = picture(&mut window);
        for view in VIEWS {
            let left = changed(&window, view, &blank, &again).len();
            assert_eq!(left, 0, "{view} keeps a mark of {from}");
        }
    }
}

/// Where most of some numbers are.
fn mode(values: impl Iterator<Item = f32>) -> f32 {
    let mut counts: HashMap<i32, usize> = HashMap::new();
    for value in values {
        *counts.entry(value as i32).or_default() += 1;
    }
    let most = counts
        .into_iter()
        .max_by_key(|(value, count)| (*count, *value));
    most.expect("a mark").0 as f32 + 0.5
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_mark_is_where_its_angles_are() {
    let mut window = opened();
    let blank = picture(&mut window);
    let probe = Probe::in_plane(50f64.to_radians(), 35f64.to_radians());
    send(&mut window, Msg::Pin(Some(probe)));
    away(&mut window);
    let marked = picture(&mut window);
    let wanted = probe.angles().expect("angles");
    let theta_h = |probe: Probe| probe.angles().expect("angles").theta_h;
    let theta_d = |probe: Probe| probe.angles().expect("angles").theta_d;
    // Lines and crosses go through the mark; a dot alone is around it.
    let (theta_i, theta_o) = (probe.theta_i(), probe.signed_theta_o());
    type Angle<'a> = &'a dyn Fn(Probe) -> f64;
    let cases: [(&str, Angle, f64, f64); 8] = [
        ("Sphere", &theta_h, wanted.theta_h, 2.0),
        ("Slices", &Probe::signed_theta_o, theta_o, 0.8),
        ("Albedo", &Probe::theta_i, theta_i, 0.8),
        ("Image slice", &theta_h, wanted.theta_h, 0.8),
        ("Image slice", &theta_d, wanted.theta_d, 0.8),
        ("Disc", &Probe::signed_theta_o, theta_o, 3.0),
        ("Error map", &Probe::theta_i, theta_i, 1.5),
        ("Error map", &Probe::signed_theta_o, theta_o, 1.5),
    ];
    for (view, of, wanted, within_deg) in cases {
        let places = changed(&window, view, &blank, &marked);
        let along = |at: fn(&Pos2) -> f32| {
            let all = || places.iter().map(at);
            match view {
                "Sphere" | "Disc" => {
                    0.5 * (all().fold(f32::MAX, f32::min) + all().fold(f32::MIN, f32::max))
                }
                _ => mode(all()),
            }
        };
        let (column, row) = (along(|at| at.x), along(|at| at.y));
        let mut off = |shift: f32| -> f64 {
            window.hover_at(egui::pos2(column + shift, row - shift));
            window.run_steps(2);
            let found = window.state().state().hovered;
            let found = found.unwrap_or_else(|| panic!("{view} has no probe at its mark"));
            (of(found) - wanted).abs().to_degrees()
        };
        let distance = off(0.0);
        assert!(distance < within_deg, "{view} is off by {distance}°");
        // Planted: a mark elsewhere.
        assert!(off(25.0) > within_deg, "{view}");
    }
}

fn repaint_delay(window: &Window) -> Duration {
    let outputs = window.output().viewport_output.values();
    let delays = outputs.map(|output| output.repaint_delay);
    delays.min().expect("a viewport")
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn with_every_tile_an_idle_window_repaints_nothing() {
    let mut window = opened();
    let hour = Duration::from_secs(3600);
    for pinned in [None, Some(Probe::in_plane(0.8, 0.5))] {
        send(&mut window, Msg::Pin(pinned));
        window.run_steps(20);
        assert!(repaint_delay(&window) > hour, "{pinned:?}");
    }
    // Planted: a pointer that moves is followed by a frame.
    window.hover_at(rect(&window, "Polar lobes").center());
    window.step();
    assert!(repaint_delay(&window) < hour);
}
