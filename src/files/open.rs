//! Opening of measured files, models and fit files; the kind is told by the content, not by the name.

use super::error::FileError;
use super::fits::{self, SourceFile};
use super::paths::absolute;
use super::session;
use crate::brdf::{self, Brdf};
use crate::geom::Rgb;
use crate::measured::{Lookup, Table, merl};
use glam::DVec3;
use sha2::{Digest as _, Sha256};
use std::fs::File;
use std::io::{Read, Seek};
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

/// Message for a figure where models are expected.
const FIGURE_HAS_NO_MODELS: &str =
    "this is a figure; expected models or measured data; grazing figure FILE -o FILE.pdf draws it";

/// Whether a JSON text is a figure spec, which has both of these keys.
fn is_figure(text: &str) -> bool {
    let has = |key: &str| text.contains(&format!("\"{key}\""));
    text.trim_start().starts_with('{') && has("subjects") && has("rows")
}

/// Reads a JSON file; `None` if the file is something else.
///
/// # Errors
/// Errors of [`open_table`].
pub fn open_json(path: &Path) -> Result<Option<Json>, FileError> {
    let (mut file, _) = open(path)?;
    let Some(text) = json_text(&mut file, path)? else {
        return Ok(None);
    };
    if session::is_session(&text) {
        return Ok(Some(Json::Session(text)));
    }
    if is_figure(&text) {
        return Ok(Some(Json::Figure(text)));
    }
    let entries = fits::entries(&text).map_err(|what| FileError::new(path, what))?;
    Ok(Some(Json::Models(entries)))
}

/// Entries of a JSON file with models; `None` if the file is something else.
///
/// # Errors
/// Errors of [`open_table`]; a session.
pub fn open_models(path: &Path) -> Result<Option<Vec<fits::FitEntry>>, FileError> {
    match open_json(path)? {
        None => Ok(None),
        Some(Json::Models(entries)) => Ok(Some(entries)),
        Some(Json::Session(_)) => Err(FileError::new(path, session::NO_MODELS)),
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
    if let Some(text) = json_text(&mut file, path)? {
        if session::is_session(&text) {
            return Err(FileError::new(path, session::NO_MODELS));
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
    const MOST: u64 = 64 << 20;
    let (mut file, len) = open(path)?;
    if len > MOST {
        return Err(FileError::new(
            path,
            "the file is far too large for this; expected JSON",
        ));
    }
    rest_as_text(&mut file, path)
}

/// Remaining text of a file, without a byte order mark.
fn rest_as_text(file: &mut File, path: &Path) -> Result<String, FileError> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)
        .map_err(|error| FileError::io(path, "reading failed", &error))?;
    let text = String::from_utf8(bytes)
        .map_err(|_| FileError::new(path, "not valid JSON: it is no UTF-8 text"))?;
    Ok(text.trim_start_matches('\u{feff}').to_owned())
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

/// Text of a JSON file; `None` if the file is something else.
pub(super) fn json_text(file: &mut File, path: &Path) -> Result<Option<String>, FileError> {
    let found = starts_as_json(file);
    if found.map_err(|error| FileError::io(path, "reading failed", &error))? {
        rest_as_text(file, path).map(Some)
    } else {
        Ok(None)
    }
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

/// Whether the first byte that is no white space opens a JSON object or array. Leaves the file at its start.
fn starts_as_json(file: &mut File) -> std::io::Result<bool> {
    let mut start = Vec::new();
    file.by_ref().take(4096).read_to_end(&mut start)?;
    file.rewind()?;
    let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start);
    let first = text.iter().find(|byte| !byte.is_ascii_whitespace());
    Ok(matches!(first, Some(b'{' | b'[')))
}
