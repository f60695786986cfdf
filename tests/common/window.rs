//! Driving the real window by accessible names.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::State;
use grazing::app::{App, Options, Picker};
use grazing::brdf::ParamId;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

pub type Window = Harness<'static, App>;

pub fn window(files: Vec<PathBuf>, to_open: Vec<PathBuf>) -> Window {
    let picker = Picker {
        open: Arc::new(move || to_open.clone()),
        folder: Arc::new(|| None),
        save: Arc::new(|_| None),
    };
    window_with(files, picker)
}

/// A window whose dialogs are answered by this.
pub fn window_with(files: Vec<PathBuf>, picker: Picker) -> Window {
    window_of(Options {
        files,
        picker,
        autosave: None,
    })
}

/// A window that starts like this.
pub fn window_of(options: Options) -> Window {
    let mut window = Harness::builder()
        .with_size([1280.0, 800.0])
        .with_step_dt(0.03)
        .with_theme(egui::Theme::Dark)
        .wgpu()
        .build_eframe(move |cc| App::new(cc, options).expect("a renderer"));
    settle(&mut window, |state| state.jobs.is_empty());
    window
}

/// Steps until the state is as wanted. The limit is for a broken program, not a measure.
pub fn settle(window: &mut Window, wanted: impl Fn(&State) -> bool) {
    let start = Instant::now();
    loop {
        window.step();
        if wanted(window.state().state()) {
            break;
        }
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "{:?}",
            window.state().state().notices
        );
        std::thread::sleep(Duration::from_millis(5));
    }
    window.run_steps(3);
}

pub fn s(window: &Window) -> f64 {
    value(window, ParamId::S)
}

pub fn value(window: &Window, id: ParamId) -> f64 {
    let state = window.state().state();
    state.current().expect("a material").1.brdf.params.get(id)[0]
}

pub fn click(window: &mut Window, name: &str) {
    window.get_by_role_and_label(Role::Button, name).click();
    window.run_steps(3);
}

pub fn set_slider(window: &mut Window, name: &str, to: f64) {
    window
        .get_by_role_and_label(Role::Slider, name)
        .set_value_accesskit(to);
    window.run_steps(3);
}

/// Drags with the pointer along these points.
pub fn drag(window: &mut Window, path: &[egui::Pos2]) {
    let [from, via @ .., to] = path else {
        panic!("a drag has a start and an end")
    };
    window.drag_at(*from);
    window.run_steps(2);
    for point in via.iter().chain([to]) {
        window.hover_at(*point);
        window.run_steps(2);
    }
    window.drop_at(*to);
    window.run_steps(3);
}

/// Turns the wheel by so many points where the pointer is, and lets the turn die away.
pub fn wheel(window: &mut Window, points: f32) {
    window.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, points),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    window.run_steps(20);
}

pub fn press(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run_steps(3);
}

/// Runs a command as a menu does.
pub fn run(window: &mut Window, command: Command) {
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::Run(command));
    window.run_steps(3);
}
