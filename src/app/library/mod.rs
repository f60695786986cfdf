//! The library: a folder of files, what is known of each, and which tables are in memory.
//!
//! ```text
//! a folder is opened ──▶ Scan ── a thread (scan.rs): names, then kinds, then every file read once ──▶ Folder.files
//! click, arrows ──▶ Show ── a Wish and Task::Load; the newest wins ──▶ Msg::Loaded ──▶ the preview is replaced
//! fit all ──▶ FitFolder ── a thread (fit_work.rs): file by file ──▶ Library.fits, by path
//! after every message: memory::keep ── tables over the limit go, those that are shown come back
//! ```
//!
//! A file that is stepped to is a *preview*: the next one takes its place, unless a person changed its model, fits it,
//! shows it beside others or keeps it (Enter, double click).
//!
//! [`Material::table`] is let go when it was not shown for the longest time and the limit says so; a table without
//! values stands in for it ([`Presence`]). What is about to be shown is loaded first: until it is there, the last
//! picture stays. Undo and closing change the scene at once, and the data follow.
//!
//! Opening a file and a fit of the shown material go first: while there is either, the threads here wait.

pub(super) mod fit_run;
mod fit_work;
pub mod listing;
pub mod memory;
mod scan;
pub(super) mod show;
pub(super) mod steps;
mod work;

pub use fit_run::FolderRun;
pub use listing::{SORT_KEYS, Sort, SortKey};
pub(super) use work::{LibraryTask, start};

use super::state::{CancelFlag, Material, MaterialId, Origin, State};
use crate::brdf::Brdf;
use crate::files::fits::{FitRecord, MaterialFits};
use crate::files::{self, folder::Content};
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Everything about the open folder and about memory.
#[derive(Debug, Default)]
pub struct Library {
    /// The open folder.
    pub folder: Option<Folder>,
    /// Words that the names must have.
    pub search: String,
    /// Order of the files.
    pub sort: Sort,
    /// The file that was asked for last: arrows go on from here. None while they step through the open materials.
    pub cursor: Option<PathBuf>,
    /// Counts the steps by keys, so that the list scrolls to the cursor once for each.
    pub reveal: u64,
    /// What is shown as soon as it is loaded.
    pub wish: Option<Wish>,
    /// The material that the next file replaces.
    pub preview: Option<Preview>,
    /// Fits of files, at most one per file and variant: made here or found in fit files of the folder.
    pub fits: BTreeMap<PathBuf, Vec<FitRecord>>,
    /// The fit of the whole folder.
    pub run: Option<FolderRun>,
    /// Counts messages: the time of [`Material::last_shown`].
    pub clock: u64,
    /// Makes the scan wait while something is opened.
    pub hold: Hold,
}

/// A folder whose files are listed. Its scan ends with it.
#[derive(Debug)]
pub struct Folder {
    /// Tells its scan from older ones.
    pub number: u64,
    /// Where it is, from the root on.
    pub path: PathBuf,
    /// Its files in natural order.
    pub files: Vec<FolderFile>,
    /// How far the scan is.
    pub scan: Scan,
    cancel: CancelFlag,
}

impl Drop for Folder {
    fn drop(&mut self) {
        self.cancel.set();
    }
}

/// How far a folder has been looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scan {
    /// Names are being read.
    Listing,
    /// Files are being looked at.
    Looking,
    /// All is known.
    Done,
}

/// A file of the folder.
#[derive(Debug)]
pub struct FolderFile {
    /// From the root on.
    pub path: PathBuf,
    /// Its name in one line.
    pub name: String,
    /// What it is.
    pub kind: Kind,
}

/// What a file of the folder is.
#[derive(Clone, Debug)]
pub enum Kind {
    /// Not looked at yet.
    Unknown,
    /// A measured material; what is in it, once it has been read.
    Measured(Option<Examined>),
    /// Models as JSON: how many materials they are of.
    Models(usize),
    /// No BRDF, and why.
    Other(String),
}

/// What reading a measured file has brought.
#[derive(Clone, Debug)]
pub struct Examined {
    /// Share of the cells that are valid, in [0, 1].
    pub valid_share: f64,
    /// See [`crate::measured::Table::highlight_half_width`].
    pub half_width: Option<f64>,
    /// The colour of the material as sRGB.
    pub color: [u8; 3],
    /// A small sphere.
    pub thumbnail: Thumbnail,
}

/// A small picture on the GPU.
#[derive(Clone)]
pub struct Thumbnail(pub egui::TextureHandle);

impl fmt::Debug for Thumbnail {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Thumbnail({:?})", self.0.size())
    }
}

/// What is shown as soon as it is loaded.
#[derive(Clone, Debug, PartialEq)]
pub struct Wish {
    /// The job that loads it.
    pub job: u64,
    /// Its name on screen.
    pub name: String,
    /// What it is.
    pub target: Target,
}

/// What is to be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// A file of the folder; whether it is more than a preview.
    File {
        /// From the root on.
        path: PathBuf,
        /// Whether the next one leaves it open.
        keep: bool,
    },
    /// An open material whose table was let go.
    Material(MaterialId),
}

/// A material that the next file replaces as long as its model is as it was opened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preview {
    /// Which one.
    pub id: MaterialId,
    /// Its model when it was opened.
    pub brdf: Brdf,
}

/// Whether the table of a material is in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Presence {
    /// It is.
    #[default]
    Here,
    /// It was let go, and is read again when the material is shown.
    Away,
    /// This job reads it.
    Loading(u64),
    /// It cannot be read again.
    Lost,
}

/// A switch that makes threads wait.
#[derive(Clone, Debug, Default)]
pub struct Hold(Arc<AtomicBool>);

impl Hold {
    /// Lets them wait, or go on.
    pub fn set(&self, wait: bool) {
        self.0.store(wait, Ordering::Relaxed);
    }

    /// Returns when it is off or the job is cancelled. Not for the window's thread.
    pub fn wait(&self, cancel: &CancelFlag) {
        while self.0.load(Ordering::Relaxed) && !cancel.is_set() {
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

/// Something happened to the library.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum LibraryMsg {
    /// Open this folder.
    Open(PathBuf),
    /// Close the folder.
    Close,
    /// The names in the folder, or why they cannot be read.
    Listed {
        number: u64,
        result: Result<Vec<PathBuf>, String>,
    },
    /// What files are, by position.
    Seen {
        number: u64,
        seen: Vec<(usize, Result<Content, String>)>,
    },
    /// What is in a file, by position.
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
    Sort(Sort),
    /// Show a file; whether it is more than a preview.
    Show { path: PathBuf, keep: bool },
    /// Go on by so many files, or open materials.
    Step(isize),
    /// Leave the preview open.
    Keep,
    /// How much memory tables may take, in MiB.
    SetLimit(u32),
    /// The fit of the folder has something to say.
    Fit { number: u64, said: fit_run::Said },
}

impl Material {
    /// The measured file it was read from, from the root on.
    pub fn file(&self) -> Option<PathBuf> {
        match &self.origin {
            Origin::File(path) if self.source.is_some() => Some(files::absolute(path)),
            _ => None,
        }
    }

    /// Whether its data are on their way.
    pub fn is_loading(&self) -> bool {
        matches!(self.presence, Presence::Loading(_) | Presence::Away)
    }
}

impl Library {
    /// The best fit of a file: the one with the smallest E.
    pub fn best_fit(&self, path: &Path) -> Option<&FitRecord> {
        let fits = self.fits.get(path)?;
        fits.iter()
            .min_by(|a, b| a.errors.total.total_cmp(&b.errors.total))
    }

    /// Keeps a fit of a file in place of the one of the same variant.
    pub(super) fn keep_fit(&mut self, path: &Path, fit: FitRecord) {
        let fits = self.fits.entry(path.to_owned()).or_default();
        let variant = |fit: &FitRecord| crate::fit::Variant::from(&fit.brdf);
        match fits.iter_mut().find(|kept| variant(kept) == variant(&fit)) {
            // It comes back from a material that was opened with it.
            Some(kept) if kept.brdf == fit.brdf && kept.errors == fit.errors => {}
            Some(kept) => *kept = fit,
            None => fits.push(fit),
        }
    }

    /// The fits of all files of the folder, in the order of the files.
    pub fn folder_fits(&self) -> impl Iterator<Item = &FitRecord> {
        let files = self.folder.iter().flat_map(|folder| &folder.files);
        files.filter_map(|file| self.fits.get(&file.path)).flatten()
    }

    /// The fits of a file as a fit file would bring them.
    fn fits_for(&self, path: &Path) -> Option<Box<MaterialFits>> {
        let records = self.fits.get(path)?;
        let source = records.first()?.source.clone();
        MaterialFits::of_records(files::material_name(path), source, path, records).map(Box::new)
    }
}

impl State {
    /// What is on its way to the screen, in words.
    pub fn loading(&self) -> Option<String> {
        let current = || self.current().map(|(material, _)| material);
        let name = match &self.library.wish {
            Some(wish) => &wish.name,
            None => &current().filter(|material| material.is_loading())?.name,
        };
        Some(format!("Loading {name}…"))
    }

    /// Whether and where a file is open: its position in the scene.
    pub fn position_of_file(&self, path: &Path) -> Option<usize> {
        self.scene.opened.iter().position(|opened| {
            let material = self.materials.get(&opened.id);
            material.and_then(Material::file).as_deref() == Some(path)
        })
    }
}
