//! What sessions ask to be done in the background.

use super::{SessionFile, SessionMsg, SessionTask};
use crate::app::jobs::Outbox;
use crate::app::state::Level;
use crate::app::tasks::{NO_DIALOG, Picker, in_thread, no_dialog};
use crate::app::update::Msg;
use crate::files::session::ENDING;
use crate::files::{self, FileError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Starts a task. None waits here.
pub(in crate::app) fn start(task: SessionTask, outbox: &Outbox, picker: &Picker) {
    let told = outbox.clone();
    match task {
        SessionTask::Save {
            number,
            session,
            to,
            name,
        } => {
            let save = Arc::clone(&picker.save);
            in_thread(outbox, "save dialog", move || {
                let (path, asked) = match to {
                    Some(path) => (path, false),
                    None => match save(&name) {
                        Some(path) => (path, true),
                        None => return,
                    },
                };
                match write(*session, &path, asked) {
                    Ok(path) => {
                        let text = format!("Saved {}", path.display());
                        told.send(Msg::Session(SessionMsg::Saved { number, path }));
                        told.send(Msg::Notify(Level::Info, text));
                    }
                    Err(error) => told.send(Msg::Notify(Level::Error, error.to_string())),
                }
            });
        }
        SessionTask::Locate(wanted) => {
            let open = Arc::clone(&picker.open);
            in_thread(outbox, "open dialog", move || {
                let asked = Instant::now();
                match open().into_iter().next() {
                    Some(path) => {
                        let found = beside(&path, wanted);
                        told.send(Msg::Session(SessionMsg::Located(found)));
                    }
                    None if asked.elapsed() < NO_DIALOG => told.send(no_dialog()),
                    None => {}
                }
            });
        }
        SessionTask::Remove(crashed) => {
            in_thread(outbox, "autosave", move || crashed.remove());
        }
    }
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
fn beside<T>(chosen: &Path, wanted: Vec<(T, String)>) -> Vec<(T, PathBuf)> {
    let folder = chosen.parent().unwrap_or(Path::new(""));
    let mut found = Vec::new();
    for (index, (id, path)) in wanted.into_iter().enumerate() {
        let name = path.rsplit(['/', '\\']).next().unwrap_or(&path);
        let here = folder.join(name);
        if index == 0 {
            found.push((id, chosen.to_owned()));
        } else if here.is_file() {
            found.push((id, here));
        }
    }
    found
}
