//! A virtual X11 display, and processes that end with what started them.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};

/// A process that is ended when this is dropped, by a panic too.
pub struct Running(pub Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A display of Xvfb with a number of its own. It lives as long as this, whatever windows come and go.
pub struct Display {
    _server: Running,
    /// Name for the variable DISPLAY.
    pub name: String,
}

impl Display {
    /// Starts a server with a screen of this size in pixels.
    pub fn of_size(size: [u32; 2]) -> Self {
        let [width, height] = size;
        let mut server = Command::new("Xvfb");
        // Without -noreset the server begins anew when its last window closes, and the next one may not open.
        server.args(["-displayfd", "1", "-noreset", "-nolisten", "tcp"]);
        server.args(["-screen", "0", &format!("{width}x{height}x24")]);
        let server = server.stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
        let server = server.unwrap_or_else(|error| panic!("Xvfb: {error}; tests/run installs it"));
        let mut server = Running(server);
        let mut number = String::new();
        let out = server.0.stdout.take().expect("piped");
        BufReader::new(out)
            .read_line(&mut number)
            .expect("the server says its number");
        assert!(!number.trim().is_empty(), "Xvfb does not start");
        Self {
            _server: server,
            name: format!(":{}", number.trim()),
        }
    }

    /// A program that opens its windows here and on no other display.
    pub fn command(&self, program: impl AsRef<std::ffi::OsStr>) -> Command {
        let mut command = Command::new(program);
        command
            .env("DISPLAY", &self.name)
            .env("NODEVICE_SELECT", "1");
        for other in ["WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            command.env_remove(other);
        }
        command
    }
}
