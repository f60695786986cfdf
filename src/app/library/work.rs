//! What the library asks to be done in the background.

use super::fit_work::FolderFit;
use super::scan::Scanner;
use super::{Hold, LibraryMsg};
use crate::app::jobs::Outbox;
use crate::app::state::CancelFlag;
use crate::app::tasks::{NO_DIALOG, Picker, ask_and_write, in_thread, no_dialog};
use crate::app::update::Msg;
use crate::files::fits::{FitRecord, write_json};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

/// Something to be done outside the state.
#[derive(Debug)]
pub enum LibraryTask {
    /// Look at the files of a folder.
    Scan {
        number: u64,
        path: PathBuf,
        cancel: CancelFlag,
        hold: Hold,
    },
    /// Fit files, one after the other.
    Fit(Box<FolderFit>),
    /// Ask for a folder to open.
    Pick,
    /// Ask where to, and write these fits.
    Save(Vec<FitRecord>),
}

/// Starts a task. None waits here.
pub(in crate::app) fn start(task: LibraryTask, outbox: &Outbox, picker: &Picker) {
    let outbox = outbox.clone();
    match task {
        LibraryTask::Scan {
            number,
            path,
            cancel,
            hold,
        } => {
            let scanner = Scanner {
                number,
                cancel,
                hold,
                outbox: outbox.clone(),
            };
            in_thread(&outbox, "look at the folder", move || scanner.run(&path));
        }
        LibraryTask::Fit(fit) => {
            let told = outbox.clone();
            in_thread(&outbox, "fit of the folder", move || fit.run(&told));
        }
        LibraryTask::Pick => {
            let folder = Arc::clone(&picker.folder);
            in_thread(&outbox.clone(), "folder dialog", move || {
                let asked = Instant::now();
                match folder() {
                    Some(path) => outbox.send(Msg::Library(LibraryMsg::Open(path))),
                    None if asked.elapsed() < NO_DIALOG => outbox.send(no_dialog()),
                    None => {}
                }
            });
        }
        LibraryTask::Save(fits) => {
            ask_and_write(&outbox, &picker.save, "fits.json".into(), move |file| {
                write_json(&fits, file)
            });
        }
    }
}
