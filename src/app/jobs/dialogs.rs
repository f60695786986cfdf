//! File dialogs, and work on the files that are chosen in them.

#[cfg(target_os = "linux")]
mod service;

use crate::app::jobs::Jobs;
use crate::app::msg::Msg;
use crate::app::msg::work::{SendMsg, Work};
use crate::app::state::notice::Severity;
use crate::files;
use crate::files::session::ENDING;
use crate::quote;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// A dialog that is gone sooner was never there: nobody cancels so fast, and the library does not tell the two apart.
const GONE_AT_ONCE: Duration = Duration::from_millis(250);

/// Time after which a dialog that is not in front may not have come at all.
const LATE: Duration = Duration::from_secs(3);

/// Use of a dialog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Choosing what to open.
    Open,
    /// Choosing where to save.
    Save,
}

/// Why there is no dialog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoDialog {
    /// The system has none.
    Missing,
    /// The desktop's service for dialogs is there and does not answer.
    Silent,
}

impl Purpose {
    fn none(self, why: NoDialog) -> String {
        let what = match why {
            NoDialog::Missing => {
                "No file dialog answered; install one: sudo apt-get install -y zenity."
            }
            NoDialog::Silent => {
                "The desktop's file dialog does not answer; logging in again often helps."
            }
        };
        self.with_way_out(what)
    }

    fn late(self) -> String {
        self.with_way_out(
            "The file dialog has not come to the front; it may be behind this window.",
        )
    }

    fn with_way_out(self, what: &str) -> String {
        match self {
            Self::Open => format!("{what} Open path… and dropping files work without it."),
            Self::Save => what.into(),
        }
    }
}

pub(crate) type SavePicker = dyn Fn(&str) -> Option<PathBuf> + Send + Sync;

/// Ways to ask a person for files; a test hands its own.
#[derive(Clone)]
pub struct Picker {
    /// Waits until a dialog can come. Asked before one is.
    pub ready: Arc<dyn Fn() -> Result<(), NoDialog> + Send + Sync>,
    /// Asks for files to open; empty where cancelled.
    pub open: Arc<dyn Fn() -> Vec<PathBuf> + Send + Sync>,
    /// Asks for a folder.
    pub folder: Arc<dyn Fn() -> Option<PathBuf> + Send + Sync>,
    /// Asks where to write, given a proposed name.
    pub save: Arc<SavePicker>,
}

impl Picker {
    /// The system's file dialogs.
    pub fn system() -> Self {
        Self {
            #[cfg(target_os = "linux")]
            ready: Arc::new(service::ready),
            #[cfg(not(target_os = "linux"))]
            ready: Arc::new(|| Ok(())),
            open: Arc::new(|| {
                rfd::FileDialog::new()
                    .set_title("Open materials")
                    .add_filter(
                        "MERL, fit files, sessions and figures",
                        &["binary", "json", "svg", "pdf", "png"],
                    )
                    .add_filter("All files", &["*"])
                    .pick_files()
                    .unwrap_or_default()
            }),
            folder: Arc::new(|| {
                rfd::FileDialog::new()
                    .set_title("Open folder")
                    .pick_folder()
            }),
            save: Arc::new(|name| {
                let mut dialog = rfd::FileDialog::new().set_file_name(name);
                if let Some(kind) = SAVED.iter().find(|kind| name.ends_with(kind.ending)) {
                    let extension = kind.ending.rsplit('.').next().unwrap_or_default();
                    dialog = dialog
                        .set_title(kind.title)
                        .add_filter(kind.filter, &[extension]);
                }
                dialog.save_file()
            }),
        }
    }
}

/// Words of the dialog for saving a kind of file.
struct SavedKind {
    ending: &'static str,
    title: &'static str,
    filter: &'static str,
}

const SAVED: [SavedKind; 11] = [
    saved(ENDING, "Save session", "Session"),
    saved(".json", "Save fits", "Fit file"),
    saved(".png", "Save picture", "PNG picture"),
    saved(".svg", "Export figure", "SVG figure"),
    saved(".pdf", "Export figure", "PDF figure"),
    saved(".csv", "Export figure", "CSV table"),
    saved(".exr", "Export figure", "EXR picture"),
    saved(".binary", "Export model", "MERL file"),
    saved(".brdf", "Export model", "Disney BRDF"),
    saved(".wgsl", "Export model", "WGSL text"),
    saved(".glsl", "Export model", "GLSL text"),
];

const fn saved(ending: &'static str, title: &'static str, filter: &'static str) -> SavedKind {
    SavedKind {
        ending,
        title,
        filter,
    }
}

/// Asks for files, a folder or a place to write in the background, and does something with the answer where there is one.
/// Says where there is no dialog, and where it has not come to the front for a while.
pub fn ask<T: Send + 'static>(
    jobs: &Jobs,
    picker: &Picker,
    doing: &str,
    purpose: Purpose,
    dialog: impl FnOnce() -> Option<T> + Send + 'static,
    answered: impl FnOnce(T, &SendMsg) + Send + 'static,
) {
    let answered = move |answer: Option<T>, send: &SendMsg| {
        if let Some(answer) = answer {
            answered(answer, send);
        }
    };
    ask_and_hear(jobs, picker, doing, purpose, dialog, answered);
}

/// Asks as [`ask`] does, and does something also where there is no answer.
pub fn ask_and_hear<T: Send + 'static>(
    jobs: &Jobs,
    picker: &Picker,
    doing: &str,
    purpose: Purpose,
    dialog: impl FnOnce() -> Option<T> + Send + 'static,
    answered: impl FnOnce(Option<T>, &SendMsg) + Send + 'static,
) {
    let (answer, waits) = channel::<()>();
    let ready = Arc::clone(&picker.ready);
    jobs.start(Work::new(doing, move |send| {
        let chosen = ready().and_then(|()| {
            let asked = Instant::now();
            match dialog() {
                None if asked.elapsed() < GONE_AT_ONCE => Err(NoDialog::Missing),
                chosen => Ok(chosen),
            }
        });
        drop(answer);
        match chosen {
            Ok(chosen) => answered(chosen, send),
            Err(why) => {
                send(error(purpose.none(why)));
                answered(None, send);
            }
        }
    }));
    let ctx = jobs.sender().ctx().clone();
    jobs.start(Work::new("waiting for a file dialog", move |send| {
        // A dialog that is there has the keys; while this window has them there is none in front.
        if waits.recv_timeout(LATE) == Err(RecvTimeoutError::Timeout)
            && ctx.input(|input| input.focused)
        {
            send(Msg::Notify(Severity::Info, purpose.late()));
        }
    }));
}

fn error(text: String) -> Msg {
    Msg::Notify(Severity::Error, text)
}

/// Asks where to, proposing a name, writes the file there and says so.
pub fn ask_and_write(
    jobs: &Jobs,
    picker: &Picker,
    name: String,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()> + Send + 'static,
) {
    ask_and_do(jobs, picker, name, move |path| {
        // The dialog has asked about an existing file.
        files::write_atomically(&path, true, |file| write(file))
            .map_err(|error| error.to_string())?;
        Ok(path)
    });
}

/// Asks where to, proposing a name, does the work there and says what it has saved.
pub fn ask_and_do(
    jobs: &Jobs,
    picker: &Picker,
    name: String,
    work: impl FnOnce(PathBuf) -> Result<PathBuf, String> + Send + 'static,
) {
    let (save, doing) = (Arc::clone(&picker.save), format!("saving {name}"));
    let answered = move |path, send: &SendMsg| send(saved_notice(work(path)));
    ask(
        jobs,
        picker,
        &doing,
        Purpose::Save,
        move || save(&name),
        answered,
    );
}

/// Says what was saved, or why nothing was.
pub fn saved_notice(saved: Result<PathBuf, String>) -> Msg {
    match saved {
        Ok(path) => Msg::Notify(Severity::Info, format!("Saved {}", quote::path(&path))),
        Err(reason) => error(reason),
    }
}
