//! Work in the background: a queue with one worker, and the way back to the window.

use super::state::{CancelFlag, Origin};
use super::update::{Loaded, Msg};
use crate::files;
use crate::measured::samples::SAMPLES;
use std::ops::ControlFlow;
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

/// Loads a material and says how it goes.
pub fn load(job: u64, origin: Origin, cancel: &CancelFlag, outbox: &Outbox) {
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
                Ok(Loaded::new(sample.name.to_string(), sample.synthesize()))
            }
            Origin::File(path) => match files::open_table(path, &mut progress) {
                Ok(table) => Ok(Loaded::new(files::material_name(path), table)),
                Err(_) if cancel.is_set() => Err(None),
                Err(error) => Err(Some(error.to_string())),
            },
        }
    };
    outbox.send(Msg::Loaded {
        job,
        origin,
        result,
    });
}
