//! Materials in the plane of two quantities of a model's fits, one dot each.

mod panel;
mod plot;
mod quantity;
mod spec;

pub use plot::{ScatterDot, ScatterPlot};
pub use quantity::{Quantity, QuantityRow};
pub use spec::ScatterSpec;
