//! The program with its real window, on a virtual display.

use super::display::{Display, Running};
use super::wait::settle;
use std::path::Path;
use std::process::Command;

/// The program with a window on a display, whose own folder is in this one.
pub fn grazing_on(display: &Display, home: &Path) -> Command {
    let mut command = display.command(env!("CARGO_BIN_EXE_grazing"));
    for name in ["XDG_RUNTIME_DIR", "XDG_DATA_HOME"] {
        command.env(name, home);
    }
    command
}

/// Waits for the window of a process; its number for xdotool.
#[track_caller]
pub fn until_window_of(display: &Display, process: &mut Running) -> String {
    let id = process.0.id().to_string();
    settle(|| {
        let mut search = Command::new("xdotool");
        search.args(["search", "--onlyvisible", "--pid", &id]);
        search.args(["--all", "--name", "Grazing"]);
        let output = search.env("DISPLAY", &display.name).output();
        let output = output.expect("xdotool; tests/run installs it");
        let found = String::from_utf8_lossy(&output.stdout);
        match found.lines().next() {
            Some(window) => Ok(window.to_string()),
            None => Err(format!("no window; {:?}", process.0.try_wait())),
        }
    })
}
