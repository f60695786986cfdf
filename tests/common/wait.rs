//! Waiting for what comes in its own time.

use std::thread;
use std::time::{Duration, Instant};

/// The limit is for a broken program, not a measure.
const LIMIT: Duration = Duration::from_secs(120);

/// Looks again and again until something is found; the reason why it is not yet is told when the limit is over.
#[track_caller]
pub fn settle<T>(mut look: impl FnMut() -> Result<T, String>) -> T {
    let start = Instant::now();
    loop {
        match look() {
            Ok(found) => return found,
            Err(reason) => assert!(start.elapsed() < LIMIT, "{reason}"),
        }
        thread::sleep(Duration::from_millis(2));
    }
}
