//! File dialogs, and work on the files that are chosen in them.

use crate::app::jobs::Jobs;
use crate::app::msg::Msg;
use crate::app::msg::work::{SendMsg, Work};
use crate::app::state::notice::Severity;
use crate::files;
use crate::files::session::ENDING;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A dialog that is gone sooner was never there: nobody cancels so fast, and the library does not tell the two apart.
const NO_DIALOG: Duration = Duration::from_millis(250);

/// Said where a dialog for opening did not open.
pub const NOT_OPENED: &str = "No file dialog answered; install one: sudo apt-get install -y zenity. Open path… and dropping files work without it.";
/// Said where a dialog for saving did not open.
pub const NOT_SAVED: &str = "No file dialog answered; install one: sudo apt-get install -y zenity.";

pub(crate) type SavePicker = dyn Fn(&str) -> Option<PathBuf> + Send + Sync;

/// Ways to ask a person for files; a test hands its own.
#[derive(Clone)]
pub struct Picker {
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
            open: Arc::new(|| {
                rfd::FileDialog::new()
                    .set_title("Open materials")
                    .add_filter("MERL, fit files and sessions", &["binary", "json"])
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

/// Asks for files, a folder or a place to write in the background, and does something with the answer. A dialog that
/// is gone at once was never there: then `no_answer` is said.
pub fn ask<T: Send + 'static>(
    jobs: &Jobs,
    doing: &str,
    no_answer: &'static str,
    dialog: impl FnOnce() -> Option<T> + Send + 'static,
    answered: impl FnOnce(T, &SendMsg) + Send + 'static,
) {
    jobs.start(Work::new(doing, move |send| {
        let asked = Instant::now();
        match dialog() {
            Some(answer) => answered(answer, send),
            None if asked.elapsed() < NO_DIALOG => {
                send(Msg::Notify(Severity::Error, no_answer.into()));
            }
            None => {}
        }
    }));
}

/// Asks where to, proposing a name, writes the file there and says so.
pub fn ask_and_write(
    jobs: &Jobs,
    save: &Arc<SavePicker>,
    name: String,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()> + Send + 'static,
) {
    ask_and_do(jobs, save, name, move |path| {
        // The dialog has asked about an existing file.
        files::write_atomically(&path, true, write).map_err(|error| error.to_string())?;
        Ok(path)
    });
}

/// Asks where to, proposing a name, does the work there and says what it has saved.
pub fn ask_and_do(
    jobs: &Jobs,
    save: &Arc<SavePicker>,
    name: String,
    work: impl FnOnce(PathBuf) -> Result<PathBuf, String> + Send + 'static,
) {
    let (save, doing) = (Arc::clone(save), format!("saving {name}"));
    let answered = move |path, send: &SendMsg| send(saved_notice(work(path)));
    ask(jobs, &doing, NOT_SAVED, move || save(&name), answered);
}

/// Says what was saved, or why nothing was.
pub fn saved_notice(saved: Result<PathBuf, String>) -> Msg {
    match saved {
        Ok(path) => Msg::Notify(Severity::Info, format!("Saved {}", path.display())),
        Err(reason) => Msg::Notify(Severity::Error, reason),
    }
}
