//! What the jobs of views share: data that are told apart by where they are, and threads that leave a core to the window.

use crate::measured::Table;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::fmt;
use std::sync::{Arc, LazyLock};
use std::thread;

/// A table that is equal to another only where both are the same one in memory.
#[derive(Clone)]
pub struct Data(pub Arc<Table>);

impl PartialEq for Data {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for Data {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Data({} valid)", self.0.valid_count())
    }
}

/// Does what is spread over threads with one core less than there are. Apart from the fits', or it would wait for them.
pub fn in_background<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    static POOL: LazyLock<Option<ThreadPool>> = LazyLock::new(|| {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        ThreadPoolBuilder::new()
            .num_threads((cores - 1).max(1))
            .thread_name(|k| format!("view {k}"))
            .build()
            .ok()
    });
    match POOL.as_ref() {
        Some(pool) => pool.install(work),
        None => work(),
    }
}
