//! Tasks of sessions.

use crate::app::jobs::Jobs;
use crate::app::jobs::dialogs::{Picker, Purpose, ask, ask_and_hear, saved_notice};
use crate::app::msg::Msg;
use crate::app::msg::session::{SessionMsg, SessionTask};
use crate::app::msg::work::{SendMsg, Work};
use crate::app::session::file::SessionFile;
use crate::app::state::session_mark::SessionMark;
use crate::files;
use crate::files::FileError;
use crate::files::session::ENDING;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Starts a task. None waits here.
pub fn start(task: SessionTask, jobs: &Jobs, picker: &Picker) {
    match task {
        SessionTask::Save {
            number,
            session,
            mark,
            to: Some(path),
            ..
        } => {
            let save = move |send: &SendMsg| save((number, mark), *session, &path, false, send);
            jobs.start(Work::new("saving the session", save));
        }
        SessionTask::Save {
            number,
            session,
            mark,
            to: None,
            name,
        } => {
            let dialog = Arc::clone(&picker.save);
            let chosen = move |path: Option<PathBuf>, send: &SendMsg| match path {
                Some(path) => save((number, mark), *session, &path, true, send),
                None => send(Msg::Session(SessionMsg::NotSaved)),
            };
            ask_and_hear(
                jobs,
                picker,
                "saving the session",
                Purpose::Save,
                move || dialog(&name),
                chosen,
            );
        }
        SessionTask::Locate(wanted) => {
            let open = Arc::clone(&picker.open);
            let found = move |path: PathBuf, send: &SendMsg| {
                send(Msg::Session(SessionMsg::Located(beside(&path, wanted))));
            };
            let first = move || open().into_iter().next();
            ask(
                jobs,
                picker,
                "asking for a file",
                Purpose::Open,
                first,
                found,
            );
        }
        SessionTask::Remove(crashed) => {
            jobs.start(Work::new("removing what was left", move |_| {
                crashed.remove();
            }));
        }
        SessionTask::StayOpen => {
            let ctx = jobs.sender().ctx();
            ctx.send_viewport_cmd(egui::ViewportCommand::CancelClose);
        }
        SessionTask::SetAside(crashed) => {
            jobs.start(Work::new("keeping what is damaged", move |_| {
                crashed.set_aside();
            }));
        }
    }
}

/// Writes a session, of this number and mark, and says so; `asked` where a dialog was asked for the path.
fn save(
    (number, mark): (u64, Box<SessionMark>),
    session: SessionFile,
    path: &Path,
    asked: bool,
    send: &SendMsg,
) {
    let saved = write(session, path, asked);
    send(Msg::Session(match &saved {
        Ok(path) => SessionMsg::Saved {
            number,
            path: path.clone(),
            mark,
        },
        Err(_) => SessionMsg::NotSaved,
    }));
    send(saved_notice(saved.map_err(|error| error.to_string())));
}

/// Writes a session; returns where. A name without an ending gets that of sessions.
fn write(session: SessionFile, path: &Path, asked: bool) -> Result<PathBuf, FileError> {
    let mut path = files::absolute(path);
    // The dialog has asked about an existing file, if it is this one.
    let mut force = true;
    if asked && path.extension().is_none() {
        path.as_mut_os_string().push(ENDING);
        force = false;
        if path.exists() {
            let what = "the file exists already; choose it in the dialog to replace it";
            return Err(FileError::new(&path, what));
        }
    }
    let text = session.placed(&path).text();
    files::write_atomically(&path, force, |file| {
        file.write_all(text.map_err(io::Error::from)?.as_bytes())
    })?;
    Ok(path)
}

/// The first material is in the file that was chosen; the others where they lie beside it under their names.
fn beside<T>(chosen: &Path, wanted: Vec<(T, PathBuf)>) -> Vec<(T, PathBuf)> {
    let folder = chosen.parent().unwrap_or(Path::new(""));
    let mut found = Vec::new();
    for (index, (id, path)) in wanted.into_iter().enumerate() {
        let here = folder.join(files::last_name(&path));
        if index == 0 {
            found.push((id, chosen.to_owned()));
        } else if here.is_file() {
            found.push((id, here));
        }
    }
    found
}
