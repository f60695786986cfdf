//! Autosave: the open session, kept for the case that the program does not come to an end of its own.
//!
//! A run has two files in the autosave folder: a lock that it holds as long as it lives, and beside it what is open.
//! A lock that nobody holds is of a run that is gone. Both files go when a person closes the window; when the system
//! ends the run they stay, and the lock says so.

mod left;
mod seen;

use self::left::{BY_SYSTEM, NEW, file_of, remove_restored, runs_before};
use self::seen::{Seen, is_worth_keeping};
use crate::app::jobs::{Jobs, within};
use crate::app::msg::Msg;
use crate::app::msg::work::Work;
use crate::app::session::file::SessionFile;
use crate::app::state::State;
use crate::app::state::notice::Severity;
use crate::app::state::session::Crashed;
use crate::files;
use crate::files::{FileError, Whole};
use std::fs::{self, File};
use std::io::{self, Seek as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Seconds from a change until it is written.
pub const DELAY: f64 = 3.0;

/// Seconds until a write that failed is tried again.
const AGAIN: f64 = 30.0;

/// Longest time that closing waits for the disk. What a slow one has not removed by then is offered at the next start.
const PATIENCE: Duration = Duration::from_millis(300);

/// Longest time that closing waits where the system ends the run and what is open is to be written.
const PATIENCE_TO_KEEP: Duration = Duration::from_secs(2);

/// Keeps the state of this run.
pub struct Autosave {
    run: Arc<Run>,
    /// Locks of runs that are gone, so that no other run offers the same while this one does.
    _gone: Vec<File>,
    /// Whether a thread is writing.
    busy: Arc<AtomicBool>,
    /// Whether the last write failed, which is said once.
    failed: Arc<AtomicBool>,
    /// State that was written last.
    seen: Option<Seen>,
    /// The time of egui at which what has changed is to be written.
    due: Option<f64>,
}

/// The files of this run.
pub struct Run {
    lock: File,
    lock_path: PathBuf,
    file: PathBuf,
    /// Whether the run has ended: then nothing is put in its place any more. Held for moments, never while a disk writes.
    ended: Mutex<bool>,
}

impl Autosave {
    /// Begins to keep this run in a folder, which is made where it is missing. Returns what runs before have left too,
    /// the newest first.
    ///
    /// # Errors
    /// Why nothing can be kept there.
    pub fn start(folder: &Path) -> io::Result<(Self, Vec<Crashed>)> {
        fs::create_dir_all(folder)?;
        let (gone, crashed) = runs_before(folder)?;
        // Held before it has its name: another run must not take it for one that is gone.
        let new = tempfile::Builder::new()
            .prefix("run-")
            .suffix(NEW)
            .tempfile_in(folder)?;
        new.as_file().lock()?;
        let lock_path = new.path().with_extension("lock");
        let run = Run {
            file: file_of(&lock_path),
            lock: new.persist(&lock_path)?,
            lock_path,
            ended: Mutex::default(),
        };
        let own = Self {
            run: Arc::new(run),
            _gone: gone,
            busy: Arc::default(),
            failed: Arc::default(),
            seen: None,
            due: None,
        };
        Ok((own, crashed))
    }

    /// The files of this run, for whoever learns that the system ends it.
    pub fn run(&self) -> Arc<Run> {
        Arc::clone(&self.run)
    }

    /// Writes a little after something has changed, and wakes the window for it. To be called once a frame.
    pub fn tick(&mut self, state: &State, ctx: &egui::Context, jobs: &Jobs) {
        let now = ctx.input(|input| input.time);
        if self.due.is_none() && is_worth_keeping(state) {
            let same = self.seen.as_ref().is_some_and(|seen| seen.is(state));
            let failed = self.failed.load(Ordering::Acquire);
            self.due = match (same, failed) {
                (false, _) => Some(now + DELAY),
                (true, true) => Some(now + AGAIN),
                (true, false) => None,
            };
        }
        let Some(due) = self.due else { return };
        if now < due {
            ctx.request_repaint_after(Duration::from_secs_f64(due - now));
        } else if self.busy.swap(true, Ordering::AcqRel) {
            self.due = Some(now + DELAY);
            ctx.request_repaint_after(Duration::from_secs_f64(DELAY));
        } else {
            self.due = None;
            self.seen = Some(Seen::of(state));
            self.write(state, jobs);
        }
    }

    fn write(&self, state: &State, jobs: &Jobs) {
        let (run, session) = (self.run(), session_of(state));
        let restored = state.session.restored.clone();
        let (busy, failed) = (Busy(Arc::clone(&self.busy)), Arc::clone(&self.failed));
        jobs.start(Work::new("keeping what is open", move |send| {
            let _busy = busy;
            let written = run.write(&session, false);
            let said = failed.swap(written.is_err(), Ordering::AcqRel);
            match written {
                Ok(()) => remove_restored(&restored),
                Err(error) if !said => {
                    send(Msg::Notify(
                        Severity::Error,
                        recovery_is_off(&error.reason()),
                    ));
                }
                Err(_) => {}
            }
        }));
    }

    /// A person closes the window: nothing is left of the run.
    pub fn end(&mut self, state: &State) {
        let (run, restored) = (self.run(), state.session.restored.clone());
        within(PATIENCE, move || {
            run.end();
            remove_restored(&restored);
        });
    }

    /// The system ends the run: what is open stays for the next start.
    pub fn keep(&mut self, state: &State) {
        if !is_worth_keeping(state) {
            return self.end(state);
        }
        let (run, session) = (self.run(), session_of(state));
        let restored = state.session.restored.clone();
        within(PATIENCE_TO_KEEP, move || {
            run.mark_ended_by_system();
            if run.write(&session, true).is_ok() {
                remove_restored(&restored);
            }
        });
    }
}

impl Run {
    /// Writes what is open, unless the run has ended; `last` ends it.
    fn write(&self, session: &SessionFile, last: bool) -> Result<(), FileError> {
        self.place(self.fill(session)?, last)
    }

    /// The slow part, for which nobody has to wait.
    fn fill(&self, session: &SessionFile) -> Result<Whole, FileError> {
        let text = session.text();
        files::prepare_and_fill(&self.file, true, |file| {
            file.write_all(text.map_err(io::Error::from)?.as_bytes())
        })
    }

    fn place(&self, whole: Whole, last: bool) -> Result<(), FileError> {
        let mut ended = self.ended();
        if *ended {
            return Ok(());
        }
        *ended = last;
        whole.place()
    }

    /// Says in the lock that the system ends this run, so that the next one takes it for no crash.
    pub fn mark_ended_by_system(&self) {
        // Where it cannot be said, the words are wrong and nothing is lost.
        let mut lock = &self.lock;
        let said = lock
            .rewind()
            .and_then(|()| lock.write_all(BY_SYSTEM.as_bytes()));
        let _ = said;
    }

    fn end(&self) {
        *self.ended() = true;
        let _ = fs::remove_file(&self.file);
        let _ = self.lock.unlock();
        let _ = fs::remove_file(&self.lock_path);
    }

    fn ended(&self) -> MutexGuard<'_, bool> {
        self.ended.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The open session, with the file that it belongs to.
fn session_of(state: &State) -> SessionFile {
    let mut session = SessionFile::of(state);
    let saved_as = state.session.files.get(&state.scene.session);
    session.saved_as = saved_as.cloned();
    session
}

fn recovery_is_off(why: &str) -> String {
    format!("What is open is not kept for a crash ({why}). Ctrl+S saves it where you can write.")
}

/// Whether a job is writing; no longer when this is dropped, by its end or by a panic.
struct Busy(Arc<AtomicBool>);

impl Drop for Busy {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Release);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_ends_while_the_disk_still_writes_and_nothing_comes_after_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let (autosave, _) = Autosave::start(folder.path()).expect("is kept");
        let run = autosave.run();
        let session = session_of(&State::default());
        run.write(&session, false).expect("is written");
        assert!(run.file.exists());
        let slow = run.fill(&session).expect("is written");
        run.end();
        run.place(slow, false).expect("is no failure");
        let left = fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(left, 0);
    }
}
