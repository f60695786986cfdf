//! The disc: f_r over all view directions under one light, seen from above.
//!
//! ```text
//! DiscSpec + data and model ── field ──▶ DiscField ── DiscPlot::new ──▶ Drawing and DiscFrame
//! ```
//!
//! φ = 0 is to the right and grows counter-clockwise. The light is at φi = 180° at first, so that the plane of incidence is
//! level and the mirror direction on the right, as in the polar lobes.

mod draw;
mod field;
mod frame;
mod panel;
mod projection;
mod spec;

pub use field::DiscField;
pub use frame::DiscFrame;
pub use projection::{DiscProjection, PROJECTIONS};
pub use spec::DiscSpec;

use super::drawing::Drawing;

/// A disc: the picture, and where directions are in it.
#[derive(Clone, Debug)]
pub struct DiscPlot {
    /// The picture without the marks of light and probe ([`DiscPlot::marks`]), which move while it stays.
    pub drawing: Drawing,
    /// The disc in it.
    pub frame: DiscFrame,
}

impl DiscPlot {
    /// A disc of the material `name` in `size` points.
    pub fn new(spec: &DiscSpec, name: &str, field: &DiscField, size: [f32; 2]) -> Self {
        draw::draw(spec, name, field, size)
    }

    /// The marks of light, mirror direction and probe.
    pub fn marks(&self, spec: &DiscSpec) -> Drawing {
        draw::marks(spec, &self.frame, self.drawing.size)
    }
}

#[cfg(test)]
mod tests;
