//! The program ended from outside: nothing half-written, no litter, and what was open comes back.
#![cfg(target_os = "linux")]

use crate::common::display::{Display, Running};
use crate::common::folder::{Folder, left_in};
use crate::common::merl::merl_file;
use crate::common::real_window::{grazing_on, until_window_of};
use crate::common::wait::settle;
use std::fs;
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

fn kill(process: &mut Running, signal: &str) -> ExitStatus {
    let id = process.0.id().to_string();
    let sent = Command::new("kill")
        .args([&format!("-{signal}"), &id])
        .status();
    assert!(sent.expect("kill").success());
    process.0.wait().expect("it ends")
}

/// Waits until a process has written a part of a file in a folder, named or not; whether it came to that.
fn until_it_writes(process: &mut Running, folder: &Path) -> bool {
    let open = PathBuf::from(format!("/proc/{}/fd", process.0.id()));
    let writes = |file: PathBuf| {
        let inside = fs::read_link(&file).is_ok_and(|target| target.starts_with(folder));
        inside && fs::metadata(&file).is_ok_and(|data| data.len() > 0)
    };
    settle(|| {
        let files = fs::read_dir(&open).into_iter().flatten().flatten();
        if files.map(|file| file.path()).any(writes) {
            return Ok(true);
        }
        let ended = process.0.try_wait().is_ok_and(|ended| ended.is_some());
        ended
            .then_some(false)
            .ok_or_else(|| "it writes nothing".into())
    })
}

#[test]
fn a_command_that_is_killed_while_it_writes_leaves_the_old_file_and_no_litter() {
    let folder = Folder::new();
    let model = folder.file(
        "model.json",
        r#"{"model": "phong", "rho_d": [0.5, 0.4, 0.3], "k_s": [1, 2, 3], "s": 20}"#,
    );
    // Files of many megabytes, so that the write lasts.
    let out = folder.path("out");
    fs::create_dir(&out).expect("made");
    let commands: [(&str, &[&str]); 2] = [("export", &[]), ("render", &["--size", "600"])];
    for (name, options) in commands {
        let target = out.join(match name {
            "export" => "out.binary",
            _ => "out.exr",
        });
        let command = || {
            let mut command = Command::new(env!("CARGO_BIN_EXE_grazing"));
            command.arg(name).arg(&model).args(options);
            command.arg("--force").arg("-o").arg(&target);
            command
        };
        assert!(command().status().expect("it runs").success());
        let whole = fs::read(&target).expect("is there");
        let mut killed_within = 0;
        // A kill may come too late, but not every time.
        for attempt in 0..60 {
            fs::write(&target, "the old one").expect("is written");
            let signal = ["KILL", "TERM", "INT"][attempt % 3];
            let mut process = Running(command().spawn().expect("it runs"));
            if until_it_writes(&mut process, &out) {
                kill(&mut process, signal);
            }
            let left = fs::read(&target).expect("is there");
            let is_old = left == b"the old one";
            assert!(is_old || left == whole, "{name}: {} bytes", left.len());
            assert_eq!(left_in(&out), [target.as_path()], "{name}, {signal}");
            killed_within += usize::from(is_old);
            if killed_within == 3 {
                break;
            }
        }
        assert_eq!(killed_within, 3, "kills within the write of {name}");
        fs::remove_file(target).expect("is removed");
    }
}

/// What a window keeps for the next start.
fn kept(home: &Folder) -> Vec<PathBuf> {
    left_in(&home.path("grazing/autosave"))
}

/// The file of these that ends so.
fn ending<'p>(kept: &'p [PathBuf], end: &str) -> Option<&'p PathBuf> {
    let has_end = |path: &&PathBuf| path.extension().is_some_and(|extension| extension == end);
    kept.iter().find(has_end)
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_window_that_the_system_ends_keeps_what_is_open() {
    let display = Display::of_size([1280, 800]);
    let home = Folder::new();
    let file = home.file("tin.binary", merl_file(|_| Some([0.2, 0.3, 0.4])));
    let mut first = grazing_on(&display, home.root());
    let mut first = Running(first.arg(&file).spawn().expect("it runs"));
    until_window_of(&display, &mut first);
    let before = settle(|| match kept(&home) {
        kept if ending(&kept, "json").is_some() => Ok(kept),
        kept => Err(format!("{kept:?}")),
    });
    let ended = kill(&mut first, "TERM");
    assert!(ended.success() || ended.signal().is_some(), "{ended}");
    assert_eq!(kept(&home), before, "what was open stays");
    let lock = ending(&before, "lock").expect("a lock");
    assert_eq!(
        fs::read_to_string(lock).expect("is there"),
        "ended by the system\n"
    );
    // The next start opens it again, keeps it as its own, and lets the old one go.
    let mut second = Running(grazing_on(&display, home.root()).spawn().expect("it runs"));
    until_window_of(&display, &mut second);
    let after = settle(|| match kept(&home) {
        kept if kept.len() == 2 && kept != before => Ok(kept),
        kept => Err(format!("{kept:?}")),
    });
    let session = ending(&after, "json").expect("a session");
    let text = fs::read_to_string(session).expect("is there");
    assert!(text.contains("tin.binary"), "{text}");
}
