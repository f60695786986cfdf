//! Sessions in the real window: saved, opened again, with files that moved or changed, and after a crash.

use crate::common::folder::Folder;
use crate::common::records::{combined, only_named, record, write_fits, write_merl};
use crate::common::window::{
    Window, click, data, names, not_fitted_on_opening, nothing_picked, press, run, said, send,
    set_slider, settle, settle_on, window, window_of, with_answers,
};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::fit::FitMsg;
use grazing::app::state::notice::Severity;
use grazing::app::state::views::ViewId;
use grazing::app::{Picker, WindowOptions};
use grazing::brdf::COMBINED;
use grazing::brdf::Fresnel;
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
            combined(21.0, COMBINED.default_lobe()[1]),
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
    assert!((opened.brdf.params.lobe[0] - 17.0).abs() < 0.2);
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
        notice: None,
    });
    run(&mut window, Command::SaveSession);
    settle(&mut window, |_| {
        !asked.lock().expect("nobody panicked").is_empty()
    });
    let name = asked.lock().expect("nobody panicked").clone();
    assert_eq!(name, "Copper glaze (synthetic).grazing.json");
}
