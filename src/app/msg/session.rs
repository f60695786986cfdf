//! Messages and tasks of sessions.

use crate::app::session::file::SessionFile;
use crate::app::session::places::FoundSession;
use crate::app::state::material::MaterialId;
use crate::app::state::session::Crashed;
use crate::app::state::session_mark::SessionMark;
use std::path::PathBuf;

/// Something happened to sessions.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each message names its fields")]
pub enum SessionMsg {
    /// A job has read a session file.
    Read {
        job: u64,
        path: PathBuf,
        found: Box<FoundSession>,
    },
    /// A session was written as it was then; which one, by its number.
    Saved {
        number: u64,
        path: PathBuf,
        mark: Box<SessionMark>,
    },
    /// A session was not written: something is in the way, or nobody said where to.
    NotSaved,
    /// The window is to close.
    Close(Close),
    /// Ask where this material is.
    Locate(MaterialId),
    /// Files of materials were found.
    Located(Vec<(MaterialId, PathBuf)>),
    /// Go on without one, or without all, that is asked for.
    Skip { all: bool },
    /// Runs before have left these.
    Crashed(Vec<Crashed>),
    /// Open what the last run has left.
    Restore,
    /// Throw away what the last run has left.
    Discard,
}

/// Ways to the end of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Close {
    /// A person closes it: work that is in no file is asked about.
    Ask,
    /// Save the session, then close.
    Save,
    /// Close; what is in no file is not wanted.
    Discard,
    /// Stay open after all.
    Stay,
    /// The system ends the program: nobody can be asked, and what is open is kept.
    BySystem,
}

/// Something to be done outside the state.
#[derive(Debug)]
#[expect(missing_docs, reason = "the line over each task names its fields")]
pub enum SessionTask {
    /// Write a session to its file, or ask where to.
    Save {
        number: u64,
        session: Box<SessionFile>,
        mark: Box<SessionMark>,
        to: Option<PathBuf>,
        name: String,
    },
    /// Ask for the file of the first of these; the others may lie beside it.
    Locate(Vec<(MaterialId, PathBuf)>),
    /// Remove what a run has left.
    Remove(Crashed),
    /// Keep the window open though it was told to close.
    StayOpen,
    /// Put what a run has left and is damaged where it is not offered again.
    SetAside(Crashed),
}
