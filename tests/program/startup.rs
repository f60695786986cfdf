//! The program where a display is missing, or named and gone: plain words, exit code 1, and what works all the same.
#![cfg(target_os = "linux")]

use crate::common::folder::Folder;
use crate::common::program::{grazing, stderr, stdout, succeeded};
use crate::common::wait::settle;
use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

/// The program where no display is named.
fn without_display() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grazing"));
    for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(name);
    }
    command
}

#[track_caller]
fn no_display(output: &Output) -> String {
    let said = stderr(output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.starts_with("grazing: there is no display"), "{said}");
    assert!(said.contains("apt-get install"), "{said}");
    assert!(
        !said.contains("panicked") && !said.contains(".rs:"),
        "{said}"
    );
    said
}

#[test]
fn without_a_display_it_says_what_to_do() {
    no_display(&without_display().output().expect("it runs"));
    // Names that lead nowhere are no displays either.
    let stale = Folder::new();
    let mut command = without_display();
    command.env("WAYLAND_DISPLAY", "wayland-9");
    command.env("XDG_RUNTIME_DIR", stale.root());
    let said = no_display(&command.output().expect("it runs"));
    assert!(said.contains("WAYLAND_DISPLAY=wayland-9"), "{said}");
    let mut command = without_display();
    command.env("DISPLAY", ":4711");
    no_display(&command.output().expect("it runs"));
}

#[test]
fn the_line_that_is_proposed_without_a_display_draws_a_figure() {
    let output = without_display().output().expect("it runs");
    let said = no_display(&output);
    let (_, line) = said
        .split_once("draws the built-in materials: ")
        .expect("a line");
    let line = line.lines().next().expect("a line");
    let folder = Folder::new();
    let mut shell = Command::new("sh");
    shell.args(["-c", line]).current_dir(folder.root());
    shell.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    succeeded(&shell.output().expect("a shell"));
    let figure = line.rsplit(' ').next().expect("a name");
    let bytes = std::fs::read(folder.path(figure)).expect("a figure");
    assert!(bytes.starts_with(b"%PDF") && bytes.len() > 10_000, "{line}");
}

#[test]
fn version_and_help_need_no_display() {
    for (option, expected) in [
        ("--version", env!("CARGO_PKG_VERSION")),
        ("--help", "grazing [OPTIONS] [FILE]..."),
    ] {
        let output = without_display().arg(option).output().expect("it runs");
        assert!(succeeded(&output).contains(expected), "{}", stdout(&output));
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_adapter_is_told_without_a_display() {
    let output = without_display()
        .arg("--adapter")
        .output()
        .expect("it runs");
    let said = succeeded(&output);
    let heads: Vec<_> = said.lines().map(|line| line.split("  ").next()).collect();
    let expected = ["adapter", "driver", "backend", "type"];
    assert_eq!(heads[..1], [Some("adapter")], "{said}");
    assert!(
        said.lines()
            .zip(expected)
            .all(|(line, head)| line.starts_with(head)),
        "{said}"
    );
    assert_eq!(heads.len(), expected.len(), "{said}");
    // One that is not there is asked for: one line says so.
    let mut wanted = without_display();
    let wanted = wanted
        .arg("--adapter")
        .env("WGPU_ADAPTER_NAME", "no such adapter");
    let output = wanted.output().expect("it runs");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(stderr(&output).lines().count(), 1, "{}", stderr(&output));
    // So does an interface that there is not; no driver is missing.
    for option in [Some("--adapter"), None] {
        let mut wanted = without_display();
        wanted.args(option).env("WGPU_BACKEND", "foo");
        let output = wanted.output().expect("it runs");
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("WGPU_BACKEND names \"foo\""), "{said}");
        assert!(said.contains("vulkan, gl, metal or dx12"), "{said}");
        assert!(
            !said.contains("driver") && said.lines().count() == 1,
            "{said}"
        );
    }
    // It is a question of its own.
    assert_eq!(grazing(&[&"--adapter", &"a.binary"]).status.code(), Some(2));
}

/// A process that ends with the test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A virtual X11 display and its name.
fn virtual_display() -> (Running, String) {
    let mut server = Command::new("Xvfb");
    server.args(["-displayfd", "1", "-screen", "0", "1280x800x24"]);
    server.args(["-noreset", "-nolisten", "tcp"]);
    let server = server.stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
    let mut server = server.unwrap_or_else(|error| panic!("Xvfb: {error}; tests/run installs it"));
    let mut number = String::new();
    let out = server.stdout.take().expect("piped");
    BufReader::new(out)
        .read_line(&mut number)
        .expect("a number");
    (Running(server), format!(":{}", number.trim()))
}

/// Names of the windows on a display.
fn windows(display: &str) -> String {
    let mut search = Command::new("xdotool");
    let search = search.args(["search", "--name", "Grazing"]);
    let output = search.env("DISPLAY", display).output();
    stdout(&output.expect("xdotool; tests/run installs it"))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_wayland_display_that_is_gone_leads_to_x11() {
    let (_server, display) = virtual_display();
    let home = Folder::new();
    let mut command = without_display();
    command
        .env("DISPLAY", &display)
        .env("WAYLAND_DISPLAY", "wayland-9");
    for name in ["XDG_RUNTIME_DIR", "XDG_DATA_HOME"] {
        command.env(name, home.root());
    }
    command.env("NODEVICE_SELECT", "1").stderr(Stdio::piped());
    let mut program = Running(command.spawn().expect("it runs"));
    let mut said = String::new();
    let err = program.0.stderr.take().expect("piped");
    BufReader::new(err).read_line(&mut said).expect("a line");
    let tried = format!("DISPLAY={display}");
    assert!(said.contains("WAYLAND_DISPLAY=wayland-9"), "{said}");
    assert!(
        said.trim().ends_with(&format!("trying X11 ({tried})")),
        "{said}"
    );
    settle(|| match windows(&display).lines().count() {
        0 => Err(format!("no window; {:?}", program.0.try_wait())),
        _ => Ok(()),
    });
    assert!(Path::new("/proc").join(program.0.id().to_string()).exists());
}
