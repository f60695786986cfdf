//! The end of the process by a signal: from a terminal, by `kill`, or when the system shuts down.

use crate::files::remove_unfinished;

/// Watches for the signals that ask the process to end. When one comes, `before` runs; then what was written halfway is
/// removed, and the process ends as it would have done.
///
/// A signal that the process was started to ignore (`nohup`, `&` in a script) stays ignored.
#[cfg(unix)]
pub fn watch(before: impl Fn() + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    let ignored = ignored();
    let watched = [SIGHUP, SIGINT, SIGTERM];
    let watched = watched
        .into_iter()
        .filter(|signal| ignored >> (signal - 1) & 1 == 0);
    // Without a watch the process ends all the same.
    let Ok(mut signals) = Signals::new(watched) else {
        return;
    };
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            before();
            remove_unfinished();
            let _ = emulate_default_handler(signal);
            // Where that does not end it.
            std::process::exit(128 + signal);
        }
    };
    let _ = std::thread::Builder::new()
        .name("signals".into())
        .spawn(wait);
}

/// Elsewhere the system offers nothing of the kind.
#[cfg(not(unix))]
pub fn watch(_before: impl Fn() + Send + 'static) {
    let _ = remove_unfinished;
}

/// Signals that the process was started to ignore, the bit k − 1 for signal k; none where the system does not tell.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    line.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
        .unwrap_or(0)
}
