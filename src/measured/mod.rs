//! Measured BRDFs on the half/difference grid: the table, its lookup, the MERL layout, synthetic samples. Pure.
//!
//! A cell is *invalid* if any channel is negative or not finite. An invalid cell has no value; it is never shown as 0.

pub mod albedo;
pub mod grid;
pub mod lookup;
pub mod merl;
mod overview;
pub mod samples;
pub mod stats;
pub mod table;
mod tabulate;

pub use grid::Grid;
pub use lookup::Lookup;
pub use samples::{SAMPLES, SyntheticMaterial};
pub use stats::ChannelStats;
pub use table::Table;
pub use tabulate::tabulate;
