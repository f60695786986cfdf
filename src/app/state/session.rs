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
    /// Files left by runs that ended unexpectedly; the first is offered to be restored.
    pub crashed: Vec<Crashed>,
    /// File that is being restored.
    pub restoring: Option<Crashed>,
    /// Files that were restored: no longer needed once the present state is kept.
    pub restored: Vec<PathBuf>,
}

/// A material whose file was not found.
#[derive(Clone, Debug, PartialEq)]
pub struct Missing {
    /// Material that has no data.
    pub id: MaterialId,
    /// File as the session names it.
    pub source: SavedSource,
    /// Paths at which it was looked for.
    pub tried: Vec<PathBuf>,
    /// Whether a person went on without it.
    pub skipped: bool,
}

impl SessionState {
    /// Search for the file of a material that was not found.
    pub fn missing_one(&self, id: MaterialId) -> Option<&Missing> {
        self.missing.iter().find(|missing| missing.id == id)
    }
}

/// Ending, in place of `json`, of what a run has left and cannot be restored.
pub const DAMAGED: &str = "damaged";

/// Files left by a run that ended unexpectedly.
#[derive(Clone, Debug, PartialEq)]
pub struct Crashed {
    /// Session that was open.
    pub file: PathBuf,
    /// The lock that the run held.
    pub lock: PathBuf,
    /// Time since it was written, where that is known.
    pub age: Option<Duration>,
}
