//! The real window on a virtual display, for what only it can show: a graphics device that is lost, a window larger than the
//! adapter can draw, and a monkey that clicks, drags, types and turns the wheel. And every command that writes, killed at
//! random times.
//!
//! `cargo test --test soak` takes seconds. By hand, for minutes:
//! `cargo test --test soak -- --minutes 10 --kills 100 --seed 7`. A monkey
//! with the same seed makes the same gestures; how the window is timed is not the same. It reports what the process
//! holds as it goes on (MiB in memory, open files, threads), and fails where it ends, panics or says something on standard
//! error.

#[path = "../common"]
mod common {
    pub mod display;
    pub mod folder;
    pub mod merl;
    pub mod real_window;
    pub mod tables;
    pub mod wait;
}

mod device;
mod kills;
mod monkey;
mod process;

fn main() {
    if std::env::var(device::WINDOW).is_ok() {
        return device::window();
    }
    let args: Vec<String> = std::env::args().skip(1).collect();
    let Some(options) = Options::read(&args) else {
        return;
    };
    if std::env::var("SKIP_GPU").is_ok_and(|value| value == "1") {
        println!("soak: skipped, as SKIP_GPU=1");
        return;
    }
    if options.minutes.is_none() {
        device::a_window_whose_device_is_lost_opens_again_with_what_was_open();
        device::a_window_larger_than_the_adapter_draws_goes_on();
    }
    kills::run(options.kills, options.seed);
    monkey::run(options.minutes.unwrap_or(0.1), options.seed);
}

/// Options of the command line.
struct Options {
    /// Length of the monkey's play; the short tests where it is not given.
    minutes: Option<f64>,
    /// Kills of each command.
    kills: usize,
    /// Seed of the monkey and of the times of the kills.
    seed: u64,
}

impl Options {
    /// `None` where the command line asks for other tests by name, or for a list.
    fn read(args: &[String]) -> Option<Self> {
        let value = |name: &str| {
            let at = args.iter().position(|arg| arg == name)?;
            Some(
                args.get(at + 1)
                    .unwrap_or_else(|| panic!("{name} has no value")),
            )
        };
        let minutes = value("--minutes").map(|text| text.parse().expect("minutes"));
        let kills = value("--kills").map_or(2, |text| text.parse().expect("a number"));
        let seed = value("--seed").map_or(1, |text| text.parse().expect("a seed"));
        let asked = ["--minutes", "--kills", "--seed"]
            .iter()
            .any(|name| value(name).is_some());
        // A filter of `cargo test NAME` goes to every test program.
        let named = args
            .iter()
            .any(|arg| !arg.starts_with('-') || arg == "--list");
        (asked || !named || args.iter().any(|arg| "soak".contains(arg.as_str()))).then_some(Self {
            minutes,
            kills,
            seed,
        })
    }
}
