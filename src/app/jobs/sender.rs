//! The way back from jobs to the window.

use crate::app::msg::Msg;
use std::sync::mpsc::{Receiver, channel};

/// Sends messages to the window from any thread and wakes it.
#[derive(Clone)]
pub struct Sender {
    channel: std::sync::mpsc::Sender<Msg>,
    ctx: egui::Context,
}

impl Sender {
    /// A sender and the inbox it fills.
    pub fn new(ctx: egui::Context) -> (Self, Receiver<Msg>) {
        let (channel, inbox) = channel();
        (Self { channel, ctx }, inbox)
    }

    /// The window, for its clipboard.
    pub fn ctx(&self) -> &egui::Context {
        &self.ctx
    }

    /// A picture on the GPU, which is let go with the last handle to it.
    pub fn texture(&self, name: String, picture: egui::ColorImage) -> egui::TextureHandle {
        let options = egui::TextureOptions::LINEAR;
        self.ctx.load_texture(name, picture, options)
    }

    /// Sends a message. One to a window that is gone is dropped.
    pub fn send(&self, msg: Msg) {
        if self.channel.send(msg).is_ok() {
            self.ctx.request_repaint();
        }
    }
}
