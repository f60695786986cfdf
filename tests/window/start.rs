//! Dialogs that do not come.

use crate::common::window::{nothing_picked, press, run, settle, window_with};
use egui::{Key, Modifiers};
use grazing::app::Picker;
use grazing::app::command::Command;
use grazing::app::jobs::dialogs::NoDialog;
use grazing::app::state::notice::Severity;
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};

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
