//! A monkey: random gestures on the real window.

use crate::common::display::Display;
use crate::common::folder::Folder;
use crate::common::merl::merl_file;
use crate::common::real_window::{grazing_on, until_window_of};
use crate::process::Watched;
use fastrand::Rng;
use std::io::Write as _;
use std::process::{Child, ChildStdin, Stdio};
use std::time::{Duration, Instant};

const SIZE: [u32; 2] = [1280, 800];

/// Keys with a meaning in the window, and some without.
const KEYS: [&str; 28] = [
    "ctrl+z",
    "ctrl+shift+z",
    "ctrl+f",
    "ctrl+p",
    "ctrl+s",
    "ctrl+o",
    "ctrl+e",
    "ctrl+c",
    "ctrl+plus",
    "ctrl+minus",
    "ctrl+0",
    "ctrl+w",
    "ctrl+q",
    "Escape",
    "Return",
    "Tab",
    "space",
    "Left",
    "Right",
    "Up",
    "Down",
    "Home",
    "End",
    "Delete",
    "F1",
    "F11",
    "1",
    "a",
];

/// A hand: xdotool that reads its commands from here.
struct Hand {
    _tool: Child,
    to: ChildStdin,
}

impl Hand {
    fn of(display: &Display) -> Self {
        let mut tool = display.command("xdotool");
        let tool = tool
            .arg("-")
            .stdin(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut tool = tool.expect("xdotool; tests/run installs it");
        Self {
            to: tool.stdin.take().expect("piped"),
            _tool: tool,
        }
    }

    fn does(&mut self, line: &str) {
        writeln!(self.to, "{line}")
            .and_then(|()| self.to.flush())
            .expect("xdotool reads");
    }

    /// One gesture.
    fn plays(&mut self, random: &mut Rng) {
        let mut place = || {
            let [x, y] = SIZE.map(|n| random.u32(..n));
            format!("mousemove {x} {y}")
        };
        let (from, to) = (place(), place());
        match random.u32(..10) {
            0..4 => self.does(&format!("{from} click 1")),
            4..6 => self.does(&format!("{from} mousedown 1 {to} mouseup 1")),
            6 => self.does(&format!("{from} click {}", 2 + random.u32(..4))),
            7 => self.does(&format!("{from} click --repeat 2 --delay 20 1")),
            _ => {
                let key = KEYS[random.usize(..KEYS.len())];
                self.does(&format!("{from} key {key}"));
            }
        }
    }
}

/// Plays for these minutes and reports.
pub fn run(minutes: f64, seed: u64) {
    let display = Display::of_size(SIZE);
    let home = Folder::new();
    let tin = home.file(
        "tin.binary",
        merl_file(|at| Some([0.2 + at.wh_n.cos.powi(40), 0.3, 0.4])),
    );
    let start = || {
        let mut window = Watched::start(grazing_on(&display, home.root()).arg(&tin));
        let id = until_window_of(&display, &mut window.process);
        let mut tool = display.command("xdotool");
        let _ = tool.args(["windowfocus", &id]).status();
        window
    };
    let mut window = start();
    let (mut random, mut hand) = (Rng::with_seed(seed), Hand::of(&display));
    let began = Instant::now();
    let (mut gestures, mut starts, mut reported) = (0, 1, 0);
    let mut first = None;
    while began.elapsed().as_secs_f64() < 60.0 * minutes {
        hand.plays(&mut random);
        gestures += 1;
        std::thread::sleep(Duration::from_millis(30));
        let said = window.said();
        assert!(
            !said.iter().any(|line| line.contains("panicked")),
            "seed {seed}, gesture {gestures}: {said:?}"
        );
        if let Some(ended) = window.has_ended() {
            // Ctrl+Q and the button that goes with it close it.
            assert_eq!(ended, "exit status: 0", "seed {seed}, gesture {gestures}");
            window = start();
            starts += 1;
        }
        if began.elapsed().as_secs() / 30 > reported {
            reported += 1;
            let [mib, files, threads] = window.holds();
            println!(
                "soak: {gestures} gestures, {starts} starts: {mib} MiB, {files} files, {threads} threads"
            );
            first.get_or_insert([mib, files, threads]);
        }
    }
    let [mib, files, threads] = window.holds();
    println!(
        "soak: seed {seed}, {gestures} gestures, {starts} starts, no panic: {mib} MiB, {files} files, {threads} threads at the end"
    );
}
