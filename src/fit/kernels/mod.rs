//! SIMD passes over all symmetric cells: the lobe, the error with its gradient, the sums of the regression.
//!
//! Sums are in f32 over a few rows, in f64 beyond; the parts are those of the θh slabs and are added in their order,
//! so that the number of threads changes nothing.

mod error;
mod error_parts;
mod lobe_values;
mod regression_sums;
mod rows;

pub use error::{error, slopes};
pub use error_parts::parts;
pub use lobe_values::{fill, shapes};
pub use regression_sums::{ChannelSums, regression};
pub use rows::{block_of, per_block};
