//! The one place where the state changes: `apply(state, message) → tasks`.

use super::command::Command;
use super::derived::{self, DerivedMsg, Work};
use super::fitting::{FitMsg, FitTask, Resolve, steps};
use super::guide::GuideAt;
use super::lessons;
use super::library::{self, LibraryMsg, LibraryTask};
use super::open_fits;
use super::opening::forget_unreachable;
pub(super) use super::opening::{add_material, add_material_at, load, load_with};
use super::paper::{self, PaperMsg, PaperTask};
use super::probe::Probe;
use super::run_command;
use super::session::{self, SessionMsg, SessionTask};
use super::state::{CancelFlag, Dialog, Level, LobeTile, Notice, Origin, Scene, SphereTile, State};
use super::subjects::{self, SubjectKey, Subjects};
use super::tasks::ModelExport;
use super::views::{
    AlbedoView, ErrorMapView, ImageView, LandscapeView, Lobe3dView, ScatterView, SlicesView,
};
use crate::brdf::{Brdf, ParamId, Params};
use crate::files::SourceFile;
use crate::files::fits::MaterialFits;
use crate::files::session::has_ending;
use crate::fit::start;
use crate::geom::color::luminance;
use crate::measured::Table;
use std::path::PathBuf;
use std::sync::Arc;

/// Something happened.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum Msg {
    /// A command was chosen in a menu, by its keys or in the palette.
    Run(Command),
    /// Open these files.
    OpenFiles(Vec<PathBuf>),
    /// A job went on.
    Progress { job: u64, progress: f32 },
    /// A job brought a material, or one line that says why not (`None`: it was cancelled).
    Loaded {
        job: u64,
        origin: Origin,
        result: Result<Loaded, Option<String>>,
    },
    /// A job read a file of models: what it has, by material.
    FitsRead {
        job: u64,
        path: PathBuf,
        fits: Vec<MaterialFits>,
    },
    /// Stop a job.
    Cancel(u64),
    /// Show another open material.
    Select(usize),
    /// Close an open material.
    Close(usize),
    /// Give a channel of a parameter a value; all channels where `channel` is `None`.
    SetParam {
        id: ParamId,
        channel: Option<usize>,
        value: f64,
    },
    /// Put a parameter back to its default.
    ResetParam(ParamId),
    /// Let the channels of a colour move as one, or apart.
    SetGrey(ParamId, bool),
    /// A view wishes for a result, or a job says something about one.
    Derived(Box<dyn DerivedMsg>),
    /// Go to a step of a lesson.
    Lesson { lesson: usize, step: usize },
    /// The lesson is over.
    EndLesson,
    /// Something about fitting.
    Fit(FitMsg),
    /// Something about a figure.
    Paper(PaperMsg),
    /// Something about the folder and memory.
    Library(LibraryMsg),
    /// Something about sessions.
    Session(SessionMsg),
    /// Change the sphere tile.
    SetSphere(SphereTile),
    /// Change the lobe tile.
    SetLobes(LobeTile),
    /// Change the slices.
    SetSlices(SlicesView),
    /// Change the albedo plot.
    SetAlbedo(AlbedoView),
    /// Change the tile of lobes in space.
    SetLobe3d(Lobe3dView),
    /// Change the image slice.
    SetImage(ImageView),
    /// Change the error map.
    SetErrorMap(ErrorMapView),
    /// Change the error landscape.
    SetLandscape(LandscapeView),
    /// Change the scatter of the materials.
    SetScatter(ScatterView),
    /// Lay this model over the shown material, with the best ρ_d and k_s once they are found.
    TakeModel(Brdf),
    /// The pointer shows a pair of directions, or none.
    Hover(Option<Probe>),
    /// Keep a pair of directions marked, or let it go.
    Pin(Option<Probe>),
    /// A name in a legend was clicked: show or hide it, or it alone.
    Legend { key: SubjectKey, solo: bool },
    /// Show an open material in the plots beside the shown one, or no longer.
    SetBeside(usize, bool),
    /// What is typed in the open dialog.
    Typed(String),
    /// Show a place of the guide.
    ReadGuide(GuideAt),
    /// Close the dialog.
    CloseDialog,
    /// Say something.
    Notify(Level, String),
    /// Close a notice.
    Dismiss(u64),
    /// No button and no key is held: the gesture is over.
    Settle,
}

/// What a loading job brings.
#[derive(Debug)]
pub struct Loaded {
    /// Name on screen.
    pub name: String,
    /// Which file it was.
    pub source: Option<SourceFile>,
    /// The data.
    pub table: Arc<Table>,
    /// The first guess of a model.
    pub guess: Brdf,
    /// The models that a fit file has for it.
    pub fits: Option<Box<MaterialFits>>,
}

impl Loaded {
    /// A table with its first guess; part of the job, as it walks the data.
    pub fn new(name: String, source: Option<SourceFile>, table: Table) -> Self {
        let guess = start::from_table(&table);
        Self {
            name,
            source,
            table: Arc::new(table),
            guess,
            fits: None,
        }
    }

    /// The model to begin with.
    pub(super) fn brdf(&self) -> Brdf {
        self.fits.as_ref().map_or(self.guess, |fits| fits.best)
    }
}

/// Something to be done outside the state.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each task names its fields")]
pub enum Task {
    /// Load a material in the background.
    Load {
        job: u64,
        origin: Origin,
        fits: Option<Box<MaterialFits>>,
        cancel: CancelFlag,
    },
    /// Fit in the background.
    Fit(FitTask),
    /// Find the best ρ_d and k_s in the background.
    Resolve(Resolve),
    /// Look at a folder, fit it, or ask for one.
    Library(LibraryTask),
    /// Write or copy a figure.
    Paper(PaperTask),
    /// Write a session, or ask where something is.
    Session(SessionTask),
    /// Make what a view wishes for.
    Derive(Work),
    /// Ask for files to open.
    PickFiles,
    /// Ask where to, and write a model.
    ExportModel(ModelExport),
    /// Ask where to, and write a picture of the window.
    SavePicture,
    /// Put this on the clipboard.
    Copy(String),
    /// Close the window.
    Quit,
}

/// Changes the state. Whatever happened, what is shown stays in memory and the rest within its limit.
pub fn apply(state: &mut State, msg: Msg) -> Vec<Task> {
    let mut tasks = change(state, msg);
    tasks.extend(library::memory::keep(state));
    tasks
}

fn change(state: &mut State, msg: Msg) -> Vec<Task> {
    match msg {
        Msg::Run(command) => return run_command::run(state, command),
        Msg::OpenFiles(mut paths) => {
            // A session takes the place of what is open; what comes with it is added.
            paths.sort_by_key(|path| !has_ending(path));
            return paths
                .into_iter()
                .map(|path| load(state, Origin::File(path)))
                .collect();
        }
        Msg::Progress { job, progress } => {
            if let Some(job) = state.jobs.iter_mut().find(|other| other.id == job) {
                job.progress = progress;
            }
        }
        Msg::Loaded {
            job,
            origin,
            result,
        } => {
            library::show::loaded(state, job, origin, result);
            return lessons::perform(state);
        }
        Msg::FitsRead { job, path, fits } => {
            state.jobs.retain(|other| other.id != job);
            return open_fits::open(state, &path, fits);
        }
        Msg::Cancel(job) => {
            if let Some(job) = state.jobs.iter().find(|other| other.id == job) {
                job.cancel.set();
            }
        }
        Msg::Select(index) => return library::show::select(state, index),
        Msg::Close(index) => {
            if let Some(opened) = state.scene.opened.get(index) {
                steps::forget(state, opened.id);
            }
            edit(state, |scene| {
                if index < scene.opened.len() {
                    scene.opened.remove(index);
                    if scene.selected > index || scene.selected == scene.opened.len() {
                        scene.selected = scene.selected.saturating_sub(1);
                    }
                }
            });
            forget_unreachable(state);
        }
        Msg::SetParam { id, channel, value } => {
            edit_brdf(state, |brdf| {
                let Some(row) = brdf.model.param(id) else {
                    return;
                };
                let value = row.clamp(value);
                let values = brdf.params.get_mut(id);
                match channel {
                    Some(channel) => values[channel] = value,
                    None => values.fill(value),
                }
            });
            return steps::resolve(state);
        }
        Msg::ResetParam(id) => {
            edit_brdf(state, |brdf| {
                if let Some(row) = brdf.model.param(id) {
                    brdf.params.get_mut(id).fill(row.default);
                }
            });
            return steps::resolve(state);
        }
        Msg::SetGrey(id, grey) => {
            edit(state, |scene| {
                if let Some(index) = Scene::grey_index(id) {
                    scene.grey[index] = grey;
                }
            });
            if grey {
                edit_brdf(state, |brdf| make_grey(&mut brdf.params, id));
            }
        }
        Msg::Derived(msg) => return derived::apply(state, msg),
        Msg::Lesson { lesson, step } => return lessons::go(state, lesson, step),
        Msg::EndLesson => state.lesson = None,
        Msg::Fit(msg) => return steps::apply(state, msg),
        Msg::Paper(msg) => return paper::apply(state, msg),
        Msg::Library(msg) => return library::steps::apply(state, msg),
        Msg::Session(msg) => return session::apply(state, msg),
        Msg::SetSphere(sphere) => edit(state, |scene| scene.sphere = sphere),
        Msg::SetLobes(lobes) => edit(state, |scene| scene.lobes = lobes),
        Msg::SetSlices(slices) => edit(state, |scene| scene.slices = slices),
        Msg::SetAlbedo(albedo) => edit(state, |scene| scene.albedo = albedo),
        Msg::SetLobe3d(lobe3d) => edit(state, |scene| scene.lobe3d = lobe3d),
        Msg::SetImage(image) => edit(state, |scene| scene.image = image),
        Msg::SetErrorMap(map) => edit(state, |scene| scene.error_map = map),
        Msg::SetLandscape(landscape) => edit(state, |scene| scene.landscape = landscape),
        Msg::SetScatter(scatter) => edit(state, |scene| scene.scatter = scatter),
        Msg::TakeModel(brdf) => return steps::take(state, brdf),
        Msg::Hover(probe) => state.hovered = probe,
        Msg::Pin(probe) => state.pinned = probe,
        Msg::Legend { key, solo } => {
            let all = Subjects::of(state).keys;
            edit(state, |scene| subjects::toggle(scene, &all, key, solo));
        }
        Msg::SetBeside(index, beside) => edit(state, |scene| {
            if let Some(opened) = scene.opened.get_mut(index) {
                opened.beside = beside;
            }
        }),
        Msg::Typed(text) => state.typed = text,
        Msg::ReadGuide(at) => state.dialog = Some(Dialog::Guide(at)),
        Msg::CloseDialog => state.dialog = None,
        Msg::Notify(level, text) => notify(state, level, text),
        Msg::Dismiss(id) => state.notices.retain(|notice| notice.id != id),
        Msg::Settle => state.history.settle(&state.scene),
    }
    Vec::new()
}

fn make_grey(params: &mut Params, id: ParamId) {
    let values = params.get_mut(id);
    if let [r, g, b] = *values {
        values.fill(luminance([r, g, b]));
    }
}

pub(super) fn edit(state: &mut State, change: impl FnOnce(&mut Scene)) {
    state.history.before_change(&state.scene);
    change(&mut state.scene);
}

/// Changes the shown model. A fit that moves it is stopped: its best so far is what is changed.
pub(super) fn edit_brdf(state: &mut State, change: impl FnOnce(&mut Brdf)) {
    steps::release_model(state);
    edit(state, |scene| {
        if let Some(opened) = scene.opened.get_mut(scene.selected) {
            change(&mut opened.brdf);
        }
    });
}

pub(super) fn notify(state: &mut State, level: Level, text: String) {
    let id = state.fresh_id();
    state.notices.push(Notice { id, level, text });
}
