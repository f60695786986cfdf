//! Files whose names are not UTF-8, in the real window: recent files, sessions, fit files, what a crash leaves.
//!
//! Linux takes any bytes as a name; other systems refuse these.
#![cfg(target_os = "linux")]

use crate::common::folder::Folder;
use crate::common::records::{combined, only_named, record, write_fits, write_merl};
use crate::common::window::{
    Window, click, close, run, send, set_slider, settle, settle_on, window_with_boxes, with_answers,
};
use eframe::App as _;
use grazing::app::WindowOptions;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::State;
use grazing::app::state::layout::Tiles;
use grazing::app::state::prefs::Prefs;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::path::{Path, PathBuf};

fn name(bytes: &[u8]) -> &Path {
    Path::new(OsStr::from_bytes(bytes))
}

/// A folder of such a name, with a measured file of such a name.
fn gray(folder: &Folder) -> PathBuf {
    let inside = folder.path(name(b"\xe4 b%41"));
    fs::create_dir(&inside).expect("a folder");
    let file = inside.join(name(b"gr\xe9\xe9n.binary"));
    write_merl(&file);
    file
}

/// A window whose dialogs answer with these paths.
fn window(files: &[&Path], open: Option<&Path>, save: Option<&Path>) -> Window {
    let mut window = window_with_boxes(with_answers(files, open, save));
    settle(&mut window, |state| state.jobs.is_empty());
    window
}

fn save_session(window: &mut Window) {
    run(window, Command::SaveSession);
    settle(window, |state| {
        state.notices.iter().any(|n| n.text.starts_with("Saved"))
    });
    let id = window.state().state().notices[0].id;
    send(window, Msg::Dismiss(id));
}

/// The shown material is this file, with its data, and nothing was remarked.
#[track_caller]
fn is_shown(state: &State, file: &Path) {
    let (material, _) = state.current().expect("a material");
    assert_eq!(state.notices, []);
    assert_eq!(state.asked_for(), None);
    assert_eq!(material.file().as_deref(), Some(file));
    assert!(material.table.valid_count() > 0);
}

/// Keeps what eframe does between two runs.
#[derive(Default)]
struct Kept(BTreeMap<String, String>);

impl eframe::Storage for Kept {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.into(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn preferences_keep_the_recent_files_and_the_folder() {
    let folder = Folder::new();
    let file = gray(&folder);
    let inside = file.parent().expect("a folder");
    let mut first = window(&[&file, inside], None, None);
    settle(&mut first, |state| state.prefs.folder.is_some());
    let mut kept = Kept::default();
    first.state_mut().save(&mut kept);
    let prefs: Prefs = eframe::get_value(&kept, "grazing.prefs").expect("preferences");
    assert_eq!(prefs, first.state().state().prefs);
    assert!(prefs.recent.contains(&file), "{:?}", prefs.recent);
    assert_eq!(prefs.folder.as_deref(), Some(inside));

    // What serde makes of paths that are UTF-8 is what is kept of them.
    let old = "(recent:[\"/data/gold.binary\"],theme:Dark,folder:Some(\"/data\"))";
    kept.0.insert("grazing.prefs".into(), old.into());
    let prefs: Prefs = eframe::get_value(&kept, "grazing.prefs").expect("preferences");
    assert_eq!(prefs.recent, [Path::new("/data/gold.binary")]);
    assert_eq!(prefs.folder.as_deref(), Some(Path::new("/data")));

    let mut recent = first.state().state().prefs.recent.iter();
    let index = recent.position(|recent| *recent == file);
    run(&mut first, Command::Close);
    assert!(first.state().state().current().is_none());
    run(
        &mut first,
        Command::OpenRecent(index.expect("it is listed")),
    );
    settle(&mut first, |state| state.jobs.is_empty());
    is_shown(first.state().state(), &file);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_session_finds_its_file_where_it_was_and_moved_along() {
    let folder = Folder::new();
    let file = gray(&folder);
    let session = folder.path(name(b"\xfcber.grazing.json"));
    let mut first = window(&[&file], None, Some(&session));
    set_slider(&mut first, "s", 17.0);
    save_session(&mut first);
    let second = window(&[&session], None, None);
    is_shown(second.state().state(), &file);
    assert_eq!(second.state().state().prefs.recent.front(), Some(&session));

    // By its path from the folder of the session on, then by its name alone.
    let moved = Folder::new();
    let inside = file.parent().expect("a folder");
    let new_inside = moved.path(inside.file_name().expect("a name"));
    fs::rename(inside, &new_inside).expect("moved");
    let session = moved.file("moved.grazing.json", fs::read(&session).expect("a session"));
    let there = new_inside.join(file.file_name().expect("a name"));
    is_shown(window(&[&session], None, None).state().state(), &there);
    let beside = moved.path(file.file_name().expect("a name"));
    fs::rename(&there, &beside).expect("moved");
    is_shown(window(&[&session], None, None).state().state(), &beside);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_was_located_brings_its_neighbour_along() {
    let folder = Folder::new();
    let file = gray(&folder);
    let tin = file.with_file_name(name(b"t\xefn.binary"));
    fs::copy(&file, &tin).expect("copied");
    let session = folder.path("study.grazing.json");
    let mut first = window(&[&file, &tin], None, Some(&session));
    save_session(&mut first);
    let elsewhere = Folder::new();
    let [new, new_tin] = [&file, &tin].map(|path| {
        let new = elsewhere.path(path.file_name().expect("a name"));
        fs::rename(path, &new).expect("moved");
        new
    });
    let mut second = window(&[&session], Some(&new), None);
    click(&mut second, "Locate…");
    settle(&mut second, |state| {
        state.jobs.is_empty() && state.asked_for().is_none()
    });
    is_shown(second.state().state(), &new_tin);
    send(&mut second, Msg::Select(0));
    is_shown(second.state().state(), &new);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_fit_file_finds_its_measured_file() {
    let folder = Folder::new();
    let file = gray(&folder);
    let fits = folder.path("fits.json");
    let fit = record("green", Some(only_named(&file)), combined(21.0, 0.5), 0.1);
    write_fits(&fits, &[fit]);
    let window = window(&[&fits], None, None);
    let state = window.state().state();
    is_shown(state, &file);
    assert_eq!(state.current().expect("one").1.brdf.params.lobe[0], 21.0);
}

/// The autosave folder, the session that it belongs to, and the data: all of such names.
#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn after_a_crash_the_file_and_the_name_of_the_session_come_back() {
    let folder = Folder::new();
    let file = gray(&folder);
    let kept = folder.path(name(b"k\xe9pt"));
    let session = folder.path(name(b"\xfcber.grazing.json"));
    let start = |files: Vec<PathBuf>| {
        let mut window = window_with_boxes(WindowOptions {
            files,
            autosave: Some(kept.clone()),
            ..with_answers(&[], None, Some(&session))
        });
        send(&mut window, Msg::SetLayout(Tiles::none()));
        window
    };
    let mut first = start(vec![file.clone()]);
    save_session(&mut first);
    set_slider(&mut first, "s", 44.0);
    let left = || -> Vec<PathBuf> {
        let entries = fs::read_dir(&kept).expect("a folder");
        entries.map(|e| e.expect("an entry").path()).collect()
    };
    settle_on(&mut first, |_| {
        left().into_iter().find(|path| {
            let text = fs::read_to_string(path).unwrap_or_default();
            text.contains("saved_as")
        })
    });
    // It goes without its last words.
    drop(first);
    let mut second = start(vec![]);
    click(&mut second, "Restore");
    settle(&mut second, |state| state.jobs.is_empty());
    let state = second.state().state();
    is_shown(state, &file);
    let saved_as = state.session.files.get(&state.scene.session);
    assert_eq!(saved_as, Some(&session));
    close(second);
    assert_eq!(left(), Vec::<PathBuf>::new());
}
