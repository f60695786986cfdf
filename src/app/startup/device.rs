//! The graphics device of the window: its errors are said, and one that is lost is noticed.

use crate::app::App;
use crate::app::jobs::sender::Sender;
use crate::app::msg::Msg;
use crate::app::msg::session::{Close, SessionMsg};
use crate::app::state::notice::Severity;
use crate::quote::shown;
use eframe::wgpu;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Different errors of a driver that are said.
const MOST: usize = 5;

/// Watches a device. Its errors become notices: without that the first one would end the program. Where the device is
/// lost, `lost` is set and the window woken.
pub(super) fn watch(device: &wgpu::Device, sender: &Sender, lost: &Arc<AtomicBool>) {
    let said: Mutex<BTreeSet<String>> = Mutex::default();
    let to = sender.clone();
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        let text = words(&error.to_string());
        let mut said = said.lock().unwrap_or_else(PoisonError::into_inner);
        // An error of a frame comes again with each.
        if said.len() < MOST && said.insert(text.clone()) {
            to.send(Msg::Notify(Severity::Error, text));
        }
    }));
    let (to, lost) = (sender.clone(), Arc::clone(lost));
    device.set_device_lost_callback(move |_, _| {
        lost.store(true, Ordering::Release);
        to.ctx().request_repaint();
    });
}

/// The window, which draws nothing any more where its device is lost: egui cannot, and would end the program.
pub(super) struct Guarded {
    pub app: App,
    pub lost: Arc<AtomicBool>,
}

impl eframe::App for Guarded {
    fn raw_input_hook(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        self.app.raw_input_hook(ctx, input);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        if self.lost.load(Ordering::Acquire) {
            let close = Msg::Session(SessionMsg::Close(Close::BySystem));
            self.app.handle(&ui.ctx().clone(), close);
        } else {
            self.app.ui(ui, frame);
        }
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.app.save(storage);
    }

    fn on_exit(&mut self) {
        self.app.on_exit();
    }
}

/// Errors of wgpu are a tree of lines: the last says what it comes from.
fn words(error: &str) -> String {
    let cause = error.lines().map(str::trim).rfind(|line| !line.is_empty());
    let cause = shown(cause.unwrap_or("no reason given"));
    format!("The graphics driver refused a picture ({cause}). Please report it.")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::adapter::headless;

    #[test]
    #[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
    fn errors_are_said_once_each_and_a_lost_device_is_noticed() {
        let gpu = headless().expect("an adapter");
        let (sender, inbox) = Sender::new(egui::Context::default());
        let lost = Arc::default();
        watch(&gpu.device, &sender, &lost);
        let wrong = || {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: u64::MAX / 2,
                usage: wgpu::BufferUsages::VERTEX,
                mapped_at_creation: false,
            })
        };
        let _ = [wrong(), wrong()];
        let said: Vec<Msg> = inbox.try_iter().collect();
        let [Msg::Notify(Severity::Error, text)] = said.as_slice() else {
            panic!("{said:?}")
        };
        assert!(text.starts_with("The graphics driver refused") && text.lines().count() == 1);
        assert!(!lost.load(Ordering::Acquire));
        gpu.device.destroy();
        let _ = gpu.device.poll(wgpu::PollType::Poll);
        assert!(lost.load(Ordering::Acquire));
    }
}
