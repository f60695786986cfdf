//! Whether a pass over the data uses one thread or all.

/// Whether a pass is spread over the threads of the pool, or stays on the one it is called from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// For many cells.
    Many,
    /// The calling one, for small samples that are worked on side by side.
    One,
}
