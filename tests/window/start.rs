//! The start of the window, dialogs that do not come, and figures among the files.

use crate::common::folder::Folder;
use crate::common::records::write_merl;
use crate::common::window::{
    nothing_picked, press, run, send, settle, window, window_with, with_answers,
};
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use grazing::app::command::Command;
use grazing::app::jobs::dialogs::NoDialog;
use grazing::app::msg::Msg;
use grazing::app::state::notice::Severity;
use grazing::app::{App, Picker};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};
use std::{fs, thread, time::Duration};

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

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_figure_opens_the_data_that_it_shows() {
    let folder = Folder::new();
    write_merl(&folder.path("tin.binary"));
    let source = r#"{"measured": {"file": {"path": "elsewhere/tin.binary"}, "lookup": "smooth"}}"#;
    let sample = r#"{"sample": {"key": "hammered-gold", "lookup": "smooth"}}"#;
    let subject =
        |label: &str, source: &str| format!(r#"{{"label": "{label}", "source": {source}}}"#);
    let [tin, gold] = [subject("Tin", source), subject("Gold", sample)];
    let text = |subjects: &str| format!(r#"{{"subjects": [{subjects}], "rows": []}}"#);
    let figure = folder.file("two.figure.json", text(&format!("{tin}, {gold}, {tin}")));
    let mut window = window(vec![figure], vec![]);
    settle(&mut window, |state| {
        state.scene.opened.len() == 2 && state.jobs.is_empty()
    });
    let state = window.state().state();
    let mut names: Vec<&str> = state.materials.values().map(|m| m.name.as_str()).collect();
    names.sort_unstable();
    assert_eq!(names, ["Hammered gold (synthetic)", "tin"]);
    assert!(
        state.notices[0].text.contains("two.figure.json"),
        "{:?}",
        state.notices
    );
    // A picture that carries the figure as its recipe is opened like it.
    let recipe = text(&tin).replace('"', "&quot;");
    let picture = folder.file(
        "tin.svg",
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg"><metadata><recipe xmlns="urn:grazing:figure">{recipe}</recipe></metadata></svg>"#
        ),
    );
    let mut alone = self::window(vec![picture], vec![]);
    settle(&mut alone, |state| {
        state.scene.opened.len() == 1 && state.jobs.is_empty()
    });
    let mut names = alone.state().state().materials.values();
    assert_eq!(
        names.next().map(|material| material.name.as_str()),
        Some("tin")
    );
    // A file that is gone is named with the figure.
    fs::remove_file(folder.path("tin.binary")).expect("removed");
    let figure = folder.path("two.figure.json");
    send(&mut window, Msg::OpenFiles(vec![figure.clone()]));
    settle(&mut window, |state| state.notices.len() == 2);
    let said = &window.state().state().notices[1].text;
    assert!(said.contains("Tin is missing"), "{said}");
    assert!(said.ends_with(&format!(": {}", figure.display())), "{said}");
}
