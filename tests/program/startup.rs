//! The program where a display is missing, or named and gone: plain words, exit code 1, and what works all the same.
#![cfg(target_os = "linux")]

use crate::common::display::{Display, Running};
use crate::common::folder::Folder;
use crate::common::program::{grazing, stderr, stdout, succeeded};
use crate::common::real_window::{grazing_on, until_window_of};
use std::io::{BufRead as _, BufReader};
use std::process::{Command, Output, Stdio};

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

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_wayland_display_that_is_gone_leads_to_x11() {
    let display = Display::of_size([1280, 800]);
    let home = Folder::new();
    let mut command = grazing_on(&display, home.root());
    command.env("WAYLAND_DISPLAY", "wayland-9");
    command.stderr(Stdio::piped());
    let mut program = Running(command.spawn().expect("it runs"));
    let mut said = String::new();
    let err = program.0.stderr.take().expect("piped");
    BufReader::new(err).read_line(&mut said).expect("a line");
    let tried = format!("DISPLAY={}", display.name);
    assert!(said.contains("WAYLAND_DISPLAY=wayland-9"), "{said}");
    assert!(
        said.trim().ends_with(&format!("trying X11 ({tried})")),
        "{said}"
    );
    until_window_of(&display, &mut program);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn damaged_settings_stop_no_start() {
    let display = Display::of_size([1280, 800]);
    let home = Folder::new();
    std::fs::create_dir(home.path("grazing")).expect("made");
    let window = "(normal_geometry:(outer_position_pixels:None,scale_factor:1.0,inner_size_points:(x:1280.0,y:800.0)),fullscreen:false,maximized:false)";
    let memory = ron::to_string(&egui::Memory::default()).expect("RON");
    for damage in ["0.0", "NaN", "inf", "-1.0", "100.0", "1e-9"] {
        let memory = memory.replace("zoom_factor:1.0", &format!("zoom_factor:{damage}"));
        let kept = [("window", window), ("egui", &memory)];
        let kept = ron::to_string(&std::collections::BTreeMap::from(kept)).expect("RON");
        let file = home.file("grazing/app.ron", &kept);
        let mut program = Running(grazing_on(&display, home.root()).spawn().expect("it runs"));
        until_window_of(&display, &mut program);
        let beside = file.with_extension("ron.damaged");
        assert_eq!(std::fs::read_to_string(beside).expect("is there"), kept);
    }
}
