//! Work in the background: a queue with one worker, and the way back to the window.

use super::library::LibraryMsg;
use super::open_fits;
use super::session::{self, SessionMsg};
use super::state::{CancelFlag, Level, Origin};
use super::update::{Loaded, Msg};
use crate::files::fits::{self, MaterialFits};
use crate::files::{self, FileError, Json};
use crate::measured::Table;
use crate::measured::samples::SAMPLES;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

/// Sends messages to the window from any thread and wakes it.
#[derive(Clone)]
pub struct Outbox {
    sender: Sender<Msg>,
    ctx: egui::Context,
}

impl Outbox {
    /// An outbox and the inbox it fills.
    pub fn new(ctx: egui::Context) -> (Self, Receiver<Msg>) {
        let (sender, receiver) = channel();
        (Self { sender, ctx }, receiver)
    }

    /// A picture on the GPU, which is let go with the last handle to it.
    pub fn texture(&self, name: String, picture: egui::ColorImage) -> egui::TextureHandle {
        let options = egui::TextureOptions::LINEAR;
        self.ctx.load_texture(name, picture, options)
    }

    /// Wakes the window without a message.
    pub fn wake(&self) {
        self.ctx.request_repaint();
    }

    /// Sends a message. A window that is gone hears nothing.
    pub fn send(&self, msg: Msg) {
        if self.sender.send(msg).is_ok() {
            self.ctx.request_repaint();
        }
    }
}

type Work = Box<dyn FnOnce() + Send>;

/// Runs jobs one after the other, so that a hundred dropped files do not fight for disk and memory.
pub struct Queue(Sender<Work>);

impl Queue {
    /// Starts the worker. It ends with the queue.
    pub fn start() -> std::io::Result<Self> {
        let (sender, receiver) = channel::<Work>();
        thread::Builder::new()
            .name("loader".into())
            .spawn(move || {
                for work in receiver {
                    work();
                }
            })?;
        Ok(Self(sender))
    }

    /// Adds a job.
    pub fn push(&self, work: impl FnOnce() + Send + 'static) {
        // The worker lives as long as the queue, unless a job panicked: then nothing more is loaded.
        let _ = self.0.send(Box::new(work));
    }
}

/// Loads a material, with what a fit file has for it, or reads a fit file; says how it goes.
pub fn load(
    job: u64,
    origin: Origin,
    fits: Option<Box<MaterialFits>>,
    cancel: &CancelFlag,
    outbox: &Outbox,
) {
    let mut progress = |fraction: f32| {
        outbox.send(Msg::Progress {
            job,
            progress: fraction,
        });
        if cancel.is_set() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let result = if progress(0.0).is_break() {
        Err(None)
    } else {
        match &origin {
            Origin::Sample(index) => {
                let sample = &SAMPLES[*index];
                let name = sample.name.to_string();
                Ok(Loaded::new(name, None, sample.synthesize()))
            }
            Origin::File(path) => match (open_file(path, fits.is_some(), &mut progress), fits) {
                (Ok(Found::Material(loaded)), fits) => Ok(Loaded { fits, ..*loaded }),
                (Ok(Found::Folder), _) => {
                    outbox.send(Msg::Loaded {
                        job,
                        origin: origin.clone(),
                        result: Err(None),
                    });
                    outbox.send(Msg::Library(LibraryMsg::Open(path.clone())));
                    return;
                }
                (Ok(Found::Fits(fits)), _) => {
                    let path = path.clone();
                    outbox.send(Msg::FitsRead { job, path, fits });
                    return;
                }
                (Ok(Found::Session(found)), _) => {
                    let path = path.clone();
                    outbox.send(Msg::Session(SessionMsg::Read { job, path, found }));
                    return;
                }
                (Err(_), _) if cancel.is_set() => Err(None),
                (Err(error), Some(fits)) => {
                    outbox.send(Msg::Notify(Level::Error, error.to_string()));
                    Ok(open_fits::alone(fits))
                }
                (Err(error), None) => Err(Some(error.to_string())),
            },
        }
    };
    outbox.send(Msg::Loaded {
        job,
        origin,
        result,
    });
}

/// What is in a file.
enum Found {
    Material(Box<Loaded>),
    Fits(Vec<MaterialFits>),
    Session(Box<session::Found>),
    Folder,
}

/// `measured`: a fit file names it as its data. A fit file that names itself must not be read for ever.
fn open_file(path: &Path, measured: bool, progress: files::Progress) -> Result<Found, FileError> {
    if !measured && path.is_dir() {
        return Ok(Found::Folder);
    }
    let json = if measured {
        None
    } else {
        files::open_json(path)?
    };
    if let Some(Json::Session(text)) = &json {
        let found = session::find(path, text)?;
        // Made here and not on the window's thread.
        Table::unmeasured();
        return Ok(Found::Session(Box::new(found)));
    }
    if let Some(Json::Models(entries)) = json {
        let fits = fits::by_material(path, entries);
        if fits.iter().any(|fits| fits.found.is_none()) {
            // Made here and not on the window's thread.
            Table::unmeasured();
        }
        return Ok(Found::Fits(fits));
    }
    let (table, source) = files::open_measured(path, progress)?;
    let loaded = Loaded::new(files::material_name(path), Some(source), table);
    Ok(Found::Material(Box::new(loaded)))
}
