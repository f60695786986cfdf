//! Messages: what happened; and tasks: what is to be done outside the state.

pub mod cache;
pub mod command;
pub mod figure;
pub mod fit;
pub mod library;
pub mod session;
pub mod work;

use crate::app::guide::GuideAt;
use crate::app::msg::cache::CacheMsg;
use crate::app::msg::command::Command;
use crate::app::msg::figure::{FigureMsg, FigureTask};
use crate::app::msg::fit::{FitMsg, FitTask, RefitAmplitudes};
use crate::app::msg::library::{LibraryMsg, LibraryTask};
use crate::app::msg::session::{SessionMsg, SessionTask};
use crate::app::msg::work::Work;
use crate::app::state::fitted::MaterialPlace;
use crate::app::state::job::CancelFlag;
use crate::app::state::layout::Tiles;
use crate::app::state::material::Origin;
use crate::app::state::notice::Severity;
use crate::app::state::prefs::Prefs;
use crate::app::state::probe::Probe;
use crate::app::state::side_panels::SideTab;
use crate::app::state::subject_key::SubjectKey;
use crate::app::state::view_settings::{AnySettings, Settings};
use crate::brdf::{Brdf, ParamId};
use crate::figure::write::font::FallbackFont;
use crate::files::fits::MaterialFits;
use crate::files::{ModelFormat, SourceFile};
use crate::fit::initial_guess;
use crate::geom::Rgb;
use crate::measured::Table;
use std::collections::BTreeSet;
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
    /// Give all channels of a colour their values.
    SetColor { id: ParamId, rgb: Rgb },
    /// Put a parameter back to its default.
    ResetParam(ParamId),
    /// Make a colour grey, as bright as it is.
    MakeGrey(ParamId),
    /// A view requests a result, or a job reports on one.
    Cache(Box<dyn CacheMsg>),
    /// Go to a step of a lesson.
    Lesson { lesson: usize, step: usize },
    /// The lesson is over.
    EndLesson,
    /// Something about fitting.
    Fit(FitMsg),
    /// Something about a figure.
    Figure(FigureMsg),
    /// Something about the folder and memory.
    Library(LibraryMsg),
    /// Something about sessions.
    Session(SessionMsg),
    /// Set what a view shows.
    SetView(AnySettings),
    /// The tiles were moved.
    SetLayout(Tiles),
    /// The preferences of the last run were read.
    SetPrefs(Box<Prefs>),
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
    /// Text typed in the open dialog.
    Typed(String),
    /// Show a place of the guide.
    ReadGuide(GuideAt),
    /// Close the dialog.
    CloseDialog,
    /// The window has become narrow, or wide again.
    Narrow(bool),
    /// Show this half of the model's panel where there is no room for both.
    ShowTab(SideTab),
    /// Say something.
    Notify(Severity, String),
    /// Letters are shown that no font has.
    Letters(BTreeSet<char>),
    /// A job has looked for fonts: those found, and the letters that none has.
    FontsFound {
        fonts: Vec<FallbackFont>,
        lacking: BTreeSet<char>,
    },
    /// Close a notice.
    Dismiss(u64),
    /// No button and no key is held: the gesture is over.
    Settle,
}

impl Msg {
    /// Sets what a view shows.
    pub fn set_view(settings: impl Settings) -> Self {
        Self::SetView(AnySettings::new(settings))
    }

    /// Shows a material.
    pub fn show_material(place: &MaterialPlace) -> Self {
        match place {
            MaterialPlace::Open(index) => Self::Select(*index),
            MaterialPlace::File(path) => Self::Library(LibraryMsg::Show {
                path: path.clone(),
                keep: false,
            }),
        }
    }
}

/// Result of a loading job.
#[derive(Debug)]
pub struct Loaded {
    /// Name on screen.
    pub name: String,
    /// File that it was read from, with its length and SHA-256.
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
        let guess = initial_guess::from_table(&table);
        Self {
            name,
            source,
            table: Arc::new(table),
            guess,
            fits: None,
        }
    }

    /// A material that is a model and nothing else.
    pub fn alone(fits: Box<MaterialFits>) -> Self {
        Self {
            name: fits.name.clone(),
            source: None,
            table: Table::unmeasured(),
            guess: fits.best,
            fits: Some(fits),
        }
    }

    /// The model to begin with.
    pub(crate) fn brdf(&self) -> Brdf {
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
    RefitAmplitudes(RefitAmplitudes),
    /// Look at a folder, fit it, or ask for one.
    Library(LibraryTask),
    /// Write or copy a figure.
    Figure(FigureTask),
    /// Write a session, or ask where something is.
    Session(SessionTask),
    /// Start a job that computes the result of a view.
    Start(Work),
    /// Ask for files to open.
    PickFiles,
    /// Ask where to, and write a model.
    ExportModel(ModelExport),
    /// Ask where to, and write a picture of the window.
    SavePicture,
    /// Look for fonts that have these letters, in the background.
    FindFonts(BTreeSet<char>),
    /// Draw letters with these fonts too.
    AddFonts(Vec<FallbackFont>),
    /// Put this on the clipboard.
    Copy(String),
    /// Close the window.
    Quit,
}

/// A model to be written for other programs.
#[derive(Debug)]
pub struct ModelExport {
    /// File format.
    pub format: ModelFormat,
    /// Name of the material it was laid over.
    pub material: String,
    /// The model with its numbers.
    pub brdf: Brdf,
}
