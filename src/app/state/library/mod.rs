//! The library: a folder of files, what is known of each, and which tables are in memory.
//!
//! ```text
//! a folder is opened ──▶ Scan ── jobs (jobs/scan.rs): names, then kinds, then every file read once ──▶ Folder.files
//! click, arrows ──▶ Show ── a Pending and Task::Load; the newest wins ──▶ Msg::Loaded ──▶ the preview is replaced
//! fit all ──▶ FitFolder ── a job a file (jobs/folder_fit.rs) ──▶ Library.fits, by path
//! after every message: memory::keep ── tables over the limit go, those that are shown come back
//! ```
//!
//! A file that is stepped to is a *preview*: the next one takes its place, unless a person changed its model, fits it,
//! shows it beside others or keeps it (Enter, double click).
//!
//! [`crate::app::state::material::Material::table`] is let go when it was not shown for the longest time and the limit says so; a table without
//! values stands in for it ([`crate::app::state::material::Presence`]). What is about to be shown is loaded first: until it is there, the last
//! picture stays. Undo and closing change the scene at once, and the data follow.
//!
//! Opening a file and a fit of the shown material go first: while there is either, the jobs of the library wait.

#[cfg(test)]
pub(crate) mod fixtures;
pub mod folder_run;
pub mod listing;

use crate::app::state::job::{CancelFlag, Hold};
use crate::app::state::library::folder_run::FolderRun;
use crate::app::state::library::listing::FileSort;
use crate::app::state::material::MaterialId;
use crate::brdf::Brdf;
use crate::files;
use crate::files::fits::{FitRecord, MaterialFits};
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

/// The open folder and the memory of tables.
#[derive(Debug, Default)]
pub struct Library {
    /// The open folder.
    pub folder: Option<Folder>,
    /// Words that the names must have.
    pub search: String,
    /// Order of the files.
    pub sort: FileSort,
    /// The file that was asked for last: arrows go on from here. None while they step through the open materials.
    pub cursor: Option<PathBuf>,
    /// Counts the steps by keys, so that the list scrolls to the cursor once for each.
    pub reveal: u64,
    /// Material that is shown as soon as it is loaded.
    pub pending: Option<Pending>,
    /// The material that the next file replaces.
    pub preview: Option<Preview>,
    /// Fits of files, at most one per file and variant: made here or found in fit files of the folder.
    pub fits: BTreeMap<PathBuf, Vec<FitRecord>>,
    /// The fit of the whole folder.
    pub run: Option<FolderRun>,
    /// Counts messages: the time of [`crate::app::state::material::Material::last_shown`].
    pub clock: u64,
    /// Makes the scan wait while something is opened.
    pub hold: Hold,
}

/// A folder whose files are listed. Its scan ends with it.
#[derive(Debug)]
pub struct Folder {
    /// Tells its scan from older ones.
    pub number: u64,
    /// Path from the root on.
    pub path: PathBuf,
    /// Files in natural order.
    pub files: Vec<FolderFile>,
    /// Progress of the scan.
    pub scan: Scan,
    /// Set to end the scan.
    pub cancel: CancelFlag,
}

impl Drop for Folder {
    fn drop(&mut self) {
        self.cancel.set();
    }
}

/// Progress of the scan of a folder.
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
    /// Path from the root on.
    pub path: PathBuf,
    /// File name in one line.
    pub name: String,
    /// Kind of the file.
    pub kind: FileKind,
}

/// Kind of a file of the folder.
#[derive(Clone, Debug)]
pub enum FileKind {
    /// Not looked at yet.
    Unknown,
    /// A measured material; what is in it, once it has been read.
    Measured(Option<Examined>),
    /// Models as JSON: how many materials they are of; `None` where the file is too large to be read for a list.
    Models(Option<usize>),
    /// No BRDF, and why.
    Other(String),
}

/// Facts read from a measured file.
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

/// Material that is shown as soon as it is loaded.
#[derive(Clone, Debug, PartialEq)]
pub struct Pending {
    /// The job that loads it.
    pub job: u64,
    /// Display name.
    pub name: String,
    /// Material that is to be shown.
    pub target: PendingTarget,
}

/// Material that is to be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum PendingTarget {
    /// A file of the folder; whether it is more than a preview.
    File {
        /// Path from the root on.
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
    /// Material that is replaced.
    pub id: MaterialId,
    /// Model over it when it was opened.
    pub brdf: Brdf,
}

impl Library {
    /// The best fit of a file: the one with the smallest E.
    pub fn best_fit(&self, path: &Path) -> Option<&FitRecord> {
        let fits = self.fits.get(path)?;
        fits.iter()
            .min_by(|a, b| a.errors.total.total_cmp(&b.errors.total))
    }

    /// Keeps a fit of a file in place of the one of the same variant.
    pub(crate) fn keep_fit(&mut self, path: &Path, fit: FitRecord) {
        let fits = self.fits.entry(path.to_owned()).or_default();
        let variant = |fit: &FitRecord| crate::fit::Variant::from(&fit.brdf);
        match fits.iter_mut().find(|kept| variant(kept) == variant(&fit)) {
            // It comes back from a material that was opened with it.
            Some(kept)
                if (kept.brdf, kept.errors, kept.ended) == (fit.brdf, fit.errors, fit.ended) => {}
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
    pub fn fits_for(&self, path: &Path) -> Option<Box<MaterialFits>> {
        let records = self.fits.get(path)?;
        let source = records.first()?.source.clone();
        MaterialFits::of_records(files::material_name(path), source, path, records).map(Box::new)
    }
}
