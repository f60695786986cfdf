//! Reducer of the library: how the state changes when a folder is opened, looked at and stepped through.

use crate::app::msg::Task;
use crate::app::msg::library::{LibraryMsg, LibraryTask};
use crate::app::reduce::{folder_fit, memory, notify, show};
use crate::app::state::State;
use crate::app::state::job::CancelFlag;
use crate::app::state::library::{FileKind, Folder, FolderFile, Scan};
use crate::app::state::notice::Severity;
use crate::app::state::prefs::MemoryLimit;
use crate::files;
use crate::files::fits::MaterialFits;
use crate::files::folder::{FileContent, shown_name};
use crate::fit::Variant;
use std::path::{Path, PathBuf};

/// Changes the state.
pub(crate) fn apply(state: &mut State, msg: LibraryMsg) -> Vec<Task> {
    match msg {
        LibraryMsg::Open(path) => return open(state, &path),
        LibraryMsg::Close => close(state),
        LibraryMsg::Listed { number, result } => listed(state, number, result),
        LibraryMsg::Seen { number, seen } => {
            for (index, result) in seen {
                see(state, number, index, result);
            }
            return show_first(state);
        }
        LibraryMsg::Examined {
            number,
            index,
            result,
        } => {
            if let Some(file) = file_mut(state, number, index) {
                file.kind = match result {
                    Ok(examined) => FileKind::Measured(Some(examined)),
                    Err(reason) => FileKind::Other(reason),
                };
            }
        }
        LibraryMsg::Scanned { number } => {
            if let Some(folder) = folder_mut(state, number) {
                folder.scan = Scan::Done;
            }
        }
        LibraryMsg::Search(text) => state.library.search = text,
        LibraryMsg::Sort(sort) => {
            state.library.sort = sort;
            state.library.reveal += 1;
        }
        LibraryMsg::Show { path, keep } => return show::show_file(state, path, keep),
        LibraryMsg::Step(by) => return show::step(state, by),
        LibraryMsg::Keep => show::keep_open(state),
        LibraryMsg::SetLimit(mib) => state.prefs.memory = MemoryLimit(mib),
        LibraryMsg::Fit { number, update } => folder_fit::update(state, number, update),
    }
    Vec::new()
}

fn open(state: &mut State, path: &Path) -> Vec<Task> {
    let path = files::absolute(path);
    close(state);
    state.prefs.remember(path.clone());
    state.prefs.folder = Some(path.clone());
    let (number, cancel) = (state.fresh_id(), CancelFlag::default());
    state.library.folder = Some(Folder {
        number,
        path: path.clone(),
        files: Vec::new(),
        scan: Scan::Listing,
        cancel: cancel.clone(),
    });
    vec![Task::Library(LibraryTask::Scan {
        number,
        path,
        cancel,
        hold: state.library.hold.clone(),
    })]
}

pub(crate) fn close(state: &mut State) {
    if let Some(cursor) = state.library.cursor.take()
        && state.position_of_file(&cursor).is_none()
    {
        memory::cancel_pending(state);
    }
    let library = &mut state.library;
    library.folder = None;
    library.search.clear();
}

fn folder_mut(state: &mut State, number: u64) -> Option<&mut Folder> {
    let folder = state.library.folder.as_mut();
    folder.filter(|folder| folder.number == number)
}

fn file_mut(state: &mut State, number: u64, index: usize) -> Option<&mut FolderFile> {
    folder_mut(state, number)?.files.get_mut(index)
}

fn listed(state: &mut State, number: u64, result: Result<Vec<PathBuf>, String>) {
    let Some(folder) = folder_mut(state, number) else {
        return;
    };
    match result {
        Ok(paths) => {
            let file = |path: PathBuf| FolderFile {
                name: shown_name(&path),
                path,
                kind: FileKind::Unknown,
            };
            folder.files = paths.into_iter().map(file).collect();
            folder.scan = Scan::Looking;
        }
        Err(reason) => {
            state.library.folder = None;
            notify(state, Severity::Error, reason);
        }
    }
}

fn see(state: &mut State, number: u64, index: usize, result: Result<FileContent, String>) {
    let Some(file) = file_mut(state, number, index) else {
        return;
    };
    match result {
        Ok(FileContent::Measured) => file.kind = FileKind::Measured(None),
        Ok(FileContent::Models(all)) => {
            file.kind = FileKind::Models(all.len());
            for fits in &all {
                take_fits(state, fits);
            }
        }
        Err(reason) => file.kind = FileKind::Other(reason),
    }
}

/// Keeps the fits of a fit file for the measured files of the folder that it names. What was fitted here stays.
fn take_fits(state: &mut State, fits: &MaterialFits) {
    let library = &mut state.library;
    let Some(folder) = &library.folder else {
        return;
    };
    let here = |place: &&PathBuf| folder.files.iter().any(|file| file.path == **place);
    let Some(path) = fits.places.iter().find(here) else {
        return;
    };
    for record in fits.entries.iter().filter_map(|entry| entry.fit.as_ref()) {
        let variant = Variant::from(&record.brdf);
        let kept = library.fits.get(path);
        let known =
            kept.is_some_and(|kept| kept.iter().any(|fit| Variant::from(&fit.brdf) == variant));
        if !known {
            library.keep_fit(path, record.clone());
        }
    }
}

/// Shows the first material of a folder where the window is empty.
fn show_first(state: &mut State) -> Vec<Task> {
    let empty = state.scene.opened.is_empty() && state.jobs.is_empty();
    if !empty || state.library.cursor.is_some() || state.library.pending.is_some() {
        return Vec::new();
    }
    match state.library.steps().first() {
        Some(first) => show::show_file(state, first.clone(), false),
        None => Vec::new(),
    }
}
