//! Sessions in the real window: saved, opened again, with files that moved or changed, and after a crash.

use crate::common::folder::Folder;
use crate::common::records::{combined, only_named, record, write_fits, write_merl};
use crate::common::window::{
    Window, click, not_fitted_on_opening, nothing_picked, press, run, send, set_slider, settle,
    settle_on, window, window_of, with_answers,
};
use eframe::App as _;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::fit::FitMsg;
use grazing::app::session::file::SessionFile;
use grazing::app::state::State;
use grazing::app::state::layout::Tiles;
use grazing::app::state::notice::Severity;
use grazing::app::state::views::ViewId;
use grazing::app::{Picker, WindowOptions};
use grazing::brdf::{Fresnel, Params};
use grazing::files::fits::FitRecord;
use grazing::fit::{Errors, Variant};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// A window whose dialogs answer with these paths.
fn with_dialogs(files: &[&Path], open: Option<&Path>, save: Option<&Path>) -> Window {
    let mut window = window_of(with_answers(files, open, save));
    settle(&mut window, |state| state.jobs.is_empty());
    window
}

/// Without tiles, as only time must pass.
fn kept_in(folder: &Path, files: &[&Path]) -> Window {
    let mut window = window_of(WindowOptions {
        autosave: Some(folder.to_owned()),
        ..with_answers(files, None, None)
    });
    send(&mut window, Msg::SetLayout(Tiles::none()));
    window
}

/// A fit of the file that a fit file brings, with errors that differ from each other.
fn fit_of(gold: &Path) -> FitRecord {
    FitRecord {
        errors: Errors {
            total: 0.125,
            grazing: Some(0.25),
            channels: [0.1, 0.2, 0.3],
        },
        ..record(
            "gold",
            Some(only_named(gold)),
            combined(21.0, Params::default().alpha),
            0.125,
        )
    }
}

/// Two files and a sample, with models, fits, views and tiles changed.
fn make_rich(window: &mut Window, gold: &Path) {
    let (record, fits) = (fit_of(gold), gold.with_extension("json"));
    let fitted = Variant::from(&record.brdf);
    write_fits(&fits, &[record]);
    send(window, Msg::OpenFiles(vec![fits]));
    settle(window, |state| state.jobs.is_empty());
    send(window, Msg::Fit(FitMsg::Overlay(fitted, true)));
    run(window, Command::OpenSample(1));
    settle(window, |state| state.jobs.is_empty());
    set_slider(window, "s", 33.0);
    run(window, Command::UseFresnel(Fresnel::None));
    run(window, Command::UseLights(2));
    run(window, Command::ToggleCosine);
    run(window, Command::ToggleTile(ViewId::Slices));
    send(window, Msg::SetBeside(0, true));
    let probe = grazing::app::state::probe::Probe::in_plane(0.9, 0.4);
    send(window, Msg::Pin(Some(probe)));
}

fn data(window: &Window) -> String {
    SessionFile::of(window.state().state())
        .text()
        .expect("JSON")
}

fn names(state: &State) -> Vec<&str> {
    let opened = state.scene.opened.iter();
    opened
        .map(|one| state.materials[&one.id].name.as_str())
        .collect()
}

/// All texts and numbers on screen.
fn on_screen(window: &Window) -> Vec<String> {
    let nodes = window.root().children_recursive();
    let mut texts: Vec<String> = nodes
        .map(|node| {
            let node = node.accesskit_node();
            let number = node.numeric_value().map(|x| format!("{x:?}"));
            format!("{:?} {:?} {number:?}", node.label(), node.value())
        })
        .collect();
    texts.sort();
    texts
}

#[track_caller]
fn said<'a>(state: &'a State, words: &str) -> &'a str {
    let found = state
        .notices
        .iter()
        .find(|notice| notice.text.contains(words));
    let notice = found.unwrap_or_else(|| panic!("{words}: {:?}", state.notices));
    assert_eq!(notice.text.lines().count(), 1);
    &notice.text
}

fn dismiss_all(window: &mut Window) {
    let ids: Vec<u64> = window
        .state()
        .state()
        .notices
        .iter()
        .map(|n| n.id)
        .collect();
    for id in ids {
        send(window, Msg::Dismiss(id));
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_saved_session_opens_in_a_new_window_with_the_same_numbers_on_screen() {
    let folder = Folder::new();
    let [gold, tin] = ["gold.binary", "tin.binary"].map(|name| folder.path(name));
    write_merl(&gold);
    fs::copy(&gold, &tin).expect("copied");
    let chosen = folder.path("teflon study");
    let file = folder.path("teflon study.grazing.json");
    let mut first = with_dialogs(&[&gold, &tin], None, Some(&chosen));
    make_rich(&mut first, &gold);
    press(&mut first, Modifiers::COMMAND, Key::S);
    settle(&mut first, |state| !state.notices.is_empty());
    assert!(said(first.state().state(), "Saved").ends_with("study.grazing.json"));
    assert_eq!(first.state().state().title(), "teflon study — Grazing");
    dismiss_all(&mut first);
    assert!(file.is_file());

    let mut second = with_dialogs(&[&file], None, None);
    let state = second.state().state();
    assert_eq!(names(state), ["gold", "tin", "Green lacquer (synthetic)"]);
    assert_eq!(state.notices, []);
    assert_eq!(state.prefs.recent.front(), Some(&file));
    assert!(!state.tiles.is_open(ViewId::Slices));
    assert_eq!(data(&second), data(&first));
    for window in [&mut first, &mut second] {
        settle(window, |state| {
            state
                .materials
                .values()
                .all(|one| one.table.valid_count() > 0)
        });
        window.run_steps(3);
    }
    let (before, after) = (on_screen(&first), on_screen(&second));
    let numbers = before.iter().filter(|text| text.contains("0.")).count();
    assert!(numbers > 10, "{before:?}");
    assert_eq!(before, after);
    // Planted: another number would be seen.
    set_slider(&mut second, "s", 5.0);
    assert_ne!(on_screen(&second), before);

    // Saved again to the same file, without asking.
    press(&mut second, Modifiers::COMMAND, Key::S);
    settle(&mut second, |state| !state.notices.is_empty());
    let third = with_dialogs(&[&file], None, None);
    assert_eq!(data(&third), data(&second));
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_title_of_the_window_is_the_name_of_the_session() {
    let folder = Folder::new();
    let file = folder.path("a study.grazing.json");
    fs::write(&file, r#"{"grazing_session": 1, "materials": []}"#).expect("written");
    let mut window = window(vec![], vec![file.clone()]);
    let titles = |window: &Window| -> Vec<String> {
        let outputs = window.output().viewport_output.values();
        let commands = outputs.flat_map(|output| &output.commands);
        commands
            .filter_map(|command| match command {
                egui::ViewportCommand::Title(title) => Some(title.clone()),
                _ => None,
            })
            .collect()
    };
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    let seen = settle_on(&mut window, |window| {
        Some(titles(window)).filter(|titles| !titles.is_empty())
    });
    assert_eq!(seen, ["a study — Grazing"]);
    // What was open comes back, under no name.
    assert!(window.state().state().scene.opened.is_empty());
    run(&mut window, Command::Undo);
    assert_eq!(window.state().state().scene.opened.len(), 1);
    assert_eq!(window.state().state().title(), "Grazing");
}

/// A session with two files, saved where they are, and then moved to another folder.
fn moved(folder: &Path) -> (PathBuf, PathBuf, String) {
    let [here, there] = ["here", "there"].map(|name| folder.join(name));
    fs::create_dir_all(&here)
        .and_then(|()| fs::create_dir_all(&there))
        .expect("folders");
    let [gold, tin] = ["gold.binary", "tin.binary"].map(|name| here.join(name));
    write_merl(&gold);
    fs::copy(&gold, &tin).expect("copied");
    let file = folder.join("study.grazing.json");
    let mut window = with_dialogs(&[&gold, &tin], None, Some(&file));
    make_rich(&mut window, &gold);
    press(&mut window, Modifiers::COMMAND, Key::S);
    settle(&mut window, |state| !state.notices.is_empty());
    for path in [&gold, &tin] {
        fs::rename(path, there.join(path.file_name().expect("a name"))).expect("moved");
    }
    let data = fs::read_to_string(&file).expect("the session");
    (file, there, data)
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_missing_material_is_asked_for_and_the_one_beside_it_is_found_too() {
    let folder = Folder::new();
    let (file, there, before) = moved(folder.root());
    let again = folder.path("again.grazing.json");
    let mut window = with_dialogs(&[&file], Some(&there.join("gold.binary")), Some(&again));
    let state = window.state().state();
    // The rest is open, and the models too whose data are missing.
    assert_eq!(names(state).len(), 3);
    assert_eq!(state.materials[&state.scene.opened[0].id].fits.len(), 1);
    assert!(state.current().expect("one").0.table.valid_count() > 0);
    window.get_by_label("gold is not where it was");
    let tried = folder.path("here/gold.binary").display().to_string();
    window.get_by_label(&tried);
    // Saved while they are missing, nothing of them is lost.
    run(&mut window, Command::SaveSessionAs);
    settle(&mut window, |state| !state.notices.is_empty());
    assert_eq!(fs::read_to_string(&again).expect("saved"), before);
    dismiss_all(&mut window);

    click(&mut window, "Locate…");
    settle(&mut window, |state| {
        state.jobs.is_empty() && state.asked_for().is_none()
    });
    let state = window.state().state();
    assert_eq!(state.notices, []);
    for (id, name) in [(0, "gold"), (1, "tin")] {
        let material = &state.materials[&state.scene.opened[id].id];
        assert_eq!(material.file(), Some(there.join(format!("{name}.binary"))));
    }
    assert!(window.query_by_label("gold is not where it was").is_none());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn files_moved_with_their_session_are_found_and_skipping_leaves_the_rest() {
    let folder = Folder::new();
    let (file, there, _) = moved(folder.root());
    // As they were: "here" beside the session, in another folder.
    let other = folder.path("other");
    fs::create_dir(&other).expect("a folder");
    fs::rename(&there, other.join("here")).expect("moved");
    let there = other.join("study.grazing.json");
    fs::copy(&file, &there).expect("copied");
    let window = with_dialogs(&[&there], None, None);
    let state = window.state().state();
    assert_eq!((state.asked_for(), &state.notices[..]), (None, &[][..]));
    let gold = &state.materials[&state.scene.opened[0].id];
    assert_eq!(gold.file(), Some(other.join("here/gold.binary")));

    let mut window = with_dialogs(&[&file], None, None);
    click(&mut window, "Skip");
    window.get_by_label("tin is not where it was");
    click(&mut window, "Skip");
    assert_eq!(window.state().state().asked_for(), None);
    // It can still be said later.
    window.get_by_role_and_label(Role::Button, "Locate tin");
    assert_eq!(window.state().state().scene.opened.len(), 3);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_changed_file_opens_and_is_noticed() {
    let folder = Folder::new();
    let gold = folder.path("gold.binary");
    write_merl(&gold);
    let file = folder.path("study.grazing.json");
    let mut window = with_dialogs(&[&gold], None, Some(&file));
    set_slider(&mut window, "s", 17.0);
    press(&mut window, Modifiers::COMMAND, Key::S);
    settle(&mut window, |state| !state.notices.is_empty());
    let unchanged = with_dialogs(&[&file], None, None);
    assert_eq!(unchanged.state().state().notices, []);

    let mut bytes = fs::read(&gold).expect("bytes");
    let value = 12 + 8 * 800_000;
    bytes[value..value + 8].copy_from_slice(&1.5f64.to_le_bytes());
    fs::write(&gold, bytes).expect("written");
    let window = with_dialogs(&[&file], None, None);
    let state = window.state().state();
    let text = said(
        state,
        "the data of gold have changed since the session was saved",
    );
    assert!(text.ends_with(&format!(": {}", gold.display())), "{text}");
    let (material, opened) = state.current().expect("it opens");
    assert!(material.table.valid_count() > 0);
    assert!((opened.brdf.params.s - 17.0).abs() < 0.2);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn broken_sessions_leave_what_is_open_and_say_why_in_one_line() {
    let folder = Folder::new();
    let mut window = window(vec![], vec![]);
    let before = data(&window);
    for (text, words) in [
        (
            r#"{"grazing_session": 1, "materials": [{"na"#,
            "not valid JSON: EOF",
        ),
        (
            r#"{"grazing_session": 9, "materials": []}"#,
            "version 9; expected 1",
        ),
        (
            r#"{"grazing_session": 1, "materials": 7}"#,
            "no array \"materials\"",
        ),
        (
            r#"{"model": "phong"}"#,
            "\"rho_d\" (diffuse reflectance) is missing",
        ),
        ("", "empty"),
    ] {
        let path = folder.path("bad.grazing.json");
        fs::write(&path, text).expect("written");
        send(&mut window, Msg::OpenFiles(vec![path.clone()]));
        settle(&mut window, |state| state.jobs.is_empty());
        let state = window.state().state();
        assert_eq!(state.notices.len(), 1, "{text}");
        assert_eq!(state.notices[0].level, Severity::Error);
        assert!(said(state, words).ends_with(&format!(": {}", path.display())));
        assert_eq!(data(&window), before);
        dismiss_all(&mut window);
    }
}

/// The sessions and locks in the folder.
fn left_in(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    entries
        .map(|entry| entry.expect("an entry").path())
        .collect()
}

/// Lets time pass until what is open is kept. Steps are 0.03 s for the window.
fn until_kept(window: &mut Window, folder: &Path) -> PathBuf {
    settle_on(window, |_| {
        let mut left = left_in(folder).into_iter();
        left.find(|path| path.extension().is_some_and(|e| e == "json"))
    })
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn after_a_crash_what_was_open_is_offered_and_restored() {
    let folder = Folder::new();
    let kept = folder.path("autosave");
    let gold = folder.path("gold.binary");
    write_merl(&gold);
    let mut first = kept_in(&kept, &[&gold]);
    set_slider(&mut first, "s", 44.0);
    let file = until_kept(&mut first, &kept);
    let before = data(&first);
    // Another run that starts meanwhile is offered nothing.
    let mut beside = kept_in(&kept, &[]);
    assert_eq!(beside.state().state().session.crashed, []);
    beside.state_mut().on_exit();
    drop(beside);
    assert!(file.is_file());
    // It goes without its last words.
    drop(first);

    let tin = folder.path("tin.binary");
    fs::copy(&gold, &tin).expect("copied");
    let mut second = kept_in(&kept, &[&tin]);
    assert_eq!(
        names(second.state().state()),
        ["tin"],
        "files are opened anyway"
    );
    second.get_by_label("Grazing ended unexpectedly");
    click(&mut second, "Restore");
    settle(&mut second, |state| state.jobs.is_empty());
    assert_eq!(data(&second), before);
    assert_eq!(second.state().state().title(), "Grazing");
    assert!(
        second
            .query_by_label("Grazing ended unexpectedly")
            .is_none()
    );
    // Until this run has kept it too, the old one stays.
    assert!(file.is_file());
    for _ in 0..1000 {
        second.step();
        // Its lock goes after it.
        if !file.exists() && left_in(&kept).len() == 2 {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    assert!(!file.exists());
    assert_eq!(left_in(&kept).len(), 2, "a lock and what is open");
    run(&mut second, Command::Undo);
    assert_eq!(names(second.state().state()), ["tin"]);
    second.state_mut().on_exit();
    drop(second);
    assert_eq!(left_in(&kept), Vec::<PathBuf>::new());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_cannot_be_restored_is_said_once_and_kept() {
    let folder = Folder::new();
    let kept = folder.root();
    let mut first = kept_in(kept, &[]);
    set_slider(&mut first, "s", 44.0);
    let file = until_kept(&mut first, kept);
    drop(first);
    let text = fs::read_to_string(&file).expect("a session");
    let half = &text[..text.len() / 2];
    fs::write(&file, half).expect("is damaged");

    let mut second = kept_in(kept, &[]);
    click(&mut second, "Restore");
    let damaged = settle_on(&mut second, |_| {
        let mut left = left_in(kept).into_iter();
        left.find(|path| path.extension().is_some_and(|e| e == "damaged"))
    });
    said(second.state().state(), "What was open cannot be restored");
    assert_eq!(fs::read_to_string(&damaged).expect("is kept"), half);
    second.state_mut().on_exit();
    drop(second);
    assert_eq!(left_in(kept), [damaged]);
    let third = kept_in(kept, &[]);
    assert_eq!(third.state().state().session.crashed, []);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_is_discarded_is_not_offered_again_and_a_clean_exit_leaves_nothing() {
    let folder = Folder::new();
    let kept = folder.root();
    let mut first = kept_in(kept, &[]);
    // What every start shows is not worth keeping.
    first.run_steps(150);
    assert_eq!(left_in(kept).len(), 1, "the lock");
    set_slider(&mut first, "s", 44.0);
    until_kept(&mut first, kept);
    drop(first);

    let mut second = kept_in(kept, &[]);
    click(&mut second, "Discard");
    settle_on(&mut second, |_| (left_in(kept).len() == 1).then_some(()));
    set_slider(&mut second, "s", 55.0);
    until_kept(&mut second, kept);
    second.state_mut().on_exit();
    drop(second);
    assert_eq!(left_in(kept), Vec::<PathBuf>::new());
    let third = kept_in(kept, &[]);
    assert_eq!(third.state().state().session.crashed, []);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn an_idle_window_neither_writes_nor_repaints() {
    let folder = Folder::new();
    let mut window = kept_in(folder.root(), &[]);
    set_slider(&mut window, "s", 44.0);
    let delay = |window: &Window| {
        let outputs = window.output().viewport_output.values();
        outputs
            .map(|output| output.repaint_delay)
            .min()
            .expect("one")
    };
    // Something is to be written: the window wakes for it, and only then.
    window.run_steps(5);
    let waits = delay(&window).as_secs_f64();
    assert!((0.5..=3.0).contains(&waits), "{waits}");
    let file = until_kept(&mut window, folder.root());
    window.run_steps(10);
    assert!(delay(&window).as_secs() > 3600);
    let written = || {
        fs::metadata(&file)
            .and_then(|data| data.modified())
            .expect("there")
    };
    let before = written();
    window.run_steps(300);
    assert_eq!(written(), before);
    // A change is written again.
    set_slider(&mut window, "s", 45.0);
    let text = fs::read_to_string(&file).expect("there");
    settle_on(&mut window, |_| {
        (fs::read_to_string(&file).expect("there") != text).then_some(())
    });
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_home_where_nothing_can_be_kept_is_told_once_by_what_it_means() {
    let folder = Folder::new();
    let file = folder.path("file");
    fs::write(&file, "").expect("written");
    let below = file.join("autosave");
    let mut window = kept_in(&below, &[]);
    set_slider(&mut window, "s", 45.0);
    window.run_steps(200);
    let state = window.state().state();
    let [notice] = state.notices.as_slice() else {
        panic!("{:?}", state.notices)
    };
    assert!(
        notice
            .text
            .contains("Settings and recovery after a crash are off")
    );
    assert!(!notice.text.contains(&below.display().to_string()));
    assert_eq!(state.scene.opened.len(), 1);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_cannot_be_kept_any_more_is_told_once_until_it_can_be_again() {
    let folder = Folder::new();
    let (kept, away) = (folder.path("autosave"), folder.path("away"));
    let mut window = kept_in(&kept, &[]);
    fs::rename(&kept, &away).expect("renamed");
    set_slider(&mut window, "s", 44.0);
    settle(&mut window, |state| !state.notices.is_empty());
    said(window.state().state(), "not kept for a crash");
    set_slider(&mut window, "s", 45.0);
    window.run_steps(300);
    fs::rename(&away, &kept).expect("renamed");
    set_slider(&mut window, "s", 46.0);
    until_kept(&mut window, &kept);
    assert_eq!(window.state().state().notices.len(), 1);
}

/// Where a save is refused, the file that was there stays and the reason is said.
#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_save_that_fails_says_so_and_leaves_what_was_there() {
    let folder = Folder::new();
    let nowhere = folder.path("no/such/study.grazing.json");
    let mut window = with_dialogs(&[], None, Some(&nowhere));
    run(&mut window, Command::SaveSession);
    settle(&mut window, |state| !state.notices.is_empty());
    said(window.state().state(), "there is no directory for the file");
    assert_eq!(window.state().state().title(), "Grazing");
    // The proposed name is that of the shown material.
    let asked = Arc::new(Mutex::new(String::new()));
    let heard = Arc::clone(&asked);
    let mut window = window_of(WindowOptions {
        files: vec![],
        picker: Picker {
            save: Arc::new(move |name| {
                *heard.lock().expect("nobody panicked") = name.into();
                None
            }),
            ..nothing_picked()
        },
        autosave: None,
        prefs: not_fitted_on_opening(),
    });
    run(&mut window, Command::SaveSession);
    settle(&mut window, |_| {
        !asked.lock().expect("nobody panicked").is_empty()
    });
    let name = asked.lock().expect("nobody panicked").clone();
    assert_eq!(name, "Copper glaze (synthetic).grazing.json");
}
