//! Messages and tasks of the library.

use crate::app::state::fitting::settings::Setup;
use crate::app::state::job::{CancelFlag, Hold};
use crate::app::state::library::Examined;
use crate::app::state::library::listing::FileSort;
use crate::files::fits::FitRecord;
use crate::files::folder::FileContent;
use crate::fit::Variant;
use std::path::PathBuf;

/// Something happened to the library.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum LibraryMsg {
    /// Open this folder.
    Open(PathBuf),
    /// Close the folder.
    Close,
    /// Something about the listed folder.
    Folder(FolderMsg),
    /// Show a file; whether it is more than a preview.
    Show { path: PathBuf, keep: bool },
    /// Go on by so many files, or open materials.
    Step(isize),
    /// Leave the preview open.
    Keep,
    /// How much memory tables may take, in MiB.
    SetLimit(u32),
    /// The fit of the folder reports.
    Fit {
        number: u64,
        update: FolderFitUpdate,
    },
}

/// Something happened to the list of the open folder. `number` is that of its scan: what an older one says is dropped.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum FolderMsg {
    /// The names in the folder, or why they cannot be read.
    Listed {
        number: u64,
        result: Result<Vec<PathBuf>, String>,
    },
    /// Kinds of files, by position.
    Seen {
        number: u64,
        seen: Vec<(usize, Result<FileContent, String>)>,
    },
    /// Content of a measured file, by position.
    Examined {
        number: u64,
        index: usize,
        result: Result<Examined, String>,
    },
    /// The scan is over.
    Scanned { number: u64 },
    /// Change the words that are searched.
    Search(String),
    /// Change the order.
    Sort(FileSort),
}

impl From<FolderMsg> for LibraryMsg {
    fn from(msg: FolderMsg) -> Self {
        Self::Folder(msg)
    }
}

/// Something to be done outside the state.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each names its fields")]
pub enum LibraryTask {
    /// Look at the files of a folder.
    Scan {
        number: u64,
        path: PathBuf,
        cancel: CancelFlag,
        hold: Hold,
    },
    /// Fit files, one after the other.
    Fit(Box<FolderFit>),
    /// Ask for a folder to open.
    Pick,
    /// Ask where to, and write these fits.
    Save(Vec<FitRecord>),
}

/// A report of the fit of a folder.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each names its fields")]
pub enum FolderFitUpdate {
    /// Name of the next file, with which the run goes on.
    File(String),
    /// Progress of the present file, in [0, 1].
    Share(f32),
    /// A file is done.
    Done {
        path: PathBuf,
        result: Result<Vec<FitRecord>, String>,
    },
    /// All are done.
    End,
}

/// Files to fit.
#[derive(Debug)]
pub struct FolderFit {
    /// The run's.
    pub number: u64,
    /// Files in the order of the run.
    pub files: Vec<PathBuf>,
    /// Variants fitted to each file.
    pub variants: Vec<Variant>,
    /// Settings of the fits.
    pub setup: Setup,
    /// Ends it.
    pub cancel: CancelFlag,
    /// Makes it wait, in the middle of a fit too.
    pub hold: Hold,
}
