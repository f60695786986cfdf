//! Choice of X11 where Wayland is named but does not answer.
//!
//! winit takes Wayland wherever the environment names it, and its event loop can be made once in a process: when it has
//! failed, X11 is no longer to be had. So a display of that name is asked first. ssh, tmux and WSL hand names on that
//! are of no use any more.

use crate::app::jobs::within;
use crate::quote::shown;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{env, fs};
use wayland_client::Connection;

/// Longest time that a compositor may take to answer. A live one needs a millisecond.
const PATIENCE: Duration = Duration::from_secs(2);

/// Names of displays in the environment, those that are empty left out.
struct Names {
    wayland_socket: Option<String>,
    wayland_display: Option<String>,
    runtime_dir: Option<PathBuf>,
    x11_display: Option<String>,
}

/// X11 instead of Wayland, with a line that says what was tried; `None` where winit chooses well by itself.
///
/// # Errors
/// What was tried, where Wayland does not answer and no X11 display is named.
pub(super) fn choose() -> Result<Option<String>, String> {
    let named = |name: &str| env::var(name).ok().filter(|value| !value.is_empty());
    choose_among(&Names {
        wayland_socket: named("WAYLAND_SOCKET"),
        wayland_display: named("WAYLAND_DISPLAY"),
        runtime_dir: named("XDG_RUNTIME_DIR").map(PathBuf::from),
        x11_display: named("DISPLAY"),
    })
}

fn choose_among(names: &Names) -> Result<Option<String>, String> {
    let Err(failed) = ask_wayland(names) else {
        return Ok(None);
    };
    match &names.x11_display {
        Some(display) => Ok(Some(format!(
            "no Wayland display answers ({failed}); trying X11 (DISPLAY={})",
            shown(display)
        ))),
        None => Err(format!("{failed}; DISPLAY is not set")),
    }
}

/// Whether a named Wayland display answers; that none is named is no error.
fn ask_wayland(names: &Names) -> Result<(), String> {
    if let Some(number) = &names.wayland_socket {
        // It can be used once only, so it is not asked.
        let is_socket = number.parse::<u32>().is_ok_and(|number| {
            let target = fs::read_link(format!("/proc/self/fd/{number}"));
            target.is_ok_and(|target| target.to_string_lossy().starts_with("socket:"))
        });
        let failed = || format!("WAYLAND_SOCKET={}: no open socket", shown(number));
        return is_socket.then_some(()).ok_or_else(failed);
    }
    let Some(name) = &names.wayland_display else {
        return Ok(());
    };
    let failed = |why: &str| format!("WAYLAND_DISPLAY={}: {why}", shown(name));
    let folder = names.runtime_dir.as_deref().filter(|dir| dir.is_absolute());
    let path = match (Path::new(name), folder) {
        (path, _) if path.is_absolute() => path.to_owned(),
        (path, Some(folder)) => folder.join(path),
        (_, None) => return Err(failed("XDG_RUNTIME_DIR is not set")),
    };
    match within(PATIENCE, move || round_trip(&path)) {
        Some(answer) => answer.map_err(|error| failed(&error)),
        None => Err(failed("it does not answer")),
    }
}

/// Connects and waits for an answer.
fn round_trip(path: &Path) -> Result<(), String> {
    let stream = UnixStream::connect(path).map_err(|error| error.to_string())?;
    let connection = Connection::from_socket(stream).map_err(|error| error.to_string())?;
    let answer = connection.roundtrip().map_err(|error| error.to_string());
    answer.map(|_| ())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read as _, Write as _};
    use std::os::unix::net::UnixListener;
    use std::thread;

    fn names(folder: &Path, wayland: &str, x11: Option<&str>) -> Names {
        Names {
            wayland_socket: None,
            wayland_display: Some(wayland.into()),
            runtime_dir: Some(folder.to_owned()),
            x11_display: x11.map(str::to_owned),
        }
    }

    #[test]
    fn a_name_without_a_compositor_leads_to_x11_if_there_is_one() {
        let folder = tempfile::tempdir().expect("a folder");
        let stale = names(folder.path(), "wayland-9", Some(":7"));
        let said = choose_among(&stale).expect("X11").expect("a reason");
        assert!(said.contains("WAYLAND_DISPLAY=wayland-9"), "{said}");
        assert!(said.contains("DISPLAY=:7"), "{said}");
        let neither = names(folder.path(), "wayland-9", None);
        let said = choose_among(&neither).expect_err("no display");
        assert!(said.ends_with("DISPLAY is not set"), "{said}");
        // A socket whose owner is gone.
        drop(UnixListener::bind(folder.path().join("left")).expect("a socket"));
        assert!(choose_among(&names(folder.path(), "left", None)).is_err());
        let socket = Names {
            wayland_socket: Some("999999".into()),
            ..names(folder.path(), "wayland-9", Some(":7"))
        };
        assert!(matches!(choose_among(&socket), Ok(Some(said)) if said.contains("WAYLAND_SOCKET")));
    }

    #[test]
    fn a_compositor_that_is_silent_leads_to_x11() {
        let folder = tempfile::tempdir().expect("a folder");
        let _silent = UnixListener::bind(folder.path().join("silent")).expect("a socket");
        let said = choose_among(&names(folder.path(), "silent", Some(":7")));
        assert!(matches!(said, Ok(Some(said)) if said.contains("does not answer")));
    }

    #[test]
    fn a_compositor_that_answers_is_left_to_winit() {
        let folder = tempfile::tempdir().expect("a folder");
        let listener = UnixListener::bind(folder.path().join("alive")).expect("a socket");
        thread::spawn(move || {
            let (mut client, _) = listener.accept().expect("a client");
            // wl_display.sync of an object: its number, opcode and size, then the number of the callback.
            let mut sync = [0; 12];
            client.read_exact(&mut sync).expect("a request");
            let word = |bytes: [u8; 4]| u32::from_ne_bytes(bytes);
            let callback = [sync[8], sync[9], sync[10], sync[11]];
            // wl_callback.done of that callback, with a serial number; wl_display.delete_id of it.
            let events = [
                word(callback),
                12 << 16,
                1,
                1,
                (12 << 16) | 1,
                word(callback),
            ];
            let bytes: Vec<u8> = events.iter().flat_map(|word| word.to_ne_bytes()).collect();
            client.write_all(&bytes).expect("an answer");
            // Open until the client has gone.
            let _ = client.read(&mut sync);
        });
        assert_eq!(choose_among(&names(folder.path(), "alive", None)), Ok(None));
        let unnamed = Names {
            wayland_display: None,
            ..names(folder.path(), "", None)
        };
        assert_eq!(choose_among(&unnamed), Ok(None));
    }
}
