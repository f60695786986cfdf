//! Reducer of the window's end: work that is in no file is asked about, and nothing is thrown away before.

use crate::app::msg::Task;
use crate::app::msg::session::{Close, SessionTask};
use crate::app::reduce::session;
use crate::app::state::State;
use crate::app::state::session::Closing;
use crate::app::state::session_mark::is_unsaved;

/// The window is to close.
pub(crate) fn close(state: &mut State, close: Close) -> Vec<Task> {
    let before = state.session.closing;
    let (closing, tasks) = match close {
        // What was decided stays.
        Close::Ask if matches!(before, Closing::Yes | Closing::BySystem) => (before, Vec::new()),
        Close::Ask if is_unsaved(state) => {
            let stay = Task::Session(SessionTask::StayOpen);
            (Closing::Asked, vec![stay])
        }
        Close::Ask => (Closing::Yes, Vec::new()),
        Close::Save => (Closing::WhenSaved, session::save(state, false)),
        Close::Discard => (Closing::Yes, vec![Task::Quit]),
        Close::Stay => (Closing::No, Vec::new()),
        Close::BySystem => (Closing::BySystem, vec![Task::Quit]),
    };
    state.session.closing = closing;
    tasks
}

/// The session was written: the window closes where that was waited for and nothing has changed since.
pub(crate) fn saved(state: &mut State) -> Vec<Task> {
    match state.session.closing {
        Closing::Asked | Closing::WhenSaved if !is_unsaved(state) => {
            state.session.closing = Closing::Yes;
            vec![Task::Quit]
        }
        Closing::WhenSaved => {
            state.session.closing = Closing::Asked;
            Vec::new()
        }
        _ => Vec::new(),
    }
}

/// The session was not written: the window stays open.
pub(crate) fn not_saved(state: &mut State) {
    if state.session.closing == Closing::WhenSaved {
        state.session.closing = Closing::No;
    }
}
