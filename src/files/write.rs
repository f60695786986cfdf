//! Atomic writing of whole files.

use super::error::FileError;
use super::paths::followed;
use super::temporary::Temporary;
use std::fs;
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

/// A file that is being written. Some formats have parts that are known only at the end, and go back to fill them in.
pub trait WriteSeek: Write + Seek {}

impl<T: Write + Seek> WriteSeek for T {}

/// Writes a file out of sight and puts it in its place when it is complete: no half-written file is ever visible, and an
/// existing file is kept when anything fails. An existing file is refused unless `force`.
///
/// # Errors
/// Says in one line what is wrong and, last, the path.
pub fn write_atomically(
    path: &Path,
    force: bool,
    write: impl FnOnce(&mut dyn WriteSeek) -> io::Result<()>,
) -> Result<(), FileError> {
    prepare_and_fill(path, force, write)?.place()
}

/// Writes a file out of sight, down to the disk, for [`Whole::place`].
///
/// # Errors
/// Errors of [`write_atomically`].
pub fn prepare_and_fill(
    path: &Path,
    force: bool,
    write: impl FnOnce(&mut dyn WriteSeek) -> io::Result<()>,
) -> Result<Whole, FileError> {
    let failed = |error: &io::Error| cannot_write(path, error);
    let (target, before, mut file) = prepare(path, force)?;
    let mut buffered = BufWriter::new(file.file());
    write(&mut buffered)
        .and_then(|()| buffered.flush())
        .map_err(|error| failed(&error))?;
    drop(buffered);
    file.file().sync_all().map_err(|error| failed(&error))?;
    if let Some(before) = before.filter(|_| force) {
        let permissions = before.permissions();
        file.file()
            .set_permissions(permissions)
            .map_err(|error| failed(&error))?;
    }
    Ok(Whole {
        file,
        path: path.to_owned(),
        target,
        force,
    })
}

/// A file that is complete and not yet in its place. Dropped, nothing is left of it.
pub struct Whole {
    file: Temporary,
    path: PathBuf,
    target: PathBuf,
    force: bool,
}

impl Whole {
    /// Puts the file in its place.
    ///
    /// # Errors
    /// Errors of [`write_atomically`].
    pub fn place(self) -> Result<(), FileError> {
        // Somebody may have been faster: looking first is not enough.
        self.file
            .persist(&self.target, self.force)
            .map_err(|error| match error.kind() {
                io::ErrorKind::AlreadyExists => exists(&self.path),
                _ => cannot_write(&self.path, &error),
            })
    }
}

fn cannot_write(path: &Path, error: &io::Error) -> FileError {
    FileError::io(path, "cannot write the file", error)
}

/// Checks whether [`write_atomically`] could begin, as far as is known without writing: for an error before long work.
///
/// # Errors
/// Errors of [`write_atomically`].
pub fn check_writable(path: &Path, force: bool) -> Result<(), FileError> {
    prepare(path, force).map(|_| ())
}

fn exists(path: &Path) -> FileError {
    FileError::new(path, "the file exists already; --force replaces it")
}

/// Canonical path to write to, metadata of an existing file, and an empty file without a place.
fn prepare(
    path: &Path,
    force: bool,
) -> Result<(PathBuf, Option<fs::Metadata>, Temporary), FileError> {
    // A link stays one: its target is replaced, or made where there is none.
    let target = fs::canonicalize(path).unwrap_or_else(|_| followed(path));
    match fs::symlink_metadata(&target) {
        Ok(found) if found.is_symlink() => {
            let what = "the link leads to itself; remove it or choose another name";
            return Err(FileError::new(path, what));
        }
        Err(error) if error.kind() == io::ErrorKind::InvalidFilename => {
            let what = "the name of the file is too long; choose a shorter one";
            return Err(FileError::new(path, what));
        }
        _ => {}
    }
    let before = fs::metadata(&target).ok();
    if let Some(before) = &before {
        if before.is_dir() {
            return Err(FileError::new(path, "this is a directory; expected a file"));
        }
        if !before.is_file() {
            return Err(FileError::new(
                path,
                "this is a device or a pipe; expected a regular file",
            ));
        }
        if !force {
            return Err(exists(path));
        }
    }
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let file = Temporary::create_in(folder).map_err(|error| {
        if folder.is_dir() {
            FileError::io(path, "cannot write the file", &error)
        } else {
            FileError::new(path, "there is no directory for the file; make it first")
        }
    })?;
    Ok((target, before, file))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder");
        entries
            .map(|entry| {
                entry
                    .expect("an entry")
                    .file_name()
                    .to_string_lossy()
                    .into()
            })
            .collect()
    }

    #[test]
    fn a_failure_leaves_what_was_there() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("out.csv");
        write_atomically(&path, false, |w| w.write_all(b"first")).expect("is written");
        let failure = write_atomically(&path, true, |w| {
            w.write_all(b"half")?;
            Err(io::Error::other("the machine is tired"))
        });
        let said = failure.expect_err("fails").to_string();
        assert!(
            said.contains("tired") && said.ends_with("out.csv"),
            "{said}"
        );
        assert_eq!(fs::read(&path).expect("is there"), b"first");
        let said = write_atomically(&path, false, |w| w.write_all(b"second"))
            .expect_err("exists")
            .to_string();
        assert!(said.contains("exists already"), "{said}");
        assert_eq!(fs::read(&path).expect("is there"), b"first");
        write_atomically(&path, true, |w| w.write_all(b"third")).expect("is forced");
        assert_eq!(fs::read(&path).expect("is there"), b"third");
        assert!(check_writable(&path, false).is_err() && check_writable(&path, true).is_ok());
        assert_eq!(fs::read(&path).expect("is there"), b"third");
        assert_eq!(names(folder.path()), ["out.csv"], "nothing is left behind");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_nothing_is_written_through_and_a_circle_is_named_at_once() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        symlink("next", path("link")).expect("a link");
        symlink("target.csv", path("next")).expect("a link");
        for force in [false, true] {
            check_writable(&path("link"), force).expect("can be written");
            write_atomically(&path("link"), force, |w| w.write_all(b"new")).expect("is written");
            assert_eq!(fs::read(path("target.csv")).expect("is there"), b"new");
            assert!(path("link").is_symlink() && path("next").is_symlink());
            fs::remove_file(path("target.csv")).expect("is removed");
        }
        symlink("nowhere/target.csv", path("lost")).expect("a link");
        let said = check_writable(&path("lost"), true).expect_err("no folder");
        assert!(said.to_string().contains("no directory"), "{said}");
        symlink("circle", path("circle")).expect("a link");
        let said = check_writable(&path("circle"), true).expect_err("a circle");
        assert!(said.to_string().contains("leads to itself"), "{said}");
    }

    #[test]
    fn a_name_that_is_too_long_is_found_before_anything_is_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("n".repeat(300));
        let said = check_writable(&path, false).expect_err("is too long");
        assert!(said.to_string().contains("too long"), "{said}");
    }

    #[test]
    fn a_missing_folder_is_named() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("no/out.csv");
        let said = write_atomically(&path, false, |_| Ok(()))
            .expect_err("fails")
            .to_string();
        assert!(said.contains("no directory") && said.ends_with("out.csv"));
        let early = check_writable(&path, false).expect_err("fails");
        assert_eq!(early.to_string(), said);
    }
}
