//! Tasks: what [`super::update::apply`] asks to be done outside the state.

use super::fitting::work::Fitter;
use super::jobs::{self, Outbox, Queue};
use super::library;
use super::session;
use super::state::Level;
use super::update::{Msg, Task};
use crate::files;
use crate::files::session::ENDING;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// A dialog that is gone sooner was never there: nobody cancels so fast, and the library does not tell the two apart.
pub(super) const NO_DIALOG: Duration = Duration::from_millis(250);
const NO_ANSWER: &str = "No file dialog answered; install one: sudo apt-get install -y zenity.";

type SavePicker = dyn Fn(&str) -> Option<PathBuf> + Send + Sync;

/// How a person is asked for files; a test hands its own.
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
                let (title, filter, extension) = if name.ends_with(ENDING) {
                    ("Save session", "Session", "json")
                } else if name.ends_with(".json") {
                    ("Save fits", "Fit file", "json")
                } else {
                    ("Save picture", "PNG picture", "png")
                };
                rfd::FileDialog::new()
                    .set_title(title)
                    .add_filter(filter, &[extension])
                    .set_file_name(name)
                    .save_file()
            }),
        }
    }
}

/// What to say where a dialog did not open.
pub(super) fn no_dialog() -> Msg {
    let text = format!("{NO_ANSWER} Open path… and dropping files work without it.");
    Msg::Notify(Level::Error, text)
}

/// Starts a task. None waits here.
pub fn start(
    task: Task,
    ctx: &egui::Context,
    outbox: &Outbox,
    queue: &Queue,
    fitter: &mut Fitter,
    picker: &Picker,
) {
    match task {
        Task::Load {
            job,
            origin,
            fits,
            cancel,
        } => {
            let outbox = outbox.clone();
            queue.push(move || jobs::load(job, origin, fits, &cancel, &outbox));
        }
        Task::Fit(task) => fitter.fit(task),
        Task::Resolve(resolve) => fitter.resolve(resolve),
        Task::Library(task) => library::start(task, outbox, picker),
        Task::Session(task) => session::start(task, outbox, picker),
        Task::Derive(work) => {
            let outbox = outbox.clone();
            in_thread(&outbox.clone(), "view", move || work.run(&outbox));
        }
        Task::PickFiles => {
            let (outbox, open) = (outbox.clone(), Arc::clone(&picker.open));
            in_thread(&outbox.clone(), "open dialog", move || {
                let asked = Instant::now();
                let paths = open();
                if !paths.is_empty() {
                    outbox.send(Msg::OpenFiles(paths));
                } else if asked.elapsed() < NO_DIALOG {
                    outbox.send(no_dialog());
                }
            });
        }
        Task::SavePicture => {
            let (outbox, save) = (outbox.clone(), Arc::clone(&picker.save));
            let arrived = move |picture| save_picture(picture, outbox, save);
            ctx.send_viewport_cmd(egui::ViewportCommand::Screenshot(
                egui::ScreenshotCallback::new(arrived),
            ));
        }
        Task::Copy(text) => ctx.copy_text(text),
        Task::Quit => ctx.send_viewport_cmd(egui::ViewportCommand::Close),
    }
}

/// Asks where to, and writes the picture there.
fn save_picture(picture: Arc<egui::ColorImage>, outbox: Outbox, save: Arc<SavePicker>) {
    in_thread(&outbox.clone(), "save dialog", move || {
        let Some(path) = save("grazing.png") else {
            return;
        };
        outbox.send(match write_png(&picture, &path) {
            Ok(()) => Msg::Notify(Level::Info, format!("Saved {}", path.display())),
            Err(reason) => Msg::Notify(Level::Error, reason),
        });
    });
}

fn write_png(picture: &egui::ColorImage, path: &Path) -> Result<(), String> {
    let [width, height] = picture.size.map(|n| n as u32);
    let bytes: Vec<u8> = picture
        .pixels
        .iter()
        .flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b()])
        .collect();
    let image =
        image::RgbImage::from_raw(width, height, bytes).ok_or("the picture has no pixels")?;
    let mut png = std::io::Cursor::new(Vec::new());
    image
        .write_to(&mut png, image::ImageFormat::Png)
        .map_err(|error| format!("could not make the PNG: {error}"))?;
    // The dialog has asked about an existing file.
    files::write_atomically(path, true, |file| file.write_all(png.get_ref()))
        .map_err(|error| error.to_string())
}

pub(super) fn in_thread(outbox: &Outbox, name: &str, work: impl FnOnce() + Send + 'static) {
    if let Err(error) = thread::Builder::new().name(name.into()).spawn(work) {
        outbox.send(Msg::Notify(
            Level::Error,
            format!("could not start a thread for the {name}: {error}"),
        ));
    }
}
