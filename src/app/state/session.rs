//! The part of the state that is about sessions.

use crate::app::state::material::MaterialId;
use crate::files::session::SavedSource;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::time::Duration;

/// The part of the state that is about sessions.
#[derive(Debug, Default)]
pub struct SessionState {
    /// The session files, by [`crate::app::state::Scene::session`].
    pub files: BTreeMap<u64, PathBuf>,
    /// Materials whose files were not found.
    pub missing: Vec<Missing>,
    /// Materials of a session whose data were not yet held against it.
    pub unread: BTreeSet<MaterialId>,
    /// What runs that ended unexpectedly have left; the first is offered to be restored.
    pub crashed: Vec<Crashed>,
    /// What is being restored.
    pub restoring: Option<PathBuf>,
    /// What was restored: no longer needed once the present state is kept.
    pub restored: Vec<PathBuf>,
}

/// A material whose file was not found.
#[derive(Clone, Debug, PartialEq)]
pub struct Missing {
    /// Which one.
    pub id: MaterialId,
    /// Its file as the session names it.
    pub source: SavedSource,
    /// Where it was looked for.
    pub tried: Vec<PathBuf>,
    /// Whether a person went on without it.
    pub skipped: bool,
}

impl SessionState {
    /// What is known of a material that was not found.
    pub fn missing_one(&self, id: MaterialId) -> Option<&Missing> {
        self.missing.iter().find(|missing| missing.id == id)
    }
}

/// What a run that ended unexpectedly has left.
#[derive(Clone, Debug, PartialEq)]
pub struct Crashed {
    /// What was open.
    pub file: PathBuf,
    /// The lock that the run held.
    pub lock: PathBuf,
    /// How long ago it was written, where that is known.
    pub age: Option<Duration>,
}
