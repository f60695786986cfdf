//! Leavings of runs before in the autosave folder.

use crate::app::state::session::{Crashed, DAMAGED};
use crate::files::TEMPORARY_PREFIX;
use crate::files::session::ENDING;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Content of the lock of a run that the system ended.
pub(super) const BY_SYSTEM: &str = "ended by the system\n";

/// Ending of a lock that has not got its name yet.
pub(super) const NEW: &str = ".new";

/// Age from which a file that was not finished is nobody's any more.
const NOBODYS: Duration = Duration::from_secs(3600);

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
        let _ = fs::rename(&self.file, self.file.with_extension(DAMAGED));
        let _ = fs::remove_file(&self.lock);
    }
}

/// Removes the files that were restored, with their locks.
pub(super) fn remove_restored(files: &[PathBuf]) {
    for file in files {
        Crashed {
            file: file.clone(),
            lock: lock_of(file),
            age: None,
            by_system: false,
        }
        .remove();
    }
}

/// The lock beside an autosaved file.
fn lock_of(file: &Path) -> PathBuf {
    // Both parts of the ending go.
    file.with_extension("").with_extension("lock")
}

/// The file that is beside a lock or will be.
pub(super) fn file_of(lock: &Path) -> PathBuf {
    let mut file = lock.with_extension("").into_os_string();
    file.push(ENDING);
    file.into()
}

/// The locks of runs that are gone, now held by this one, and what they have left, the newest first. Files that were not
/// finished go.
pub(super) fn runs_before(folder: &Path) -> io::Result<(Vec<File>, Vec<Crashed>)> {
    let (mut gone, mut crashed) = (Vec::new(), Vec::new());
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if is_nobodys(&path) {
            let _ = fs::remove_file(&path);
        }
        if path.extension().is_none_or(|extension| extension != "lock") {
            continue;
        }
        let Ok(held) = File::options().read(true).write(true).open(&path) else {
            continue;
        };
        // Where locks do not work, every run counts as alive.
        if held.try_lock().is_err() {
            continue;
        }
        let file = file_of(&path);
        if file.is_file() {
            crashed.push(Crashed {
                age: age_of(&file),
                by_system: io::read_to_string(&held).is_ok_and(|text| text == BY_SYSTEM),
                file,
                lock: path,
            });
            gone.push(held);
        } else {
            let _ = fs::remove_file(&path);
        }
    }
    crashed.sort_by_key(|crashed| crashed.age);
    Ok((gone, crashed))
}

/// Whether this was written halfway by a run that is gone.
fn is_nobodys(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let unfinished = name.starts_with(TEMPORARY_PREFIX) || name.ends_with(NEW);
    unfinished && age_of(path).is_some_and(|age| age > NOBODYS)
}

fn age_of(path: &Path) -> Option<Duration> {
    let modified = fs::metadata(path).and_then(|data| data.modified()).ok()?;
    SystemTime::now().duration_since(modified).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_were_not_finished_go_when_they_are_old_and_no_others() {
        let folder = tempfile::tempdir().expect("a folder");
        let old = SystemTime::now() - 2 * NOBODYS;
        for (name, when) in [
            (".grazing-old", old),
            (".grazing-fresh", SystemTime::now()),
            ("run-a.new", old),
            ("notes.txt", old),
        ] {
            let file = File::create(folder.path().join(name)).expect("is made");
            file.set_modified(when).expect("is dated");
        }
        runs_before(folder.path()).expect("is read");
        let left = |name: &str| folder.path().join(name).exists();
        assert!(left("notes.txt") && left(".grazing-fresh"));
        assert!(!left(".grazing-old") && !left("run-a.new"));
    }

    #[test]
    fn a_run_that_the_system_ended_is_told_from_one_that_broke() {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, content) in [("run-a.lock", ""), ("run-b.lock", BY_SYSTEM)] {
            let lock = folder.path().join(name);
            fs::write(file_of(&lock), "{}").expect("is written");
            fs::write(lock, content).expect("is written");
        }
        let (_, left) = runs_before(folder.path()).expect("is read");
        assert_eq!(left.len(), 2);
        for crashed in left {
            assert_eq!(crashed.by_system, crashed.lock.ends_with("run-b.lock"));
        }
    }
}
