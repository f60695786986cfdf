//! A window's process seen from outside.

use crate::common::display::{Display, Running};
use std::fs;
use std::io::{BufRead as _, BufReader};
use std::process::{Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;

/// A process with what it says on standard error.
pub struct Watched {
    pub process: Running,
    said: Receiver<String>,
}

impl Watched {
    pub fn start(command: &mut Command) -> Self {
        command.stderr(Stdio::piped()).stdout(Stdio::null());
        let mut process = Running(command.spawn().expect("it runs"));
        let err = process.0.stderr.take().expect("piped");
        let (sender, said) = channel();
        thread::spawn(move || {
            for line in BufReader::new(err).lines().map_while(Result::ok) {
                eprintln!("  window: {line}");
                let _ = sender.send(line);
            }
        });
        Self { process, said }
    }

    /// Lines said since the last look.
    pub fn said(&self) -> Vec<String> {
        self.said.try_iter().collect()
    }

    pub fn has_ended(&mut self) -> Option<String> {
        let ended = self.process.0.try_wait().expect("a child");
        ended.map(|status| status.to_string())
    }

    /// MiB in memory, open files, threads.
    pub fn holds(&self) -> [usize; 3] {
        let of = format!("/proc/{}", self.process.0.id());
        let status = fs::read_to_string(format!("{of}/status")).unwrap_or_default();
        let number = |key: &str| {
            let line = status.lines().find_map(|line| line.strip_prefix(key));
            let word = line.and_then(|line| line.split_whitespace().next());
            word.and_then(|word| word.parse::<usize>().ok())
                .unwrap_or(0)
        };
        let files = fs::read_dir(format!("{of}/fd")).map_or(0, Iterator::count);
        [number("VmRSS:") / 1024, files, number("Threads:")]
    }
}

/// Number of colours on the screen: a window without a shaded sphere has less than two thousand.
pub fn colors(display: &Display) -> usize {
    let shot = "import -window root png:- | identify -format %k -";
    let mut shell = display.command("sh");
    let output = shell.args(["-c", shot]).output().expect("a shell");
    let text = String::from_utf8_lossy(&output.stdout);
    text.trim().parse().unwrap_or(0)
}
