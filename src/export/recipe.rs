//! The recipe that a picture carries, from its file.

use super::spec::FigureSpec;
use crate::figure::write::recipe::{PictureKind, plain};
use crate::files::{self, FileError};
use std::path::Path;

/// Largest picture that is read for its recipe, in bytes.
const MOST: u64 = 512 << 20;

impl FigureSpec {
    /// The recipe as pictures carry it: the spec in one line.
    pub fn recipe(&self) -> String {
        // Plain data: there is nothing that cannot be written.
        plain(&serde_json::to_string(self).unwrap_or_default())
    }
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
