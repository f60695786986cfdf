//! The file system, for the window and the command line alike: opening materials and models, writing whole files.
//!
//! May know [`crate::geom`], [`crate::brdf`] and [`crate::measured`]; knows no egui, wgpu or threads.

mod error;
mod write;

pub use error::FileError;
pub use write::write_atomically;

use crate::brdf::{self, Brdf};
use crate::geom::Rgb;
use crate::measured::{Lookup, Table, merl};
use glam::DVec3;
use std::fs::File;
use std::io::{Read, Seek};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

/// Called with the share that is done, in [0, 1]; may stop the work.
pub type Progress<'a> = &'a mut dyn FnMut(f32) -> ControlFlow<()>;

/// Something that has an f_r: a measurement or a model.
#[derive(Clone, Debug)]
pub enum Source {
    /// A MERL file.
    Table(Arc<Table>),
    /// A JSON object with a model and its parameters.
    Brdf(Brdf),
}

impl Source {
    /// f_r of (wi, wo) in 1/sr; `None` below the horizon of either and where nothing was measured.
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
/// One line that says what is wrong, what was expected and, last, the path.
pub fn open_table(path: &Path, progress: Progress) -> Result<Table, FileError> {
    let (file, len) = open(path)?;
    read_table(file, len, path, progress)
}

/// Opens a MERL file, or the model at `index` (from 0) of a JSON file. Which of them it is, the content says.
///
/// # Errors
/// As [`open_table`].
pub fn open_source(path: &Path, index: usize, progress: Progress) -> Result<Source, FileError> {
    let (mut file, len) = open(path)?;
    let io = |error| FileError::io(path, "reading failed", &error);
    if starts_as_json(&mut file).map_err(io)? {
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(io)?;
        let text = std::str::from_utf8(&bytes)
            .map_err(|_| FileError::new(path, "not valid JSON: it is no UTF-8 text"))?;
        let text = text.trim_start_matches('\u{feff}');
        let brdf = brdf::json::from_text(text, index)
            .map_err(|error| FileError::new(path, error.to_string()))?;
        return Ok(Source::Brdf(brdf));
    }
    if index > 0 && len > 0 {
        let text = format!("there is no entry {index}; only a JSON file with an array has entries");
        return Err(FileError::new(path, text));
    }
    read_table(file, len, path, progress).map(|table| Source::Table(Arc::new(table)))
}

/// What a material is called: its file's name without the extension.
pub fn material_name(path: &Path) -> String {
    path.file_stem()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}

/// Opens a regular file for reading; returns it with its length.
fn open(path: &Path) -> Result<(File, u64), FileError> {
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

fn read_table(file: File, len: u64, path: &Path, progress: Progress) -> Result<Table, FileError> {
    merl::read(file, len, progress).map_err(|error| FileError::merl(path, error))
}

/// Whether the first byte that is no blank opens a JSON object or array. Leaves the file at its start.
fn starts_as_json(file: &mut File) -> std::io::Result<bool> {
    let mut start = Vec::new();
    file.by_ref().take(4096).read_to_end(&mut start)?;
    file.rewind()?;
    let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start);
    let first = text.iter().find(|byte| !byte.is_ascii_whitespace());
    Ok(matches!(first, Some(b'{' | b'[')))
}
