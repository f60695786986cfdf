//! The program, and what it said.

use std::path::Path;
use std::process::{Command, Output};

pub fn grazing(args: &[&dyn AsRef<std::ffi::OsStr>]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grazing"));
    for arg in args {
        command.arg(arg);
    }
    command.output().expect("the program starts")
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("UTF-8")
}

#[track_caller]
pub fn succeeded(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(0), "{}", stderr(output));
    assert_eq!(stderr(output), "");
    stdout(output)
}

/// Exit code 1, nothing on standard output, one line on standard error with the path last.
#[track_caller]
pub fn failed(output: &Output, path: &Path, said: &str) {
    failed_with(output, 1, path, said);
}

/// What [`failed`] says, with another exit code.
#[track_caller]
pub fn failed_with(output: &Output, code: i32, path: &Path, said: &str) {
    let line = stderr(output);
    assert_eq!(output.status.code(), Some(code), "{line}");
    assert_eq!(stdout(output), "");
    assert_eq!(line.lines().count(), 1, "{line}");
    assert!(line.starts_with("grazing: "), "{line}");
    assert!(line.contains(said), "{line}");
    assert!(line.ends_with(&format!(": {}\n", path.display())), "{line}");
    assert!(!line.contains("panicked"), "{line}");
}
