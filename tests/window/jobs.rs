//! A job that panics is said once, and the window goes on: one planted panic in each kind of job.

use crate::common::records::write_merl;
use crate::common::window::{Window, nothing_picked, run, settle, window, window_with};
use grazing::app::Picker;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::cache::again;
use grazing::app::msg::figure::FigureMsg;
use grazing::app::msg::library::LibraryMsg;
use grazing::app::state::State;
use grazing::app::state::library::Scan;
use grazing::app::state::notice::Severity;
use grazing::app::state::views::ViewId;
use grazing::app::views::albedo::work::MeasuredAlbedo;
use std::sync::Arc;

/// The one error that is said, which names what the program was doing.
fn said_once(state: &State, doing: &str) {
    let errors: Vec<&str> = state
        .notices
        .iter()
        .filter(|notice| notice.level == Severity::Error)
        .map(|notice| &*notice.text)
        .collect();
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert!(
        errors[0].contains(doing) && errors[0].contains("planted"),
        "{errors:?}"
    );
}

fn errors(state: &State) -> usize {
    let errors = state
        .notices
        .iter()
        .filter(|notice| notice.level == Severity::Error);
    errors.count()
}

fn send(window: &mut Window, msg: Msg) {
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, msg);
    window.run_steps(3);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_loader_goes_on() {
    let mut window = window(vec![], vec![]);
    window.state().plant_panic("making");
    run(&mut window, Command::OpenSample(1));
    settle(&mut window, |state| state.jobs.is_empty());
    said_once(window.state().state(), "making");
    run(&mut window, Command::OpenSample(1));
    settle(&mut window, |state| state.jobs.is_empty());
    assert_eq!(window.state().state().scene.opened.len(), 2);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_scan_of_a_folder_goes_on() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["a.binary", "b.binary"] {
        write_merl(&folder.path().join(name));
    }
    let mut window = window(vec![], vec![]);
    window.state().plant_panic("reading a");
    let open = LibraryMsg::Open(folder.path().to_owned());
    send(&mut window, Msg::Library(open));
    settle(&mut window, |state| {
        let folder = state.library.folder.as_ref();
        folder.is_some_and(|folder| folder.scan == Scan::Done)
    });
    let state = window.state().state();
    let files = &state.library.folder.as_ref().expect("a folder").files;
    let read: Vec<bool> = files.iter().map(|file| file.examined().is_some()).collect();
    assert_eq!(
        read,
        [false, true],
        "the file says why, the next one is read"
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_fit_goes_on() {
    let mut window = window(vec![], vec![]);
    window.state().plant_panic("fitting");
    run(&mut window, Command::Fit);
    settle(&mut window, |state| state.fit.run.is_none());
    said_once(window.state().state(), "fitting");
    run(&mut window, Command::Fit);
    settle(&mut window, |state| state.fit.run.is_none());
    assert_eq!(
        window
            .state()
            .state()
            .current()
            .expect("a material")
            .0
            .fits
            .len(),
        1
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_view_goes_on() {
    let mut window = window(vec![], vec![]);
    window.state().plant_panic("albedo of the data");
    run(&mut window, Command::ToggleTile(ViewId::Albedo));
    run(&mut window, Command::ToggleTile(ViewId::Albedo));
    settle(&mut window, |state| errors(state) > 0);
    said_once(window.state().state(), "albedo of the data");
    let sources = {
        let state = window.state().state();
        let subjects = grazing::app::state::subjects::Subjects::of(state);
        grazing::app::views::albedo::work::queries(&subjects.list).0
    };
    assert!(window.state().state().caches.is_stopped(&sources));
    send(&mut window, again(&sources));
    settle(&mut window, |state| {
        state.caches.last::<MeasuredAlbedo>().is_some()
    });
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_preview_and_an_export_go_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("lobes.svg");
    let to = file.clone();
    let picker = Picker {
        save: Arc::new(move |_| Some(to.clone())),
        ..nothing_picked()
    };
    let mut window = window_with(vec![], picker);
    window.state().plant_panic("drawing the preview");
    run(&mut window, Command::ExportFigure);
    settle(&mut window, |state| errors(state) > 0);
    said_once(window.state().state(), "drawing the preview");
    window.state().plant_panic("saving");
    send(&mut window, Msg::Figure(FigureMsg::Export));
    settle(&mut window, |state| errors(state) == 2);
    assert!(!file.exists());
    run(&mut window, Command::ExportFigure);
    send(&mut window, Msg::Figure(FigureMsg::Export));
    settle(&mut window, |_| file.is_file());
}
