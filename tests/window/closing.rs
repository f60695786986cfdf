//! The end of the window: work that is in no file is asked about, and what the system ends comes back.

use crate::common::folder::{Folder, left_in};
use crate::common::records::write_merl;
use crate::common::window::{
    Window, click, close, data, kept_in, names, press, run, said, send, set_slider, settle,
    settle_on, window_of, with_answers,
};
use eframe::App as _;
use egui::{Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::kittest::Queryable;
use grazing::app::WindowOptions;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::layout::Tiles;
use std::path::{Path, PathBuf};

const QUESTION: &str = "Save the session before closing?";

/// A window without tiles that keeps itself in a folder and saves to a path.
fn saving(kept: &Path, file: &Path) -> Window {
    let mut window = window_of(WindowOptions {
        autosave: Some(kept.to_owned()),
        ..with_answers(&[], None, Some(file))
    });
    send(&mut window, Msg::SetLayout(Tiles::none()));
    window
}

fn commands(window: &Window) -> Vec<ViewportCommand> {
    let outputs = window.output().viewport_output.values();
    outputs.flat_map(|output| output.commands.clone()).collect()
}

/// Asks the window to close as its frame does; whether it lets itself be closed.
fn may_close(window: &mut Window) -> bool {
    let viewports = &mut window.input_mut().viewports;
    let root = viewports.entry(ViewportId::ROOT).or_default();
    root.events.push(ViewportEvent::Close);
    window.step();
    let stays = commands(window).contains(&ViewportCommand::CancelClose);
    window.run_steps(3);
    !stays
}

fn asks(window: &Window) -> bool {
    window.query_by_label(QUESTION).is_some()
}

/// Steps until the window closes itself.
fn closes(window: &mut Window) {
    settle_on(window, |window| {
        commands(window)
            .contains(&ViewportCommand::Close)
            .then_some(())
    });
}

/// Lets time pass until what is open is kept.
fn until_kept(window: &mut Window, folder: &Path) {
    settle_on(window, |_| (left_in(folder).len() == 2).then_some(()));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_window_where_nothing_was_made_closes_without_a_question() {
    let folder = Folder::new();
    let gold = folder.path("gold.binary");
    write_merl(&gold);
    let mut window = kept_in(&folder.path("kept"), &[&gold]);
    run(&mut window, Command::OpenSample(2));
    settle(&mut window, |state| state.jobs.is_empty());
    send(&mut window, Msg::Select(0));
    run(&mut window, Command::UseLights(1));
    assert!(may_close(&mut window) && !asks(&window));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn work_that_is_in_no_file_is_asked_about() {
    let folder = Folder::new();
    let (kept, file) = (folder.path("kept"), folder.path("study.grazing.json"));
    let mut window = saving(&kept, &file);
    set_slider(&mut window, "s", 44.0);
    until_kept(&mut window, &kept);
    assert!(!may_close(&mut window) && asks(&window));
    click(&mut window, "Cancel");
    assert!(!asks(&window));
    // Asked again, and escaped from.
    assert!(!may_close(&mut window) && asks(&window));
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(!asks(&window));
    assert_eq!(left_in(&kept).len(), 2, "what is kept stays");
    // Enter saves, and the window closes by itself.
    assert!(!may_close(&mut window));
    window.run_steps(3);
    window.key_press(Key::Enter);
    closes(&mut window);
    assert!(file.is_file());
    assert!(may_close(&mut window));
    window.state_mut().on_exit();
    assert_eq!(left_in(&kept), Vec::<PathBuf>::new());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_save_that_fails_keeps_the_window_and_the_work() {
    let folder = Folder::new();
    let (kept, nowhere) = (folder.path("kept"), folder.path("no/such/a.grazing.json"));
    let mut window = saving(&kept, &nowhere);
    set_slider(&mut window, "s", 44.0);
    until_kept(&mut window, &kept);
    run(&mut window, Command::SaveSession);
    settle(&mut window, |state| !state.notices.is_empty());
    assert!(!may_close(&mut window) && asks(&window), "it is asked");
    click(&mut window, "Save");
    settle(&mut window, |state| {
        state.session.closing == grazing::app::state::session::Closing::No
    });
    let state = window.state().state();
    said(state, "there is no directory for the file");
    assert_eq!(state.notices.len(), 1, "said once");
    assert_eq!(left_in(&kept).len(), 2, "what is kept stays");
    // A display that goes away asks nobody.
    window.state_mut().on_exit();
    let before = data(&window);
    drop(window);
    assert_eq!(left_in(&kept).len(), 2, "what is kept stays");
    let second = kept_in(&kept, &[]);
    assert_eq!(data(&second), before);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_saved_session_is_asked_about_when_it_has_changed() {
    let folder = Folder::new();
    let file = folder.path("study.grazing.json");
    let mut window = saving(&folder.path("kept"), &file);
    run(&mut window, Command::SaveSession);
    settle(&mut window, |state| !state.session.files.is_empty());
    assert!(may_close(&mut window));
    let mut window = kept_in(&folder.path("kept too"), &[&file]);
    run(&mut window, Command::UseLights(1));
    assert!(!may_close(&mut window));
    window.get_by_label("study has changed since it was saved.");
    click(&mut window, "Don't save");
    // Undone, it is what it was.
    let mut window = kept_in(&folder.path("kept three"), &[&file]);
    run(&mut window, Command::UseLights(1));
    run(&mut window, Command::Undo);
    assert!(may_close(&mut window));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_the_system_ends_is_open_again_at_the_next_start() {
    let folder = Folder::new();
    let kept = folder.path("kept");
    let mut first = kept_in(&kept, &[]);
    set_slider(&mut first, "s", 44.0);
    first.state().on_end()();
    closes(&mut first);
    assert!(may_close(&mut first), "nobody is asked");
    first.state_mut().on_exit();
    let before = data(&first);
    drop(first);
    // Beside files it is offered, without words of alarm.
    let gold = folder.path("gold.binary");
    write_merl(&gold);
    let second = kept_in(&kept, &[&gold]);
    second.get_by_label("Grazing was closed by the system");
    drop(second);
    let mut third = kept_in(&kept, &[]);
    let state = third.state().state();
    assert_eq!(names(state), ["Copper glaze (synthetic)"]);
    assert_eq!(data(&third), before);
    assert_eq!(state.notices.len(), 1);
    said(state, "system closed Grazing");
    assert!(!may_close(&mut third) && asks(&third), "it is in no file");
    close(third);
    assert_eq!(left_in(&kept), Vec::<PathBuf>::new());
}
