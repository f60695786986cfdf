//! The start of the window, and dialogs that do not come.

use crate::common::folder::Folder;
use crate::common::records::write_merl;
use crate::common::window::{nothing_picked, press, run, settle, window_with, with_answers};
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use grazing::app::command::Command;
use grazing::app::jobs::dialogs::NoDialog;
use grazing::app::state::notice::Severity;
use grazing::app::{App, Picker};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn nothing_is_read_before_the_first_frame() {
    let folder = Folder::new();
    let file = folder.path("tin.binary");
    let options = with_answers(&[&file], None, None);
    let mut window = Harness::builder()
        .with_size([1280.0, 800.0])
        .wgpu()
        .build_eframe(move |cc| {
            let app = App::new(cc, options).expect("a renderer");
            // The file comes late: a job that has begun finds nothing.
            thread::sleep(Duration::from_millis(300));
            write_merl(&file);
            app
        });
    settle(&mut window, |state| state.jobs.is_empty());
    let state = window.state().state();
    assert_eq!(state.notices, []);
    assert_eq!(state.current().expect("a material").0.name, "tin");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_service_for_dialogs_that_is_silent_is_named_with_the_way_out() {
    let picker = Picker {
        ready: Arc::new(|| Err(NoDialog::Silent)),
        open: Arc::new(|| panic!("no dialog is asked for")),
        ..nothing_picked()
    };
    let mut window = window_with(vec![], picker);
    press(&mut window, Modifiers::COMMAND, Key::O);
    settle(&mut window, |state| !state.notices.is_empty());
    let notice = &window.state().state().notices[0];
    assert!(notice.text.contains("does not answer"), "{notice:?}");
    assert!(notice.text.contains("Open path…"), "{notice:?}");
    // Where to save cannot be typed, so nothing of the kind is promised.
    run(&mut window, Command::SaveSession);
    settle(&mut window, |state| state.notices.len() == 2);
    let notice = &window.state().state().notices[1];
    assert!(notice.text.contains("does not answer"), "{notice:?}");
    assert!(!notice.text.contains("Open path…"), "{notice:?}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_dialog_that_does_not_come_to_the_front_is_told_of_while_it_is_waited_for() {
    let (answer, waits) = channel::<()>();
    let waits = Mutex::new(waits);
    let picker = Picker {
        open: Arc::new(move || {
            let _ = waits.lock().expect("nobody panicked").recv();
            vec![]
        }),
        ..nothing_picked()
    };
    let mut window = window_with(vec![], picker);
    press(&mut window, Modifiers::COMMAND, Key::O);
    settle(&mut window, |state| !state.notices.is_empty());
    let notice = &window.state().state().notices[0];
    assert_eq!(notice.level, Severity::Info);
    assert!(notice.text.contains("Open path…"), "{notice:?}");
    drop(answer);
}
