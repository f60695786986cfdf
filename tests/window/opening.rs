//! Opening with the settings of a new user: what is seen first is the fit.

use crate::common::folder::Folder;
use crate::common::records::{combined, only_named, record, write_fits, write_merl};
use crate::common::window::{Window, run, settle, window_of, with_answers};
use egui_kittest::kittest::Queryable;
use grazing::app::WindowOptions;
use grazing::app::command::Command;
use grazing::app::state::State;
use grazing::app::state::prefs::Prefs;
use std::path::PathBuf;

/// A window as a new user has it, with these files.
fn new_window(files: Vec<PathBuf>) -> Window {
    window_of(WindowOptions {
        files,
        prefs: Prefs::default(),
        ..with_answers(&[], None, None)
    })
}

/// Whether every open material has one fit, and its model is that.
fn all_fitted(state: &State) -> bool {
    state.scene.opened.iter().all(|opened| {
        let fits = &state.materials[&opened.id].fits;
        fits.len() == 1 && fits[0].outcome.brdf == opened.brdf
    })
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_first_look_is_at_a_fit_that_says_so() {
    let mut window = new_window(vec![]);
    settle(&mut window, |state| state.fit.run.is_none());
    let state = window.state().state();
    assert!(all_fitted(state) && !state.history.can_undo());
    let guess = state.current().expect("a material").0.guess;
    assert_ne!(state.scene.opened[0].brdf, guess);
    assert!(window.query_by_label("Fitted on opening.").is_some());
    assert!(window.query_by_label("Combined, exact").is_some());

    // Without it the panel says that it is a guess.
    run(&mut window, Command::ToggleFitOnOpening);
    run(&mut window, Command::OpenSample(1));
    settle(&mut window, |state| state.scene.opened.len() == 2);
    assert!(window.query_by_label_contains("First guess").is_some());
    assert!(window.query_by_label("Fitted on opening.").is_none());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn all_opened_files_are_fitted_and_those_of_a_fit_file_are_not() {
    let folder = Folder::new();
    let files = ["one.binary", "two.binary", "three.binary"].map(|name| folder.path(name));
    files.iter().for_each(|file| write_merl(file));
    let mut window = new_window(files.to_vec());
    settle(&mut window, |state| {
        state.scene.opened.len() == 3 && state.fit.run.is_none()
    });
    assert!(all_fitted(window.state().state()));

    let of_file = combined(33.0, 0.25);
    let fits = folder.path("fits.json");
    let source = Some(only_named(&files[0]));
    write_fits(&fits, &[record("one", source, of_file, 0.1)]);
    let mut window = new_window(vec![fits]);
    settle(&mut window, |state| {
        state.scene.opened.len() == 1 && state.jobs.is_empty()
    });
    window.run_steps(5);
    let state = window.state().state();
    assert_eq!(state.scene.opened[0].brdf, of_file);
    assert!(state.fit.run.is_none());
}
