//! Figures from their files: from a spec, or from the recipe that a picture carries.

use super::error::ExportError;
use super::spec::{FigureSpec, SubjectSource};
use crate::figure::faults::Faults;
use crate::figure::write::recipe::{PictureKind, plain};
use crate::files::session::{relative, tidy};
use crate::files::{self, FileError, SourceFile};
use std::path::{Path, PathBuf};

/// Largest picture that is read for its recipe, in bytes.
const MOST: u64 = 512 << 20;

impl FigureSpec {
    /// Reads a figure from a file, or from the recipe that a picture carries; all of it can be drawn.
    ///
    /// # Errors
    /// One line with the path last.
    pub fn open(path: &Path) -> Result<Self, ExportError> {
        let text = match recipe_in(path)? {
            Some(text) => text,
            None => files::read_text(path)?,
        };
        let read = || {
            let mut spec = Self::from_json(&text)?;
            spec.find_from(&folder_of(path));
            let mut faults = Faults::default();
            spec.sanitize(&mut faults);
            faults.result().map(|()| spec)
        };
        read().map_err(|what| ExportError::Spec(FileError::new(path, what)))
    }

    /// The recipe as a picture in this folder carries it: the spec in one line. Measured files are named by their paths from
    /// there: a published picture does not tell where its author works.
    pub fn recipe(&self, folder: &Path) -> String {
        let mut spec = self.clone();
        for file in spec.measured_files() {
            if let Some(relative) = relative(folder, &file.path).filter(|_| file.path.is_absolute())
            {
                file.path = relative;
            }
        }
        // Plain data: there is nothing that cannot be written.
        plain(&serde_json::to_string(&spec).unwrap_or_default())
    }

    /// Names the measured files by whole paths, as they are found from the folder of the spec or the picture: the figure may be
    /// drawn elsewhere. A path at which there is none is left, but begins at the root.
    fn find_from(&mut self, folder: &Path) {
        for file in self.measured_files() {
            let [first, beside] = file.places(folder);
            let found = if !first.is_file() && beside.is_file() {
                beside
            } else {
                first
            };
            if found != file.path {
                file.path = tidy(&found);
            }
        }
    }

    /// The measured files that it names.
    pub(super) fn measured_files(&mut self) -> impl Iterator<Item = &mut SourceFile> {
        let sources = self.subjects.iter_mut().map(|subject| &mut subject.source);
        sources.filter_map(|source| match source {
            SubjectSource::Measured { file, .. } => Some(file),
            SubjectSource::Sample { .. } | SubjectSource::Model(_) => None,
        })
    }
}

/// The folder that a picture is in, from the root on.
pub(super) fn folder_of(picture: &Path) -> PathBuf {
    let path = files::absolute(picture);
    path.parent().map(Path::to_owned).unwrap_or_default()
}

/// The text of a spec in a picture that carries it as its recipe; `None` where the file is no SVG, PDF or PNG.
///
/// # Errors
/// One line with the path last; a picture without a recipe.
pub fn recipe_in(path: &Path) -> Result<Option<String>, FileError> {
    let Some(kind) = PictureKind::of_head(&files::read_head(path)?) else {
        return Ok(None);
    };
    let found = kind.recipe(files::read_bytes(path, MOST)?);
    match found.map_err(|what| FileError::new(path, what))? {
        Some(text) => Ok(Some(text)),
        None => {
            let what = "this picture carries no recipe of a figure: it is of an older Grazing or went through another program; its .figure.json draws it again";
            Err(FileError::new(path, what))
        }
    }
}
