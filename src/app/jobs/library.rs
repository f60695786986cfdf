//! Tasks of the library.

use crate::app::jobs::dialogs::{Picker, Purpose, ask, ask_and_write};
use crate::app::jobs::scan::Scanner;
use crate::app::jobs::{Jobs, folder_fit};
use crate::app::msg::Msg;
use crate::app::msg::library::{LibraryMsg, LibraryTask};
use crate::app::msg::work::SendMsg;
use crate::files::fits::write_json;
use std::sync::Arc;

/// Starts a task. None waits here.
pub fn start(task: LibraryTask, jobs: &Jobs, picker: &Picker) {
    match task {
        LibraryTask::Scan {
            number,
            path,
            cancel,
            hold,
        } => Scanner {
            number,
            cancel,
            hold,
            jobs: jobs.clone(),
        }
        .start(path),
        LibraryTask::Fit(fit) => folder_fit::start(*fit, jobs),
        LibraryTask::Pick => {
            let folder = Arc::clone(&picker.folder);
            let open = |path, send: &SendMsg| send(Msg::Library(LibraryMsg::Open(path)));
            ask(
                jobs,
                picker,
                "asking for a folder",
                Purpose::Open,
                move || folder(),
                open,
            );
        }
        LibraryTask::Save(fits) => {
            ask_and_write(jobs, picker, "fits.json".into(), move |file| {
                write_json(&fits, file)
            });
        }
    }
}
