//! The window: egui over the state. Panels and views read the state and push messages; [`reduce::apply`] changes it.

pub mod command;
pub mod guide;
mod input;
pub mod jobs;
mod largest;
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

use crate::app::jobs::autosave::Autosave;
use crate::app::jobs::fonts::LackingLetters;
use crate::app::jobs::sender::Sender;
use crate::app::jobs::{Jobs, prepare_threads};
use crate::app::largest::Largest;
use crate::app::msg::session::{Close, SessionMsg};
use crate::app::msg::{Msg, Task};
use crate::app::panels::tiles::tiles_ui;
use crate::app::panels::{dialogs, lesson, menu, notices, sides, status};
use crate::app::reduce::apply;
use crate::app::state::State;
use crate::app::state::layout::Tiles;
use crate::app::state::notice::Severity;
use crate::app::state::prefs::{Prefs, Theme, Zoom};
use crate::app::state::session::Closing;
use crate::app::state::session_mark::is_unsaved;
use crate::app::tasks::Tools;
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

/// Width of the picture of all letters in pixels, at most.
const LETTERS_SIDE: usize = 8192;

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
    /// Something to be said at once.
    pub notice: Option<String>,
}

/// The program in its window.
pub struct App {
    state: State,
    inbox: Receiver<Msg>,
    tools: Tools,
    adapter: String,
    largest: Largest,
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
            largest: Largest::of(render_state.device.limits().max_texture_dimension_2d),
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
        if let Some(text) = options.notice {
            app.handle(&cc.egui_ctx, Msg::Notify(Severity::Error, text));
        }
        if let Some(folder) = options.autosave {
            app.keep_for_a_crash(&cc.egui_ctx, &folder);
        }
        let left = app.state.session.crashed.first();
        let first = match options.files {
            files if !files.is_empty() => Msg::OpenFiles(files),
            _ if left.is_some_and(|left| left.by_system) => Msg::Session(SessionMsg::Restore),
            _ => Msg::Run(command::Command::OpenSample(0)),
        };
        app.handle(&cc.egui_ctx, first);
        Ok(app)
    }

    /// Lets the next job panic whose words contain `doing`: for tests.
    pub fn plant_panic(&self, doing: &str) {
        self.tools.jobs.plant_panic(doing);
    }

    /// Answer to the end of the program by the system: tells the window to keep what is open and to close.
    pub fn on_end(&self) -> impl Fn() + Send + use<> {
        let sender = self.tools.jobs.sender().clone();
        let run = self.autosave.as_ref().map(Autosave::run);
        move || {
            // First, as a window that is hidden may not get to it.
            if let Some(run) = &run {
                run.mark_ended_by_system();
            }
            sender.send(Msg::Session(SessionMsg::Close(Close::BySystem)));
        }
    }

    /// The way of messages to the window, from any thread.
    pub fn sender(&self) -> &Sender {
        self.tools.jobs.sender()
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
    fn raw_input_hook(&mut self, _ctx: &egui::Context, input: &mut egui::RawInput) {
        // egui makes its picture of all letters as wide as a texture can be. A window of several screens needs such ones,
        // letters do not.
        input.max_texture_side = input.max_texture_side.map(|side| side.min(LETTERS_SIDE));
    }

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
        if let Some(text) = self.largest.keep(&ctx) {
            self.handle(&ctx, Msg::Notify(Severity::Info, text));
        }
        if ctx.input(|input| input.viewport().close_requested()) {
            self.handle(&ctx, Msg::Session(SessionMsg::Close(Close::Ask)));
        }
        let mut out: Vec<Msg> = self.inbox.try_iter().collect();
        input::shortcuts(&ctx, &self.state, &mut out);
        input::dropped_files(&ctx, &mut out);
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
        let Some(autosave) = &mut self.autosave else {
            return;
        };
        match self.state.session.closing {
            Closing::Yes => autosave.end(&self.state),
            Closing::BySystem => autosave.keep(&self.state),
            // Nobody was asked: a display that is gone, say.
            _ if is_unsaved(&self.state) => autosave.keep(&self.state),
            _ => autosave.end(&self.state),
        }
    }
}

/// Small departures from egui's looks: rounder, calmer, the same in both themes.
fn set_style(ctx: &egui::Context) {
    ctx.options_mut(|options| {
        // Nobody sets the others here, so what an earlier run has left of them is of no use.
        let zoom_factor = options.zoom_factor;
        *options = egui::Options::default();
        options.zoom_factor = zoom_factor;
        // The commands do that, so that it is in the menu and kept.
        options.zoom_with_keyboard = false;
    });
    ctx.all_styles_mut(|style| {
        style.spacing.item_spacing = egui::vec2(8.0, 5.0);
        style.spacing.button_padding = egui::vec2(8.0, 3.0);
        style.spacing.menu_margin = egui::Margin::same(6);
        style.visuals.slider_trailing_fill = true;
    });
}
