//! Autosave: the open session, kept for the case that the program ends unexpectedly.
//!
//! A run has two files in the autosave folder: a lock that it holds as long as it lives, and beside it what is open.
//! A lock that nobody holds is of a run that is gone. Both files go when a run ends as it should.

use crate::app::jobs::Jobs;
use crate::app::msg::Msg;
use crate::app::msg::work::Work;
use crate::app::session::file::SessionFile;
use crate::app::state::State;
use crate::app::state::fitting::kept::SortBy;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::state::material::{MaterialId, Origin, Presence};
use crate::app::state::notice::Severity;
use crate::app::state::session::{Crashed, DAMAGED};
use crate::files;
use crate::files::session::ENDING;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, SystemTime};
use std::{fs, io};

/// Seconds from a change until it is written.
pub const DELAY: f64 = 3.0;

impl Crashed {
    /// Removes both files.
    pub fn remove(&self) {
        // One that is gone is as it should be; one that stays is offered again.
        let _ = fs::remove_file(&self.file);
        let _ = fs::remove_file(&self.lock);
    }

    /// Puts a damaged file where it is not offered again, and removes the lock.
    pub fn set_aside(&self) {
        // One that cannot be moved is offered again.
        let _ = fs::rename(&self.file, set_aside(&self.file));
        let _ = fs::remove_file(&self.lock);
    }

    fn age_of(path: &Path) -> Option<Duration> {
        let modified = fs::metadata(path).and_then(|data| data.modified()).ok()?;
        SystemTime::now().duration_since(modified).ok()
    }
}

/// Keeps the state of this run.
pub struct Autosave {
    lock: File,
    lock_path: PathBuf,
    file: PathBuf,
    /// Locks of runs that are gone, so that no other run offers the same while this one does.
    _gone: Vec<File>,
    /// Whether the run has ended: then nothing is written any more.
    ended: Arc<Mutex<bool>>,
    /// Whether a thread is writing.
    busy: Arc<AtomicBool>,
    /// Whether the last write failed, which is said once.
    failed: Arc<AtomicBool>,
    /// State that was written last.
    seen: Option<Seen>,
    /// The time of egui at which what has changed is to be written.
    due: Option<f64>,
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
            .suffix(".new")
            .tempfile_in(folder)?;
        new.as_file().lock()?;
        let lock_path = new.path().with_extension("lock");
        let file = file_of(&lock_path);
        let lock = new.persist(&lock_path)?;
        let own = Self {
            lock,
            lock_path,
            file,
            _gone: gone,
            ended: Arc::default(),
            busy: Arc::default(),
            failed: Arc::default(),
            seen: None,
            due: None,
        };
        Ok((own, crashed))
    }

    /// The file that this run writes.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// Writes a little after something has changed, and wakes the window for it. To be called once a frame.
    pub fn tick(&mut self, state: &State, ctx: &egui::Context, jobs: &Jobs) {
        let now = ctx.input(|input| input.time);
        if self.due.is_none() && is_worth_keeping(state) {
            let same = self.seen.as_ref().is_some_and(|seen| seen.is(state));
            self.due = (!same).then_some(now + DELAY);
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
        let mut session = SessionFile::of(state);
        let saved_as = state.session.files.get(&state.scene.session);
        session.saved_as = saved_as.cloned();
        let file = self.file.clone();
        let (ended, busy) = (Arc::clone(&self.ended), Arc::clone(&self.busy));
        let restored = state.session.restored.clone();
        let (busy, failed) = (Busy(busy), Arc::clone(&self.failed));
        jobs.start(Work::new("keeping what is open", move |send| {
            let _busy = busy;
            let ended = ended.lock().unwrap_or_else(PoisonError::into_inner);
            if !*ended {
                let text = session.text();
                let written = files::write_atomically(&file, true, |file| {
                    file.write_all(text.map_err(io::Error::from)?.as_bytes())
                });
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
            }
        }));
    }

    /// The run ends as it should: nothing is left of it. Waits for a write under way.
    pub fn end(&mut self, state: &State) {
        let mut ended = self.ended.lock().unwrap_or_else(PoisonError::into_inner);
        *ended = true;
        let _ = fs::remove_file(&self.file);
        let _ = self.lock.unlock();
        let _ = fs::remove_file(&self.lock_path);
        remove_restored(&state.session.restored);
    }
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

/// Removes the files that were restored, with their locks.
fn remove_restored(files: &[PathBuf]) {
    for file in files {
        let lock = lock_of(file);
        let age = None;
        Crashed {
            file: file.clone(),
            lock,
            age,
        }
        .remove();
    }
}

/// The place of a file that was offered and is damaged.
fn set_aside(file: &Path) -> PathBuf {
    file.with_extension(DAMAGED)
}

/// The lock beside an autosaved file.
fn lock_of(file: &Path) -> PathBuf {
    // Both parts of the ending go.
    file.with_extension("").with_extension("lock")
}

/// The file that is beside a lock or will be.
fn file_of(lock: &Path) -> PathBuf {
    let mut file = lock.with_extension("").into_os_string();
    file.push(ENDING);
    file.into()
}

/// The locks of runs that are gone, now held by this one, and what they have left, the newest first.
fn runs_before(folder: &Path) -> io::Result<(Vec<File>, Vec<Crashed>)> {
    let (mut gone, mut crashed) = (Vec::new(), Vec::new());
    for entry in fs::read_dir(folder)? {
        let lock = entry?.path();
        if lock.extension().is_none_or(|extension| extension != "lock") {
            continue;
        }
        let Ok(held) = File::options().read(true).write(true).open(&lock) else {
            continue;
        };
        // Where locks do not work, every run counts as alive.
        if held.try_lock().is_err() {
            continue;
        }
        let file = file_of(&lock);
        if file.is_file() {
            let age = Crashed::age_of(&file);
            crashed.push(Crashed { file, lock, age });
            gone.push(held);
        } else {
            let _ = fs::remove_file(&lock);
        }
    }
    crashed.sort_by_key(|crashed| crashed.age);
    Ok((gone, crashed))
}

/// Whether there is more than what every start shows.
fn is_worth_keeping(state: &State) -> bool {
    state.history.can_undo()
        || state.session.files.contains_key(&state.scene.session)
        || state
            .materials
            .values()
            .any(|material| matches!(material.origin, Origin::File(_)) || !material.fits.is_empty())
}

/// Parts of the state that a session is made of, to see whether it has changed.
struct Seen {
    scene: crate::app::state::Scene,
    tiles: crate::app::state::layout::Tiles,
    settings: FitSettings,
    keep_optimal: bool,
    sort: SortBy,
    pinned: Option<crate::app::state::probe::Probe>,
    materials: Vec<MaterialMark>,
    saved_as: Option<PathBuf>,
}

/// A material as far as it changes beside the scene: where it is, its fits by their E and tick.
type MaterialMark = (MaterialId, Origin, Presence, Vec<(u64, bool)>);

fn marks(state: &State) -> impl Iterator<Item = MaterialMark> {
    state.scene.opened.iter().filter_map(|opened| {
        let material = state.materials.get(&opened.id)?;
        // A table that comes or goes is no change.
        let lost = match material.presence {
            Presence::Missing => Presence::Missing,
            _ => Presence::Loaded,
        };
        let fits = material.fits.iter();
        let fits = fits.map(|fit| (fit.outcome.errors.total.to_bits(), fit.overlaid));
        Some((opened.id, material.origin.clone(), lost, fits.collect()))
    })
}

impl Seen {
    fn of(state: &State) -> Self {
        Self {
            scene: state.scene.clone(),
            tiles: state.tiles.clone(),
            settings: state.fit.settings.clone(),
            keep_optimal: state.fit.keep_optimal,
            sort: state.fit.sort,
            pinned: state.pinned,
            materials: marks(state).collect(),
            saved_as: state.session.files.get(&state.scene.session).cloned(),
        }
    }

    /// Whether nothing has changed. Asked at each frame.
    fn is(&self, state: &State) -> bool {
        self.scene == state.scene
            && self.tiles == state.tiles
            && self.settings == state.fit.settings
            && (self.keep_optimal, self.sort) == (state.fit.keep_optimal, state.fit.sort)
            && self.pinned == state.pinned
            && self.saved_as.as_ref() == state.session.files.get(&state.scene.session)
            && {
                let mut known = self.materials.iter();
                marks(state).all(|mark| known.next() == Some(&mark)) && known.next().is_none()
            }
    }
}
