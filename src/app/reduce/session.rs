//! Reducer of sessions: how the state changes when they are saved, opened and looked for.

use crate::app::msg::Task;
use crate::app::msg::session::{SessionMsg, SessionTask};
use crate::app::reduce::{closing, open_session};
use crate::app::session::file::SessionFile;
use crate::app::state::State;
use crate::app::state::material::{MaterialId, Presence};
use crate::app::state::session_mark::SessionMark;
use crate::files::names::short;
use crate::files::session;
use crate::files::session::ENDING;

/// Changes the state.
pub(crate) fn apply(state: &mut State, msg: SessionMsg) -> Vec<Task> {
    match msg {
        SessionMsg::Read { job, path, found } => {
            return open_session::open(state, job, &path, *found);
        }
        SessionMsg::Saved { number, path, mark } => {
            state.prefs.remember(path.clone());
            state.session.files.insert(number, path);
            state.session.saved.insert(number, *mark);
            return closing::saved(state);
        }
        SessionMsg::NotSaved => closing::not_saved(state),
        SessionMsg::Close(close) => return closing::close(state, close),
        SessionMsg::Locate(id) => return locate(state, id),
        SessionMsg::Located(found) => return open_session::located(state, found),
        SessionMsg::Skip { all } => skip(state, all),
        SessionMsg::Crashed(crashed) => state.session.crashed = crashed,
        SessionMsg::Restore => return open_session::restore(state),
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
pub(crate) fn save(state: &State, ask: bool) -> Vec<Task> {
    let number = state.scene.session;
    let file = state.session.files.get(&number);
    let name = match file {
        Some(file) => session::name(file),
        None => state
            .current()
            .map_or("session".into(), |(material, _)| material.name.clone()),
    };
    // What no file system takes.
    let name = short(&name).replace(['/', '\\', ':'], "-");
    vec![Task::Session(SessionTask::Save {
        number,
        session: Box::new(SessionFile::of(state)),
        mark: Box::new(SessionMark::of(state)),
        to: file.filter(|_| !ask).cloned(),
        name: format!("{name}{ENDING}"),
    })]
}

fn locate(state: &mut State, id: MaterialId) -> Vec<Task> {
    let lost = |id: &MaterialId| {
        let material = state.materials.get(id)?;
        let source = material.source.as_ref()?;
        let lost = material.presence == Presence::Missing;
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
