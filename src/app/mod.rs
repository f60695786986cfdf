//! The window: egui over the state. Panels and views read the state and push messages; [`reduce::apply`] changes it.

pub mod command;
pub mod guide;
pub mod jobs;
pub mod lessons;
pub mod msg;
pub mod panels;
pub mod paper;
pub mod reduce;
pub mod session;
pub mod startup;
pub mod state;
mod tasks;
pub mod views;
pub mod widgets;

use crate::app::command::ENTRIES;
use crate::app::jobs::autosave::Autosave;
use crate::app::jobs::fonts::LackingLetters;
use crate::app::jobs::sender::Sender;
use crate::app::jobs::{Jobs, prepare_threads};
use crate::app::msg::session::SessionMsg;
use crate::app::msg::{Msg, Task};
use crate::app::panels::tiles::tiles_ui;
use crate::app::panels::{dialogs, lesson, menu, notices, sides, status};
use crate::app::reduce::apply;
use crate::app::state::State;
use crate::app::state::layout::Tiles;
use crate::app::state::notice::Severity;
use crate::app::state::prefs::{Prefs, Theme, Zoom};
use crate::app::tasks::Tools;
use egui::{Key, KeyboardShortcut, Modifiers};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::Receiver;
use std::time::Duration;

pub use jobs::dialogs::Picker;
pub use startup::run;

/// Key of the preferences in the storage.
const PREFS_KEY: &str = "grazing.prefs";

/// Key of the layout in the storage.
const LAYOUT_KEY: &str = "grazing.layout";

/// Longest time that the end of the program waits for jobs that were told to stop.
const PATIENCE: Duration = Duration::from_millis(300);

/// Options at the start of the window.
pub struct WindowOptions {
    /// Files to open.
    pub files: Vec<PathBuf>,
    /// Ways to ask a person for files.
    pub picker: Picker,
    /// The folder where what is open is kept for a crash; without one, nothing is.
    pub autosave: Option<PathBuf>,
    /// Preferences where none are kept from an earlier run.
    pub prefs: Prefs,
}

/// The program in its window.
pub struct App {
    state: State,
    inbox: Receiver<Msg>,
    tools: Tools,
    adapter: String,
    autosave: Option<Autosave>,
    lacking: LackingLetters,
    /// Tasks that wait for the first frame, which would have to share the cores with it; nothing waits any more at `None`.
    held: Option<Vec<Task>>,
    /// Number that egui gives the first frame.
    first_frame: Option<u64>,
    shown_theme: Option<Theme>,
    shown_zoom: Option<Zoom>,
    shown_title: String,
}

impl App {
    /// Sets the window up and starts to load what it begins with: the files, or else the first sample.
    ///
    /// # Errors
    /// If there is no wgpu renderer.
    pub fn new(
        cc: &eframe::CreationContext<'_>,
        options: WindowOptions,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        let render_state = cc
            .wgpu_render_state
            .as_ref()
            .ok_or("the window has no wgpu renderer")?;
        let sphere = views::sphere::callback::install(render_state);
        views::lobe3d::callback::install(render_state);
        set_style(&cc.egui_ctx);
        prepare_threads();
        let (sender, inbox) = Sender::new(cc.egui_ctx.clone());
        let mut app = Self {
            state: State::default(),
            inbox,
            tools: Tools {
                jobs: Jobs::new(sender),
                problems: Arc::default(),
                picker: options.picker,
            },
            adapter: crate::gpu::adapter::describe(&render_state.adapter.get_info()),
            autosave: None,
            lacking: LackingLetters::default(),
            held: Some(vec![Task::Start(sphere)]),
            first_frame: None,
            shown_theme: None,
            shown_zoom: None,
            shown_title: "Grazing".into(),
        };
        cc.egui_ctx.add_font_provider(Arc::new(app.lacking.clone()));
        app.handle(&cc.egui_ctx, Msg::SetPrefs(Box::new(options.prefs)));
        for msg in kept(cc) {
            app.handle(&cc.egui_ctx, msg);
        }
        if let Some(folder) = options.autosave {
            app.keep_for_a_crash(&cc.egui_ctx, &folder);
        }
        let first = match options.files {
            files if files.is_empty() => Msg::Run(command::Command::OpenSample(0)),
            files => Msg::OpenFiles(files),
        };
        app.handle(&cc.egui_ctx, first);
        Ok(app)
    }

    /// Lets the next job panic whose words contain `doing`: for tests.
    pub fn plant_panic(&self, doing: &str) {
        self.tools.jobs.plant_panic(doing);
    }

    /// State of the window, for tests.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Applies a message and starts what follows from it.
    pub fn handle(&mut self, ctx: &egui::Context, msg: Msg) {
        for task in apply(&mut self.state, msg) {
            match &mut self.held {
                Some(held) => held.push(task),
                None => tasks::start(task, &self.state, &self.tools, ctx),
            }
        }
    }

    /// Starts what has waited for the first frame, once that is on screen.
    fn start_held(&mut self, ctx: &egui::Context) {
        if self.held.is_none() {
            return;
        }
        let frame = ctx.cumulative_frame_nr();
        if frame == *self.first_frame.get_or_insert(frame) {
            ctx.request_repaint();
            return;
        }
        for task in self.held.take().unwrap_or_default() {
            tasks::start(task, &self.state, &self.tools, ctx);
        }
    }

    fn keep_for_a_crash(&mut self, ctx: &egui::Context, folder: &Path) {
        let msg = match Autosave::start(folder) {
            Ok((autosave, crashed)) => {
                self.autosave = Some(autosave);
                Msg::Session(SessionMsg::Crashed(crashed))
            }
            // Settings are kept beside it.
            Err(error) => Msg::Notify(
                Severity::Error,
                format!(
                    "Settings and recovery after a crash are off: your home folder cannot be written ({error})."
                ),
            ),
        };
        self.handle(ctx, msg);
    }

    fn title_ui(&mut self, ctx: &egui::Context) {
        let title = self.state.title();
        if title != self.shown_title {
            ctx.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.shown_title = title;
        }
    }

    fn panels_ui(&mut self, ui: &mut egui::Ui, out: &mut Vec<Msg>) {
        let state = &self.state;
        egui::Panel::top("menu").show(ui, |ui| menu::menu_ui(ui, state, out));
        egui::Panel::bottom("status").show(ui, |ui| status::status_ui(ui, state, out));
        sides::sides_ui(ui, state, out);
        lesson::lesson_ui(ui, state, out);
        let ground = egui::Frame::NONE.fill(ui.visuals().panel_fill);
        egui::CentralPanel::no_frame()
            .frame(ground)
            .show(ui, |ui| tiles_ui(ui, state, out));
        notices::notices_ui(ui.ctx(), state, out);
        panels::session::session_ui(ui.ctx(), state, out);
        dialogs::dialog_ui(ui.ctx(), state, &self.adapter, out);
    }
}

/// Messages with preferences and layout of the last run; none for one that the storage lacks or that cannot be read.
fn kept(cc: &eframe::CreationContext<'_>) -> Vec<Msg> {
    let Some(storage) = cc.storage else {
        return Vec::new();
    };
    let prefs = eframe::get_value::<Prefs>(storage, PREFS_KEY);
    let tiles = eframe::get_value::<Tiles>(storage, LAYOUT_KEY);
    let prefs = prefs.map(|prefs| Msg::SetPrefs(Box::new(prefs)));
    prefs.into_iter().chain(tiles.map(Msg::SetLayout)).collect()
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        if self.shown_theme != Some(self.state.prefs.theme) {
            self.shown_theme = Some(self.state.prefs.theme);
            ctx.set_theme(match self.state.prefs.theme {
                Theme::System => egui::ThemePreference::System,
                Theme::Light => egui::ThemePreference::Light,
                Theme::Dark => egui::ThemePreference::Dark,
            });
        }
        if self.shown_zoom != Some(self.state.prefs.zoom) {
            self.shown_zoom = Some(self.state.prefs.zoom);
            ctx.set_zoom_factor(self.state.prefs.zoom.factor());
        }
        let narrow = ctx.content_rect().width() < sides::NARROW;
        if narrow != self.state.prefs.panels.is_narrow {
            self.handle(&ctx, Msg::Narrow(narrow));
        }
        self.start_held(&ctx);
        let mut out: Vec<Msg> = self.inbox.try_iter().collect();
        shortcuts(&ctx, &self.state, &mut out);
        dropped_files(&ctx, &mut out);
        self.panels_ui(ui, &mut out);
        let lacking = self.lacking.take();
        if !lacking.is_empty() {
            out.push(Msg::Letters(lacking));
        }
        let changed = !out.is_empty();
        for msg in out {
            self.handle(&ctx, msg);
        }
        // A turn of the wheel goes on for some frames.
        let gesture = ctx.input(|input| {
            let still =
                input.smooth_scroll_delta() == egui::Vec2::ZERO && input.zoom_delta() == 1.0;
            input.pointer.any_down() || !still
        });
        if !gesture {
            self.handle(&ctx, Msg::Settle);
        }
        self.title_ui(&ctx);
        if let Some(autosave) = &mut self.autosave {
            autosave.tick(&self.state, &ctx, &self.tools.jobs);
        }
        if changed {
            // The panels above were drawn from the state before these messages.
            ctx.request_repaint();
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, PREFS_KEY, &self.state.prefs);
        eframe::set_value(storage, LAYOUT_KEY, &self.state.tiles);
    }

    fn on_exit(&mut self) {
        for job in &self.state.jobs {
            job.cancel.set();
        }
        if let Some(run) = &self.state.fit.run {
            run.cancel.set();
        }
        if let Some(folder) = &self.state.library.folder {
            folder.cancel.set();
        }
        if let Some(run) = &self.state.library.run {
            run.cancel.set();
        }
        self.tools.jobs.wait(PATIENCE);
        if let Some(autosave) = &mut self.autosave {
            autosave.end(&self.state);
        }
    }
}

/// Runs the commands whose keys were pressed. A field that is being edited keeps the keys it understands.
fn shortcuts(ctx: &egui::Context, state: &State, out: &mut Vec<Msg>) {
    let typing = ctx.egui_wants_keyboard_input();
    // "+" is Shift and "=" on many keyboards: without Shift it means the same.
    if ctx.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Equals)) {
        out.push(Msg::Run(command::Command::ZoomIn));
    }
    let mut entries: Vec<_> = ENTRIES
        .iter()
        .filter_map(|entry| Some((entry, entry.keys?)))
        .collect();
    // Ctrl+Z also matches while Shift is held, so the longer combinations go first.
    entries.sort_by_key(|(_, keys)| std::cmp::Reverse(usize::from(keys.modifiers.shift)));
    for (entry, keys) in entries {
        if keys == COPY {
            if !typing && entry.command.is_enabled(state) && copy_pressed(ctx) {
                out.push(Msg::Run(entry.command));
            }
            continue;
        }
        let bare = keys.modifiers.is_none();
        let kept = typing && (entry.menu == "Edit" || bare);
        // A bare key such as Esc has other uses where its command has none.
        let elsewhere = bare && (egui::Popup::is_any_open(ctx) || !entry.command.is_enabled(state));
        if !kept
            && !elsewhere
            && ctx.input_mut(|input| input.consume_shortcut(&keys))
            && entry.command.is_enabled(state)
        {
            out.push(Msg::Run(entry.command));
        }
    }
}

/// The keys that the system tells as a wish to copy rather than as keys.
const COPY: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::C);

/// Takes the wish to copy, unless text is selected that it means.
fn copy_pressed(ctx: &egui::Context) -> bool {
    let selected = ctx
        .plugin::<egui::text_selection::LabelSelectionState>()
        .lock()
        .has_selection();
    !selected
        && ctx.input_mut(|input| {
            let before = input.events.len();
            input.events.retain(|event| *event != egui::Event::Copy);
            input.events.len() < before
        })
}

fn dropped_files(ctx: &egui::Context, out: &mut Vec<Msg>) {
    let (paths, hovering) = ctx.input(|input| {
        let dropped = &input.raw.dropped_files;
        let paths: Vec<PathBuf> = dropped
            .iter()
            .map(|file| file.path().to_path_buf())
            .collect();
        (paths, !input.raw.hovered_files.is_empty())
    });
    if !paths.is_empty() {
        out.push(Msg::OpenFiles(paths));
    }
    if hovering {
        let rect = ctx.content_rect();
        let painter = ctx.layer_painter(egui::LayerId::new(
            egui::Order::Foreground,
            egui::Id::unique("drop"),
        ));
        painter.rect_filled(rect, 0.0, egui::Color32::from_black_alpha(160));
        painter.text(
            rect.center(),
            egui::Align2::CENTER_CENTER,
            "Drop MERL files, fit files, a session or a folder to open them",
            egui::FontId::proportional(24.0),
            egui::Color32::WHITE,
        );
    }
}

/// Small departures from egui's looks: rounder, calmer, the same in both themes.
fn set_style(ctx: &egui::Context) {
    // The commands do that, so that it is in the menu and kept.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
    ctx.all_styles_mut(|style| {
        style.spacing.item_spacing = egui::vec2(8.0, 5.0);
        style.spacing.button_padding = egui::vec2(8.0, 3.0);
        style.spacing.menu_margin = egui::Margin::same(6);
        style.visuals.slider_trailing_fill = true;
    });
}
