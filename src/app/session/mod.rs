//! Sessions: what is open as a file, and back; what is kept for the case that the program ends unexpectedly.
//!
//! ```text
//! State ── write.rs ──▶ SessionFile (file.rs) ── text ──▶ study.grazing.json, or a file in the autosave folder
//! text ── read.rs, sane.rs ──▶ SessionFile ── places.rs: which files are there ──▶ Found ── open.rs ──▶ State
//! ```
//!
//! Opening is one edit of the scene: its materials are in it at once, and their data come one by one through the jobs
//! that bring back what was let go ([`super::library::memory`]). One that is not found stays without its data and is
//! asked for; what lies over it is kept, and is saved again.
//!
//! Which session file a scene belongs to is a number in the scene, so that undo brings the name back with it.

pub mod autosave;
mod differences;
pub mod file;
mod open;
mod places;
mod read;
mod sane;
#[cfg(test)]
mod tests;
mod work;
mod write;

pub use file::SessionFile;
pub use places::{Found, find};
pub use read::read;
pub(super) use work::start;

use super::library::Presence;
use super::state::{MaterialId, State};
use super::update::Task;
use crate::files::session::{self, ENDING, SavedSource};
use autosave::Crashed;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

/// The part of the state that is about sessions.
#[derive(Debug, Default)]
pub struct SessionState {
    /// The session files, by [`super::state::Scene::session`].
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

/// Something happened to sessions.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum SessionMsg {
    /// A job has read a session file.
    Read {
        job: u64,
        path: PathBuf,
        found: Box<Found>,
    },
    /// A session was written; which one, by its number.
    Saved { number: u64, path: PathBuf },
    /// Ask where this material is.
    Locate(MaterialId),
    /// Files of materials were found.
    Located(Vec<(MaterialId, PathBuf)>),
    /// Go on without one, or without all, that is asked for.
    Skip { all: bool },
    /// Open what the last run has left.
    Restore,
    /// Throw away what the last run has left.
    Discard,
}

/// Something to be done outside the state.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each task names its fields")]
pub enum SessionTask {
    /// Write a session to its file, or ask where to.
    Save {
        number: u64,
        session: Box<SessionFile>,
        to: Option<PathBuf>,
        name: String,
    },
    /// Ask for the file of the first of these; the others may lie beside it.
    Locate(Vec<(MaterialId, String)>),
    /// Remove what a run has left.
    Remove(Crashed),
}

/// Changes the state.
pub(super) fn apply(state: &mut State, msg: SessionMsg) -> Vec<Task> {
    match msg {
        SessionMsg::Read { job, path, found } => return open::open(state, job, &path, *found),
        SessionMsg::Saved { number, path } => {
            state.prefs.remember(path.clone());
            state.session.files.insert(number, path);
        }
        SessionMsg::Locate(id) => return locate(state, id),
        SessionMsg::Located(found) => return open::located(state, found),
        SessionMsg::Skip { all } => skip(state, all),
        SessionMsg::Restore => return open::restore(state),
        SessionMsg::Discard => {
            if !state.session.crashed.is_empty() {
                let crashed = state.session.crashed.remove(0);
                return vec![Task::Session(SessionTask::Remove(crashed))];
            }
        }
    }
    Vec::new()
}

/// Saves to the session's file where there is one and `ask` does not say otherwise.
pub(super) fn save(state: &State, ask: bool) -> Vec<Task> {
    let number = state.scene.session;
    let file = state.session.files.get(&number);
    let name = match file {
        Some(file) => session::name(file),
        None => state
            .current()
            .map_or("session".into(), |(material, _)| material.name.clone()),
    };
    // What no file system takes.
    let name = name.replace(['/', '\\', ':'], "-");
    vec![Task::Session(SessionTask::Save {
        number,
        session: Box::new(SessionFile::of(state)),
        to: file.filter(|_| !ask).cloned(),
        name: format!("{name}{ENDING}"),
    })]
}

fn locate(state: &mut State, id: MaterialId) -> Vec<Task> {
    let lost = |id: &MaterialId| {
        let material = state.materials.get(id)?;
        let source = material.source.as_ref()?;
        let lost = material.presence == Presence::Lost;
        lost.then(|| (*id, source.path.clone()))
    };
    let others = state.scene.opened.iter().map(|opened| opened.id);
    let others = others.filter(|other| *other != id);
    let wanted: Vec<_> = std::iter::once(id)
        .chain(others)
        .filter_map(|id| lost(&id))
        .collect();
    if wanted.first().is_none_or(|(first, _)| *first != id) {
        return Vec::new();
    }
    vec![Task::Session(SessionTask::Locate(wanted))]
}

fn skip(state: &mut State, all: bool) {
    let asked = state.asked_for().map(|missing| missing.id);
    for missing in &mut state.session.missing {
        missing.skipped |= all || Some(missing.id) == asked;
    }
}

impl SessionState {
    /// What is known of a material that was not found.
    pub fn missing_one(&self, id: MaterialId) -> Option<&Missing> {
        self.missing.iter().find(|missing| missing.id == id)
    }
}

impl State {
    /// The open materials that were not found and not skipped.
    pub fn all_asked_for(&self) -> impl Iterator<Item = &Missing> {
        let lost = |missing: &&Missing| {
            let open = self.scene.opened.iter().any(|one| one.id == missing.id);
            let material = self.materials.get(&missing.id);
            !missing.skipped && open && material.is_some_and(|m| m.presence == Presence::Lost)
        };
        self.session.missing.iter().filter(lost)
    }

    /// The first of them.
    pub fn asked_for(&self) -> Option<&Missing> {
        self.all_asked_for().next()
    }

    /// What stands in the title of the window.
    pub fn title(&self) -> String {
        match self.session.files.get(&self.scene.session) {
            Some(file) => format!("{} — Grazing", session::name(file)),
            None => "Grazing".into(),
        }
    }
}
