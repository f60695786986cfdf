//! The window as pictures. `UPDATE_SNAPSHOTS=1 cargo test --test window look` accepts what is drawn now.

use crate::common::skip_gpu;
use crate::common::window::settle;
use egui_kittest::{Harness, SnapshotOptions};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::prefs::Theme;
use grazing::app::state::probe::Probe;
use grazing::app::views::albedo::work::{MeasuredAlbedo, ModelAlbedo};
use grazing::app::views::error_map::work::ErrorMapQuery;
use grazing::app::views::landscape::work::LandscapeQuery;
use grazing::app::views::sphere::settings::{Show, SphereSettings};
use grazing::app::{App, Options, Picker};
use std::sync::Arc;
use std::time::{Duration, Instant};

fn window(theme: Theme) -> Harness<'static, App> {
    window_of(theme, [1000.0, 640.0])
}

fn window_of(theme: Theme, size: [f32; 2]) -> Harness<'static, App> {
    let picker = Picker {
        open: Arc::new(Vec::new),
        folder: Arc::new(|| None),
        save: Arc::new(|_| None),
    };
    let mut window = Harness::builder()
        .with_size(size)
        .wgpu()
        .build_eframe(|cc| {
            App::new(
                cc,
                Options {
                    files: vec![],
                    picker,
                    autosave: None,
                },
            )
            .expect("a renderer")
        });
    let start = Instant::now();
    while window.state().state().current().is_none() {
        window.step();
        // For a broken program, not a measure.
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "the sample does not load"
        );
        std::thread::sleep(Duration::from_millis(5));
    }
    run(&mut window, Command::UseTheme(theme));
    window
}

fn run(window: &mut Harness<'static, App>, command: Command) {
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::Run(command));
    window.run_steps(4);
}

fn check(window: &mut Harness<'static, App>, name: &str) {
    // An accepted black picture must not pass: the sphere and the lobes have their colours.
    let picture = window.render().expect("a picture");
    let coloured = picture
        .pixels()
        .filter(|p| p[0].abs_diff(p[2]) > 60)
        .count();
    assert!(
        coloured > 20_000,
        "only {coloured} coloured pixels in {name}"
    );
    window.snapshot_options(
        name,
        &SnapshotOptions::new().threshold(0.6).max_failed_pixels(60),
    );
}

#[test]
fn the_dark_window() {
    if skip_gpu() {
        return;
    }
    check(&mut window(Theme::Dark), "window_dark");
}

#[test]
fn the_light_window() {
    if skip_gpu() {
        return;
    }
    check(&mut window(Theme::Light), "window_light");
}

/// Every view side by side, on the sample, the probe pinned so that all mark it.
fn every_view(theme: Theme, name: &str) {
    if skip_gpu() {
        return;
    }
    let mut window = window_of(theme, [2000.0, 1250.0]);
    window.state_mut().tiles_side_by_side();
    let ctx = window.ctx.clone();
    let probe = Probe::in_plane(1.0, 0.7);
    window.state_mut().handle(&ctx, Msg::Pin(Some(probe)));
    settle(&mut window, |state| {
        let caches = &state.caches;
        caches.last::<MeasuredAlbedo>().is_some()
            && caches.last::<ModelAlbedo>().is_some()
            && caches.last::<ErrorMapQuery>().is_some()
            && caches.last::<LandscapeQuery>().is_some()
            && caches.progress::<LandscapeQuery>().is_none()
    });
    check(&mut window, name);
}

#[test]
fn every_view_in_the_dark() {
    every_view(Theme::Dark, "views_dark");
}

#[test]
fn every_view_in_the_light() {
    every_view(Theme::Light, "views_light");
}

#[test]
fn two_spheres_and_logarithmic_lobes() {
    if skip_gpu() {
        return;
    }
    let mut window = window(Theme::Light);
    run(&mut window, Command::UseShow(Show::SideBySide));
    run(
        &mut window,
        Command::UseScale(grazing::figure::scale::RadialScale::Log),
    );
    check(&mut window, "side_by_side_log");
}

#[test]
fn a_turned_light_is_noticed() {
    if skip_gpu() {
        return;
    }
    let mut window = window(Theme::Dark);
    let before = window.render().expect("a picture");
    let mut sphere = window
        .state()
        .state()
        .scene
        .views
        .get::<SphereSettings>()
        .clone();
    let light = &mut sphere.view.lights[0].direction;
    *light = (*light + 0.05 * glam::DVec3::X).normalize();
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::set_view(sphere));
    window.run_steps(4);
    let after = window.render().expect("a picture");
    let changed = before
        .pixels()
        .zip(after.pixels())
        .filter(|(a, b)| a != b)
        .count();
    assert!(
        changed > 5_000,
        "a light turned by 0.05 changes {changed} pixels"
    );
}
