//! How the library changes as its folder is scanned, searched and sorted.

use crate::app::msg::library::FolderMsg;
use crate::app::reduce::context::Context;
use crate::app::state::library::{FileKind, Folder, FolderFile, Library, Scan};
use crate::app::state::notice::Severity;
use crate::files::fits::MaterialFits;
use crate::files::folder::{FileContent, shown_name};
use crate::fit::Variant;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Changes the library.
pub(crate) fn apply(library: &mut Library, context: &mut Context, msg: FolderMsg) {
    match msg {
        FolderMsg::Listed { number, result } => listed(library, context, number, result),
        FolderMsg::Seen { number, seen } => {
            for (index, result) in seen {
                see(library, number, index, result);
            }
        }
        FolderMsg::Examined {
            number,
            index,
            result,
        } => {
            if let Some(file) = file_mut(library, number, index) {
                file.kind = match result {
                    Ok(examined) => FileKind::Measured(Some(examined)),
                    Err(reason) => FileKind::Other(reason),
                };
            }
        }
        FolderMsg::Scanned { number } => {
            if let Some(folder) = folder_mut(library, number) {
                folder.scan = Scan::Done;
            }
        }
        FolderMsg::Search(text) => library.search = text,
        FolderMsg::Sort(sort) => {
            library.sort = sort;
            library.reveal += 1;
        }
    }
}

fn folder_mut(library: &mut Library, number: u64) -> Option<&mut Folder> {
    let folder = library.folder.as_mut();
    folder.filter(|folder| folder.number == number)
}

fn file_mut(library: &mut Library, number: u64, index: usize) -> Option<&mut FolderFile> {
    folder_mut(library, number)?.files.get_mut(index)
}

fn listed(
    library: &mut Library,
    context: &mut Context,
    number: u64,
    result: Result<Vec<PathBuf>, String>,
) {
    let Some(folder) = folder_mut(library, number) else {
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
            library.folder = None;
            context.notify(Severity::Error, reason);
        }
    }
}

fn see(library: &mut Library, number: u64, index: usize, result: Result<FileContent, String>) {
    let Some(file) = file_mut(library, number, index) else {
        return;
    };
    match result {
        Ok(FileContent::Measured) => file.kind = FileKind::Measured(None),
        Ok(FileContent::Models(all)) => {
            file.kind = FileKind::Models(Some(all.len()));
            take_fits(library, &all);
        }
        Ok(FileContent::ManyModels) => file.kind = FileKind::Models(None),
        Err(reason) => file.kind = FileKind::Other(reason),
    }
}

/// Keeps the fits of a fit file for the measured files of the folder that it names. What was fitted here stays.
fn take_fits(library: &mut Library, all: &[MaterialFits]) {
    let files = library.folder.iter().flat_map(|folder| &folder.files);
    let here: HashSet<PathBuf> = files.map(|file| file.path.clone()).collect();
    for fits in all {
        if let Some(path) = fits.places.iter().find(|place| here.contains(*place)) {
            keep_fits(library, path, fits);
        }
    }
}

fn keep_fits(library: &mut Library, path: &Path, fits: &MaterialFits) {
    for record in fits.entries.iter().filter_map(|entry| entry.fit.as_deref()) {
        let variant = Variant::from(&record.brdf);
        let kept = library.fits.get(path);
        let known =
            kept.is_some_and(|kept| kept.iter().any(|fit| Variant::from(&fit.brdf) == variant));
        if !known {
            library.keep_fit(path, record.clone());
        }
    }
}
