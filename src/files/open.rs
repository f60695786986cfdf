//! Opening of measured files, models and fit files; the kind is told by the content, not by the name.

use super::error::FileError;
use super::fits::{self, SourceFile};
use super::json_file;
use super::paths::absolute;
use super::session;
use crate::brdf::{self, Brdf};
use crate::geom::Rgb;
use crate::json;
use crate::measured::{Lookup, Table, merl};
use glam::DVec3;
use sha2::{Digest as _, Sha256};
use std::fs::File;
use std::io::Read;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

/// Observer of a long read, called with the share done, in [0, 1]; may stop it.
pub type OnProgress<'a> = &'a mut dyn FnMut(f32) -> ControlFlow<()>;

/// Source of f_r: a measurement or a model.
#[derive(Clone, Debug)]
pub enum OpenedSource {
    /// Measured table of a MERL file.
    Table(Arc<Table>),
    /// Model of a JSON file.
    Brdf(Brdf),
}

impl OpenedSource {
    /// f_r of the unit vectors (wi, wo) in 1/sr, linear RGB; `None` below the horizon of either and where nothing was
    /// measured.
    pub fn eval(&self, wi: DVec3, wo: DVec3, lookup: Lookup) -> Option<Rgb> {
        match self {
            Self::Table(table) => table.lookup(wi, wo, lookup),
            Self::Brdf(brdf) => brdf.f_r(wi, wo),
        }
    }
}

/// Opens a MERL file.
///
/// # Errors
/// Says in one line what is wrong, what was expected and, last, the path.
pub fn open_table(path: &Path, progress: OnProgress) -> Result<Table, FileError> {
    let (file, len) = open(path)?;
    read_table(file, len, path, progress)
}

/// Opens a MERL file; returns it with its identity.
///
/// # Errors
/// Errors of [`open_table`].
pub fn open_measured(path: &Path, progress: OnProgress) -> Result<(Table, SourceFile), FileError> {
    let (file, len) = open(path)?;
    let mut file = Hashing::new(file);
    let table =
        merl::read(&mut file, len, progress).map_err(|error| FileError::merl(path, error))?;
    Ok((table, file.finish(path, len)))
}

/// Identity of a file of any content.
///
/// # Errors
/// Errors of [`open_table`].
pub fn identify(path: &Path) -> Result<SourceFile, FileError> {
    let (file, len) = open(path)?;
    let mut file = Hashing::new(file);
    std::io::copy(&mut file, &mut std::io::sink())
        .map_err(|error| FileError::io(path, "reading failed", &error))?;
    Ok(file.finish(path, len))
}

/// Content of a JSON file.
#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// Entries of models or fits.
    Models(Vec<fits::FitEntry>),
    /// Text of a session.
    Session(String),
    /// Text of a figure spec.
    Figure(String),
}

/// Kind of a JSON text, by the keys at its top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JsonKind {
    /// A session, even a truncated one.
    Session,
    /// A figure spec.
    Figure,
    /// Models or fits, or nothing that is known.
    Models,
}

impl JsonKind {
    /// Kind of a text, of which the beginning may be enough.
    pub fn of(text: &str) -> Self {
        match json::has_keys(text, [session::KEY, "subjects", "rows"]) {
            [true, ..] => Self::Session,
            [_, true, true] => Self::Figure,
            _ => Self::Models,
        }
    }

    /// Message where models are expected and this is something else.
    pub fn is_no_model(self) -> Option<&'static str> {
        match self {
            Self::Session => Some(SESSION_HAS_NO_MODELS),
            Self::Figure => Some(FIGURE_HAS_NO_MODELS),
            Self::Models => None,
        }
    }
}

/// Message for a session where models are expected.
const SESSION_HAS_NO_MODELS: &str =
    "this is a session; expected models or measured data; grazing FILE opens it in the window";

/// Message for a figure where models are expected.
const FIGURE_HAS_NO_MODELS: &str =
    "this is a figure; expected models or measured data; grazing figure FILE -o FILE.pdf draws it";

/// Reads a JSON file; `None` if the file is something else.
///
/// # Errors
/// Errors of [`open_table`].
pub fn open_json(path: &Path) -> Result<Option<Json>, FileError> {
    let (mut file, len) = open(path)?;
    let Some(text) = json_file::text(&mut file, len, path)? else {
        return Ok(None);
    };
    Ok(Some(match JsonKind::of(&text) {
        JsonKind::Session => Json::Session(text),
        JsonKind::Figure => Json::Figure(text),
        JsonKind::Models => {
            let entries = fits::entries(&text).map_err(|what| FileError::new(path, what))?;
            Json::Models(entries)
        }
    }))
}

/// Entries of a JSON file with models; `None` if the file is something else.
///
/// # Errors
/// Errors of [`open_table`]; a session.
pub fn open_models(path: &Path) -> Result<Option<Vec<fits::FitEntry>>, FileError> {
    match open_json(path)? {
        None => Ok(None),
        Some(Json::Models(entries)) => Ok(Some(entries)),
        Some(Json::Session(_)) => Err(FileError::new(path, SESSION_HAS_NO_MODELS)),
        Some(Json::Figure(_)) => Err(FileError::new(path, FIGURE_HAS_NO_MODELS)),
    }
}

/// Entry `index` (from 0) of a JSON file with models.
///
/// # Errors
/// Errors of [`open_table`]; a measured file is no model.
pub fn open_model(path: &Path, index: usize) -> Result<fits::FitEntry, FileError> {
    let Some(mut entries) = open_models(path)? else {
        let what = "this is no JSON file; expected a model or a fit file, which `grazing fit` makes of measured files";
        return Err(FileError::new(path, what));
    };
    if index < entries.len() {
        return Ok(entries.swap_remove(index));
    }
    let count = entries.len();
    let what = format!("there is no entry {index}; the file has {count}, counted from 0");
    Err(FileError::new(path, what))
}

/// Opens a MERL file, or the model at `index` (from 0) of a JSON file; the content tells which.
///
/// # Errors
/// Errors of [`open_table`].
pub fn open_source(
    path: &Path,
    index: usize,
    progress: OnProgress,
) -> Result<OpenedSource, FileError> {
    let (mut file, len) = open(path)?;
    if let Some(text) = json_file::text(&mut file, len, path)? {
        if let Some(what) = JsonKind::of(&text).is_no_model() {
            return Err(FileError::new(path, what));
        }
        let brdf = brdf::json::from_text(&text, index)
            .map_err(|error| FileError::new(path, error.to_string()))?;
        return Ok(OpenedSource::Brdf(brdf));
    }
    if index > 0 && len > 0 {
        let text = format!("there is no entry {index}; only a JSON file with an array has entries");
        return Err(FileError::new(path, text));
    }
    read_table(file, len, path, progress).map(|table| OpenedSource::Table(Arc::new(table)))
}

/// Text of a file of at most 64 MiB.
///
/// # Errors
/// Errors of [`open_table`]; a file that is no UTF-8 text or larger.
pub fn read_text(path: &Path) -> Result<String, FileError> {
    let (mut file, len) = open(path)?;
    json_file::rest(&mut file, len, json_file::MOST, path)
}

/// Opens a regular file for reading; returns it with its length in bytes.
pub(super) fn open(path: &Path) -> Result<(File, u64), FileError> {
    let cannot = |error| FileError::io(path, "cannot open the file", &error);
    // Before opening: a pipe would wait for its writer.
    let metadata = std::fs::metadata(path).map_err(cannot)?;
    if metadata.is_dir() {
        return Err(FileError::new(path, "this is a directory; expected a file"));
    }
    if !metadata.is_file() {
        return Err(FileError::new(
            path,
            "this is a device or a pipe; expected a regular file",
        ));
    }
    Ok((File::open(path).map_err(cannot)?, metadata.len()))
}

fn read_table(file: File, len: u64, path: &Path, progress: OnProgress) -> Result<Table, FileError> {
    merl::read(file, len, progress).map_err(|error| FileError::merl(path, error))
}

/// Reader that hashes the bytes that go through it.
struct Hashing {
    file: File,
    hasher: Sha256,
}

impl Hashing {
    fn new(file: File) -> Self {
        Self {
            file,
            hasher: Sha256::new(),
        }
    }

    /// Identity of the file, after all of it was read.
    fn finish(self, path: &Path, len: u64) -> SourceFile {
        let digest = self.hasher.finalize();
        SourceFile {
            path: absolute(path),
            bytes: Some(len),
            sha256: Some(digest.iter().map(|byte| format!("{byte:02x}")).collect()),
        }
    }
}

impl Read for Hashing {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.file.read(buffer)?;
        self.hasher.update(&buffer[..count]);
        Ok(count)
    }
}
