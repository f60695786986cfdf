//! The window as pictures. `UPDATE_SNAPSHOTS=1 cargo test --test window look` accepts what is drawn now.

use crate::common::window::{Window, run, send, settings, settle, with_answers};
use egui_kittest::{Harness, SnapshotOptions};
use grazing::app::App;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::layout::Tiles;
use grazing::app::state::prefs::Theme;
use grazing::app::state::probe::Probe;
use grazing::app::views::albedo::work::{MeasuredAlbedo, ModelAlbedo};
use grazing::app::views::disc::work::DiscQuery;
use grazing::app::views::error_map::work::ErrorMapQuery;
use grazing::app::views::landscape::work::LandscapeQuery;
use grazing::app::views::sphere::settings::{Show, SphereSettings};

fn window(theme: Theme) -> Window {
    window_of(theme, [1280.0, 800.0])
}

fn window_of(theme: Theme, size: [f32; 2]) -> Window {
    let mut window = Harness::builder()
        .with_size(size)
        .wgpu()
        .build_eframe(|cc| App::new(cc, with_answers(&[], None, None)).expect("a renderer"));
    settle(&mut window, |state| state.current().is_some());
    run(&mut window, Command::UseTheme(theme));
    window
}

fn check(window: &mut Window, name: &str) {
    // An accepted black picture must not pass: the sphere and the lobes have their colours.
    let picture = window.render().expect("a picture");
    let coloured = picture
        .pixels()
        .filter(|p| p[0].abs_diff(p[2]) > 60)
        .count();
    assert!(
        coloured > 12_000,
        "only {coloured} coloured pixels in {name}"
    );
    window.snapshot_options(
        name,
        &SnapshotOptions::new().threshold(0.6).max_failed_pixels(60),
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_dark_window() {
    check(&mut window(Theme::Dark), "window_dark");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_light_window() {
    check(&mut window(Theme::Light), "window_light");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_laptop_s_window() {
    check(
        &mut window_of(Theme::Light, [960.0, 540.0]),
        "window_960x540",
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_large_window() {
    let mut window = window_of(Theme::Dark, [1920.0, 1080.0]);
    check(&mut window, "window_1920x1080");
}

/// Every view side by side, on the sample, the probe pinned so that all mark it.
fn every_view(theme: Theme, name: &str) {
    let mut window = window_of(theme, [2000.0, 1250.0]);
    send(&mut window, Msg::SetLayout(Tiles::side_by_side()));
    let ctx = window.ctx.clone();
    let probe = Probe::in_plane(1.0, 0.7);
    window.state_mut().handle(&ctx, Msg::Pin(Some(probe)));
    settle(&mut window, |state| {
        let caches = &state.caches;
        caches.last::<MeasuredAlbedo>().is_some()
            && caches.last::<ModelAlbedo>().is_some()
            && caches.last::<DiscQuery>().is_some()
            && caches.last::<ErrorMapQuery>().is_some()
            && caches.last::<LandscapeQuery>().is_some()
            && caches.progress::<LandscapeQuery>().is_none()
    });
    check(&mut window, name);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn every_view_in_the_dark() {
    every_view(Theme::Dark, "views_dark");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn every_view_in_the_light() {
    every_view(Theme::Light, "views_light");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn two_spheres_and_logarithmic_lobes() {
    let mut window = window(Theme::Light);
    run(&mut window, Command::UseShow(Show::SideBySide));
    run(
        &mut window,
        Command::UseScale(grazing::figure::lobes::LobeScale::Log),
    );
    check(&mut window, "side_by_side_log");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_turned_light_is_noticed() {
    let mut window = window(Theme::Dark);
    let before = window.render().expect("a picture");
    let mut sphere = settings::<SphereSettings>(&window).clone();
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
