//! The device of the window: lost, or too small for it.

use crate::common::display::Display;
use crate::common::folder::Folder;
use crate::common::merl::merl_file;
use crate::common::real_window::{grazing_on, until_window_of};
use crate::common::wait::settle;
use crate::process::{Watched, colors};
use std::cell::Cell;
use std::fs;
use std::path::PathBuf;
use std::thread;
use std::time::Duration;

/// Variable that makes this program a window whose first device is destroyed; its value is the file to open.
pub const WINDOW: &str = "GRAZING_SOAK_WINDOW";

const SHADED: usize = 3000;

/// The window. Says each opening.
pub fn window() {
    let file = PathBuf::from(std::env::var_os(WINDOW).expect("a file"));
    let openings = Cell::new(0);
    let opened = |cc: &eframe::CreationContext<'_>| {
        openings.set(openings.get() + 1);
        eprintln!("opening {}", openings.get());
        if openings.get() == 1 {
            let device = cc.wgpu_render_state.as_ref().expect("wgpu").device.clone();
            thread::spawn(move || {
                thread::sleep(Duration::from_secs(4));
                device.destroy();
                // What a driver that is gone answers at the next call, this one answers when it is asked.
                let _ = device.poll(eframe::wgpu::PollType::Poll);
            });
        }
    };
    grazing::app::startup::run_watched(vec![file], opened).expect("a window");
}

/// The session that a window keeps in its folder, where there is one.
fn kept(home: &Folder) -> Option<String> {
    let files = fs::read_dir(home.path("grazing/autosave")).ok()?.flatten();
    let mut sessions = files
        .map(|file| file.path())
        .filter(|path| path.extension().is_some_and(|e| e == "json"));
    fs::read_to_string(sessions.next()?).ok()
}

fn until_shaded(display: &Display, window: &mut Watched) {
    settle(|| match (colors(display), window.has_ended()) {
        (_, Some(ended)) => panic!("it ended: {ended}"),
        (colors, None) if colors < SHADED => Err(format!("{colors} colours on the screen")),
        _ => Ok(()),
    });
}

pub fn a_window_whose_device_is_lost_opens_again_with_what_was_open() {
    let display = Display::of_size([1280, 800]);
    let home = Folder::new();
    let tin = home.file("tin.binary", merl_file(|_| Some([0.2, 0.3, 0.4])));
    let mut command = display.command(std::env::current_exe().expect("a path"));
    for name in ["XDG_RUNTIME_DIR", "XDG_DATA_HOME"] {
        command.env(name, home.root());
    }
    let mut window = Watched::start(command.env(WINDOW, &tin));
    let mut said = Vec::new();
    settle(|| {
        said.extend(window.said());
        if let Some(ended) = window.has_ended() {
            panic!("it ended: {ended}; {said:?}");
        }
        let again = said.iter().any(|line| line == "opening 2");
        again.then_some(()).ok_or_else(|| format!("{said:?}"))
    });
    until_shaded(&display, &mut window);
    settle(|| {
        let kept = kept(&home).unwrap_or_default();
        let whole = kept.contains("tin.binary");
        whole.then_some(()).ok_or(kept)
    });
    assert_eq!(window.said(), [""; 0], "nothing is said on the terminal");
    println!("soak: a lost device was opened again with what was open");
}

pub fn a_window_larger_than_the_adapter_draws_goes_on() {
    // llvmpipe draws 16,384 pixels a side.
    let display = Display::of_size([17_000, 700]);
    let home = Folder::new();
    let mut window = Watched::start(&mut grazing_on(&display, home.root()));
    let id = until_window_of(&display, &mut window.process);
    let xdotool = |args: &[&str]| {
        let mut command = display.command("xdotool");
        let output = command.args(args).output().expect("xdotool");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let width = || -> usize {
        let text = xdotool(&["getwindowgeometry", "--shell", &id]);
        let line = text.lines().find_map(|line| line.strip_prefix("WIDTH="));
        line.and_then(|width| width.parse().ok()).unwrap_or(0)
    };
    // Beyond the fixed 8192 of before, and beyond what the adapter has.
    for (asked, expected) in [("9000", 9000..=9000), ("16900", 8193..=16_384)] {
        xdotool(&["windowsize", &id, asked, "690"]);
        settle(|| {
            if let Some(ended) = window.has_ended() {
                panic!("it ended: {ended}");
            }
            let width = width();
            let fits = expected.contains(&width);
            fits.then_some(())
                .ok_or_else(|| format!("{width} pixels wide"))
        });
        // It ends, if at all, with one of the next frames.
        thread::sleep(Duration::from_secs(2));
        assert_eq!(window.has_ended(), None);
    }
    let said = window.said();
    assert!(
        said.iter().all(|line| !line.contains("panicked")),
        "{said:?}"
    );
    println!("soak: a window of 16,900 pixels became one of {}", width());
}
