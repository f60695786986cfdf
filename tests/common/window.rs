//! Driving the real window by accessible names.

use super::font::font;
use super::wait;
use eframe::App as _;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use egui_kittest::{Harness, HarnessBuilder};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::session::{Close, SessionMsg};
use grazing::app::session::file::SessionFile;
use grazing::app::state::State;
use grazing::app::state::layout::Tiles;
use grazing::app::state::prefs::{FitOnOpening, Prefs};
use grazing::app::state::view_settings::Settings;
use grazing::app::{App, Picker, WindowOptions};
use grazing::brdf::ParamId;
use grazing::export::fonts::look_in;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Once};

pub type Window = Harness<'static, App>;

/// A window with these files, whose dialog for opening answers with those.
pub fn window(files: Vec<PathBuf>, to_open: Vec<PathBuf>) -> Window {
    let picker = Picker {
        open: Arc::new(move || to_open.clone()),
        ..nothing_picked()
    };
    window_with(files, picker)
}

/// Preferences of a window whose materials stay as they were guessed until a test asks for a fit.
pub fn not_fitted_on_opening() -> Prefs {
    Prefs {
        fit_on_opening: FitOnOpening(false),
        ..Prefs::default()
    }
}

/// Dialogs that are closed without an answer.
pub fn nothing_picked() -> Picker {
    Picker {
        ready: Arc::new(|| Ok(())),
        open: Arc::new(Vec::new),
        folder: Arc::new(|| None),
        save: Arc::new(|_| None),
    }
}

/// A window whose dialogs are answered by this.
pub fn window_with(files: Vec<PathBuf>, picker: Picker) -> Window {
    window_of(WindowOptions {
        files,
        picker,
        autosave: None,
        prefs: not_fitted_on_opening(),
        notice: None,
    })
}

/// The start of a window with these files, whose dialogs answer with these paths.
pub fn with_answers(files: &[&Path], open: Option<&Path>, save: Option<&Path>) -> WindowOptions {
    let [open, save] = [open, save].map(|path| path.map(Path::to_owned));
    WindowOptions {
        files: files.iter().map(|file| file.to_path_buf()).collect(),
        picker: Picker {
            open: Arc::new(move || open.clone().into_iter().collect()),
            save: Arc::new(move |_| save.clone()),
            ..nothing_picked()
        },
        autosave: None,
        prefs: not_fitted_on_opening(),
        notice: None,
    }
}

/// A window that starts like this.
pub fn window_of(options: WindowOptions) -> Window {
    built(Harness::builder(), options)
}

/// The same, where texts may have characters that the fonts of the window lack: boxes stand for them until a font is found,
/// as in the program. Elsewhere such a character fails the test.
pub fn window_with_boxes(options: WindowOptions) -> Window {
    built(Harness::builder().allow_missing_glyphs(), options)
}

/// Fonts that are found are these and not those of the machine.
fn find_no_other_fonts() {
    static WRITTEN: Once = Once::new();
    WRITTEN.call_once(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fonts of windows");
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join("plantation.ttf"), font()).expect("is written");
        look_in(folder);
    });
}

fn built(builder: HarnessBuilder<App>, options: WindowOptions) -> Window {
    find_no_other_fonts();
    let mut window = builder
        .with_size([1280.0, 800.0])
        .with_step_dt(0.03)
        .with_theme(egui::Theme::Dark)
        .wgpu()
        .build_eframe(move |cc| App::new(cc, options).expect("a renderer"));
    settle(&mut window, |state| state.jobs.is_empty());
    window
}

/// Steps until the state is as wanted.
#[track_caller]
pub fn settle(window: &mut Window, wanted: impl Fn(&State) -> bool) {
    settle_on(window, |window| {
        wanted(window.state().state()).then_some(())
    });
    window.run_steps(3);
}

/// Steps until this is found in the window, and leaves it at that step.
#[track_caller]
pub fn settle_on<T>(window: &mut Window, mut look: impl FnMut(&Window) -> Option<T>) -> T {
    wait::settle(|| {
        window.step();
        look(window).ok_or_else(|| format!("{:?}", window.state().state().notices))
    })
}

/// What a view is set to show.
pub fn settings<T: Settings>(window: &Window) -> &T {
    window.state().state().scene.views.get()
}

pub fn s(window: &Window) -> f64 {
    value(window, ParamId("s"))
}

pub fn value(window: &Window, id: ParamId) -> f64 {
    let state = window.state().state();
    state.current().expect("a material").1.brdf.get(id)[0]
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

/// Hands the state a message as a panel does.
pub fn send(window: &mut Window, msg: Msg) {
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, msg);
    window.run_steps(3);
}

/// Runs a command as a menu does.
pub fn run(window: &mut Window, command: Command) {
    send(window, Msg::Run(command));
}

/// A window that keeps what is open in this folder. Without tiles, as only time must pass.
pub fn kept_in(folder: &Path, files: &[&Path]) -> Window {
    let mut window = window_of(WindowOptions {
        autosave: Some(folder.to_owned()),
        ..with_answers(files, None, None)
    });
    send(&mut window, Msg::SetLayout(Tiles::none()));
    window
}

/// Closes a window for good; what it had open is not wanted.
pub fn close(mut window: Window) {
    let discard = SessionMsg::Close(Close::Discard);
    send(&mut window, Msg::Session(discard));
    window.state_mut().on_exit();
}

/// The session of the window as it would be saved.
pub fn data(window: &Window) -> String {
    SessionFile::of(window.state().state())
        .text()
        .expect("JSON")
}

/// Names of the open materials.
pub fn names(state: &State) -> Vec<&str> {
    let opened = state.scene.opened.iter();
    opened
        .map(|one| state.materials[&one.id].name.as_str())
        .collect()
}

/// A notice with these words.
#[track_caller]
pub fn said<'a>(state: &'a State, words: &str) -> &'a str {
    let found = state
        .notices
        .iter()
        .find(|notice| notice.text.contains(words));
    let notice = found.unwrap_or_else(|| panic!("{words}: {:?}", state.notices));
    assert_eq!(notice.text.lines().count(), 1);
    &notice.text
}
