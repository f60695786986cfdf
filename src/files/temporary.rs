//! A file that has no place yet: it is written unseen, and put in its place when it is whole.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// Begin of the names under which unfinished files lie where the system has no unnamed ones.
pub const PREFIX: &str = ".grazing-";

/// A file without a place. It is gone when it is dropped.
pub(super) enum Temporary {
    /// Without a name: nothing is left of it, however the process ends.
    #[cfg(target_os = "linux")]
    Unnamed { file: File, folder: PathBuf },
    /// With a name in the folder.
    Named(Named),
}

impl Temporary {
    /// An empty file on the file system of a folder.
    ///
    /// # Errors
    /// Those of the system.
    pub fn create_in(folder: &Path) -> io::Result<Self> {
        #[cfg(target_os = "linux")]
        if let Ok(file) = unnamed::create_in(folder) {
            let folder = folder.to_owned();
            return Ok(Self::Unnamed { file, folder });
        }
        // No unnamed files here (NFS, some file systems of containers), or the folder cannot be written: that says it best.
        Named::create_in(folder).map(Self::Named)
    }

    /// The open file.
    pub fn file(&mut self) -> &mut File {
        match self {
            #[cfg(target_os = "linux")]
            Self::Unnamed { file, .. } => file,
            Self::Named(named) => named.file.as_file_mut(),
        }
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// `AlreadyExists` where there is a file and it is not to be replaced.
    pub fn persist(self, target: &Path, replace: bool) -> io::Result<()> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Unnamed { file, folder } => {
                unnamed::persist(&file, &folder.join(PREFIX), target, replace)
            }
            Self::Named(named) => named.persist(target, replace),
        }
    }
}

/// Files with names that are not finished, to be removed where the process is told to end.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes what is not finished. To be called right before the process ends in the middle of its work: nothing gets a name
/// any more, as whoever is about to give one waits for ever.
pub fn remove_unfinished() {
    let unfinished = unfinished();
    for path in &*unfinished {
        // One that is gone is as it should be.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(unfinished);
}

/// A temporary file with a name.
pub(super) struct Named {
    file: NamedTempFile,
    listed: Listed,
}

/// A path among the unfinished ones.
struct Listed(PathBuf);

impl Listed {
    fn new(path: &Path) -> Self {
        unfinished().insert(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Listed {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

impl Named {
    fn create_in(folder: &Path) -> io::Result<Self> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX);
        // Otherwise a temporary file is for its owner only.
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let file = builder.tempfile_in(folder)?;
        let listed = Listed::new(file.path());
        Ok(Self { file, listed })
    }

    fn persist(self, target: &Path, replace: bool) -> io::Result<()> {
        let Self { file, listed } = self;
        let placed = if replace {
            file.persist(target)
        } else {
            file.persist_noclobber(target)
        };
        drop(listed);
        placed.map(drop).map_err(|error| error.error)
    }
}

/// Unnamed files of Linux: made by `O_TMPFILE`, named by a link when they are whole.
#[cfg(target_os = "linux")]
mod unnamed {
    use super::Listed;
    use rustix::fs::{AtFlags, CWD, OFlags, linkat};
    use std::fs::{self, File};
    use std::io;
    use std::os::fd::AsRawFd as _;
    use std::os::unix::fs::OpenOptionsExt as _;
    use std::path::Path;

    /// Names that are tried for a link that replaces a file.
    const TRIES: u32 = 100;

    pub fn create_in(folder: &Path) -> io::Result<File> {
        let mut options = File::options();
        options.read(true).write(true).mode(0o666);
        options.custom_flags(OFlags::TMPFILE.bits() as i32);
        options.open(folder)
    }

    /// A link never replaces a file, so it gets a name first that begins with `beside`, and is renamed at once.
    pub fn persist(file: &File, beside: &Path, target: &Path, replace: bool) -> io::Result<()> {
        let linked = link(file, target);
        let exists = |result: &io::Result<()>| {
            result
                .as_ref()
                .is_err_and(|error| error.kind() == io::ErrorKind::AlreadyExists)
        };
        if !replace || !exists(&linked) {
            return linked;
        }
        for k in 0..TRIES {
            let mut named = beside.as_os_str().to_owned();
            named.push(format!("{}-{k}", std::process::id()));
            let beside = Path::new(&named);
            let _listed = Listed::new(beside);
            let linked = link(file, beside);
            if exists(&linked) {
                continue;
            }
            linked?;
            return fs::rename(beside, target).inspect_err(|_| {
                let _ = fs::remove_file(beside);
            });
        }
        linked
    }

    fn link(file: &File, target: &Path) -> io::Result<()> {
        let open = format!("/proc/self/fd/{}", file.as_raw_fd());
        Ok(linkat(CWD, open, CWD, target, AtFlags::SYMLINK_FOLLOW)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder").flatten();
        let mut names: Vec<String> = entries
            .map(|entry| entry.file_name().to_string_lossy().into())
            .collect();
        names.sort();
        names
    }

    /// Every kind of temporary file that works here.
    fn kinds(folder: &Path) -> Vec<Temporary> {
        let named = Named::create_in(folder).map(Temporary::Named);
        vec![
            Temporary::create_in(folder).expect("is made"),
            named.expect("is made"),
        ]
    }

    #[test]
    fn every_kind_takes_its_place_whole_and_replaces_only_what_it_may() {
        let folder = tempfile::tempdir().expect("a folder");
        let target = folder.path().join("out.txt");
        for (k, mut file) in kinds(folder.path()).into_iter().enumerate() {
            write!(file.file(), "first {k}").expect("written");
            assert_eq!(target.exists(), k > 0, "it is not in its place yet");
            file.persist(&target, k > 0).expect("is placed");
            let text = fs::read_to_string(&target).expect("is there");
            assert_eq!(text, format!("first {k}"));
        }
        for (k, mut file) in kinds(folder.path()).into_iter().enumerate() {
            write!(file.file(), "second {k}").expect("written");
            let refused = file.persist(&target, false).expect_err("there is one");
            assert_eq!(refused.kind(), io::ErrorKind::AlreadyExists);
        }
        for (k, mut file) in kinds(folder.path()).into_iter().enumerate() {
            write!(file.file(), "third {k}").expect("written");
            file.persist(&target, true).expect("is placed");
            let text = fs::read_to_string(&target).expect("is there");
            assert_eq!(text, format!("third {k}"));
        }
        assert_eq!(names(folder.path()), ["out.txt"]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_that_is_written_has_no_name() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut file = Temporary::create_in(folder.path()).expect("is made");
        write!(file.file(), "half").expect("written");
        assert_eq!(names(folder.path()), [""; 0]);
    }

    #[test]
    fn what_has_a_name_and_is_not_finished_goes_when_the_process_is_told_to_end() {
        let folder = tempfile::tempdir().expect("a folder");
        let named = Named::create_in(folder.path()).expect("is made");
        let path = named.file.path().to_owned();
        assert!(unfinished().contains(&path) && path.exists());
        // Another test may have some under way: those must stay, so this is not `remove_unfinished`.
        let listed = unfinished().take(&path).expect("is listed");
        fs::remove_file(listed).expect("is removed");
        drop(named);
        assert_eq!(names(folder.path()), [""; 0]);
    }
}
