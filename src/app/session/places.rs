//! Search for the files of a session. Looks at the disk, so it is part of the job that reads the session.

use crate::app::session::file::SessionFile;
use crate::app::session::read::read;
use crate::files::{FileError, absolute};
use std::path::{Path, PathBuf};

/// A session that was read, and where its files are.
#[derive(Clone, Debug)]
pub struct FoundSession {
    /// Session as the file says it.
    pub session: SessionFile,
    /// A line on each thing that was not taken as it stands in the file.
    pub remarks: Vec<String>,
    /// Places of the materials' files, one for each material.
    pub places: Vec<FilePlace>,
}

/// Place of the file of a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilePlace {
    /// File that is there.
    pub found: Option<PathBuf>,
    /// Paths at which it was looked for.
    pub tried: Vec<PathBuf>,
}

/// Reads the text of the session file `path` and looks for the files that it names.
///
/// # Errors
/// One line that says why it is no session, with the path last.
pub fn find(path: &Path, text: &str) -> Result<FoundSession, FileError> {
    let say = |what: String| FileError::new(path, what);
    let (mut session, remarks) = read(text).map_err(say)?;
    let path = absolute(path);
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut places = Vec::new();
    for material in &mut session.materials {
        let Some(source) = &mut material.source else {
            places.push(FilePlace::default());
            continue;
        };
        let tried = source.places(folder);
        if source.relative.is_some() {
            source.beside = tried.first().cloned();
        }
        places.push(FilePlace {
            found: tried.iter().find(|place| place.is_file()).cloned(),
            tried,
        });
    }
    Ok(FoundSession {
        session,
        remarks: remarks
            .into_iter()
            .map(|remark| say(remark).to_string())
            .collect(),
        places,
    })
}
