//! What is open is kept for a crash, in the real window: written, offered, restored, thrown away.

use crate::common::folder::{Folder, left_in};
use crate::common::records::write_merl;
use crate::common::window::{
    Window, click, close, data, kept_in, names, run, said, set_slider, settle, settle_on,
};
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use std::fs;
use std::path::{Path, PathBuf};

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
    let beside = kept_in(&kept, &[]);
    assert_eq!(beside.state().state().session.crashed, []);
    close(beside);
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
    close(second);
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
    close(second);
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
    close(second);
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
