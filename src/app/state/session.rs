//! The part of the state that is about sessions.

use crate::app::state::material::MaterialId;
use crate::app::state::session_mark::SessionMark;
use crate::files::session::SavedSource;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::time::Duration;

/// The part of the state that is about sessions.
#[derive(Debug, Default)]
pub struct SessionState {
    /// The session files, by [`crate::app::state::Scene::session`].
    pub files: BTreeMap<u64, PathBuf>,
    /// Sessions as they were when they were written or read, by the same number.
    pub saved: BTreeMap<u64, SessionMark>,
    /// How far the window is with closing.
    pub closing: Closing,
    /// Materials whose files were not found.
    pub missing: Vec<Missing>,
    /// Materials of a session whose data were not yet held against it.
    pub unread: BTreeSet<MaterialId>,
    /// Files left by runs before; the first is offered to be restored.
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

/// How far the window is with closing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closing {
    /// It stays open.
    #[default]
    No,
    /// A person is asked what becomes of work that is in no file.
    Asked,
    /// It closes when the session is written.
    WhenSaved,
    /// It closes, and nothing need be kept.
    Yes,
    /// It closes as the system wants it; what is open is kept for the next start.
    BySystem,
}

/// Files left by a run before.
#[derive(Clone, Debug, PartialEq)]
pub struct Crashed {
    /// Session that was open.
    pub file: PathBuf,
    /// The lock that the run held.
    pub lock: PathBuf,
    /// Time since it was written, where that is known.
    pub age: Option<Duration>,
    /// Whether the system ended it: then nothing went wrong.
    pub by_system: bool,
}
