//! Words on the terminal about a window that cannot be opened.

use std::io::Write as _;
use std::{env, io};

/// The packages that a window needs on Debian and Ubuntu beyond a bare system.
pub const APT_LINE: &str = "sudo apt-get install -y libxkbcommon-x11-0 libxcursor1 libxi6 libx11-xcb1 mesa-vulkan-drivers libegl1 libgl1-mesa-dri";

/// A command line that ends with something to look at wherever the program runs.
const FIGURE: &str = "figure --preset lobes -o lobes.pdf";

/// Part that a window lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    Library,
    Display,
    Driver,
}

impl Failure {
    /// Part whose lack an error tells of.
    pub(super) fn of(error: &eframe::Error) -> Self {
        match error {
            eframe::Error::Winit(_) | eframe::Error::WinitEventLoop(_) => {
                // winit tells a library that is not there by its words alone.
                let text = error.to_string().to_lowercase();
                if ["librar", "nowaylandlib"]
                    .iter()
                    .any(|word| text.contains(word))
                {
                    Self::Library
                } else {
                    Self::Display
                }
            }
            eframe::Error::AppCreation(_) | eframe::Error::Wgpu(_) => Self::Driver,
        }
    }
}

/// Why there is no window, in words and with what to do.
pub(super) fn explain(failure: Failure, error: &str) -> String {
    // winit puts the place in its source before the reason.
    let error = match error.split_once(".rs:") {
        Some((_, rest)) => rest.split_once(": ").map_or(rest, |(_, reason)| reason),
        None => error,
    };
    let (what, todo) = match failure {
        Failure::Library => (
            "a library that the window needs is missing",
            format!("Install it: {APT_LINE}"),
        ),
        Failure::Display => (
            "there is no display to open a window on",
            format!(
                "Start it from a desktop, or on a virtual display: {APT_LINE} xvfb xauth && xvfb-run {}",
                program()
            ),
        ),
        Failure::Driver => (
            "no graphics driver works for a window",
            format!("Install one: {APT_LINE}"),
        ),
    };
    let program = program();
    format!(
        "{what} ({error})\n{todo}\nWithout a window, this draws the built-in materials: {program} {FIGURE}\nWhat else works without one: {program} --help"
    )
}

/// The program as it was called, so that a line with it can be run as it stands.
fn program() -> String {
    let called = env::args().next().unwrap_or_default();
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    if called.contains('/') && called.chars().all(plain) {
        called
    } else {
        "grazing".into()
    }
}

/// Says something on standard error.
pub(super) fn say(text: &str) {
    // eprintln! would panic where standard error is closed.
    let _ = writeln!(io::stderr(), "grazing: {text}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use winit::error::EventLoopError;

    #[test]
    fn each_failure_says_what_to_do() {
        for (failure, error, what) in [
            (
                Failure::Display,
                "winit EventLoopError: os error at /home/a/winit/linux/mod.rs:765: neither WAYLAND_DISPLAY nor DISPLAY is set.",
                "no display to open a window on (neither",
            ),
            (
                Failure::Library,
                "os error at /a/mod.rs:788: Failed to load one of xlib's shared libraries",
                "library that the window needs is missing (Failed",
            ),
            (
                Failure::Driver,
                "WGPU error: Failed to create surface for any enabled backend",
                "no graphics driver",
            ),
        ] {
            let text = explain(failure, error);
            assert!(
                text.lines().next().is_some_and(|line| line.contains(what)),
                "{text}"
            );
            assert!(text.contains(APT_LINE) && text.contains(FIGURE), "{text}");
        }
    }

    #[test]
    fn an_event_loop_that_cannot_be_made_lacks_a_display_and_no_driver() {
        let error = eframe::Error::WinitEventLoop(EventLoopError::RecreationAttempt);
        assert_eq!(Failure::of(&error), Failure::Display);
        let error = eframe::Error::AppCreation("no renderer".into());
        assert_eq!(Failure::of(&error), Failure::Driver);
    }
}
