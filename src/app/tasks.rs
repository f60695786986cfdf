//! Tasks: what [`super::update::apply`] asks to be done outside the state.

use super::fitting::work::Fitter;
use super::jobs::{self, Outbox, Queue};
use super::library;
use super::paper;
use super::session;
use super::state::Level;
use super::update::{Msg, Task};
use crate::brdf::Brdf;
use crate::files::session::ENDING;
use crate::files::{self, ModelFormat};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// A dialog that is gone sooner was never there: nobody cancels so fast, and the library does not tell the two apart.
pub(super) const NO_DIALOG: Duration = Duration::from_millis(250);
const NO_ANSWER: &str = "No file dialog answered; install one: sudo apt-get install -y zenity.";

pub(super) type SavePicker = dyn Fn(&str) -> Option<PathBuf> + Send + Sync;

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

/// What the dialog for saving says of a kind of file.
struct Saved {
    ending: &'static str,
    title: &'static str,
    filter: &'static str,
}

const SAVED: [Saved; 11] = [
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

const fn saved(ending: &'static str, title: &'static str, filter: &'static str) -> Saved {
    Saved {
        ending,
        title,
        filter,
    }
}

/// A model to be written for other programs.
#[derive(Debug)]
pub struct ModelExport {
    /// As what.
    pub format: ModelFormat,
    /// Name of the material it was laid over.
    pub material: String,
    /// The model with its numbers.
    pub brdf: Brdf,
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
        Task::Paper(task) => paper::start(task, ctx, outbox, picker),
        Task::ExportModel(export) => {
            let name = export.format.file_name(&export.brdf, &export.material);
            ask_and_write(outbox, &picker.save, name, move |file| {
                let material = Some(export.material.as_str());
                export.format.write(&export.brdf, material, file)
            });
        }
        Task::SavePicture => {
            let (outbox, save) = (outbox.clone(), Arc::clone(&picker.save));
            let arrived = move |picture: Arc<egui::ColorImage>| {
                ask_and_write(&outbox, &save, "grazing.png".into(), move |file| {
                    write_png(&picture, file)
                });
            };
            ctx.send_viewport_cmd(egui::ViewportCommand::Screenshot(
                egui::ScreenshotCallback::new(arrived),
            ));
        }
        Task::Copy(text) => ctx.copy_text(text),
        Task::Quit => ctx.send_viewport_cmd(egui::ViewportCommand::Close),
    }
}

/// Asks where to, proposing a name, writes the file there and says so.
pub(super) fn ask_and_write(
    outbox: &Outbox,
    save: &Arc<SavePicker>,
    name: String,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()> + Send + 'static,
) {
    ask_and_do(outbox, save, name, move |path| {
        // The dialog has asked about an existing file.
        files::write_atomically(&path, true, write).map_err(|error| error.to_string())?;
        Ok(path)
    });
}

/// Asks where to, proposing a name, does the work there and says what it has saved.
pub(super) fn ask_and_do(
    outbox: &Outbox,
    save: &Arc<SavePicker>,
    name: String,
    work: impl FnOnce(PathBuf) -> Result<PathBuf, String> + Send + 'static,
) {
    let (told, save) = (outbox.clone(), Arc::clone(save));
    in_thread(outbox, "save dialog", move || {
        let asked = Instant::now();
        let Some(path) = save(&name) else {
            if asked.elapsed() < NO_DIALOG {
                told.send(Msg::Notify(Level::Error, NO_ANSWER.into()));
            }
            return;
        };
        told.send(match work(path) {
            Ok(path) => Msg::Notify(Level::Info, format!("Saved {}", path.display())),
            Err(reason) => Msg::Notify(Level::Error, reason),
        });
    });
}

fn write_png(picture: &egui::ColorImage, file: &mut dyn Write) -> io::Result<()> {
    let [width, height] = picture.size.map(|n| n as u32);
    let bytes: Vec<u8> = picture
        .pixels
        .iter()
        .flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b()])
        .collect();
    PngEncoder::new(file)
        .write_image(&bytes, width, height, ExtendedColorType::Rgb8)
        .map_err(io::Error::other)
}

pub(super) fn in_thread(outbox: &Outbox, name: &str, work: impl FnOnce() + Send + 'static) {
    if let Err(error) = thread::Builder::new().name(name.into()).spawn(work) {
        outbox.send(Msg::Notify(
            Level::Error,
            format!("could not start a thread for the {name}: {error}"),
        ));
    }
}
