//! Threads of a pass over the data.

/// Number of threads that a pass uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// All threads of the pool, for many cells.
    Many,
    /// The calling thread alone, for small samples that are evaluated side by side.
    One,
}
