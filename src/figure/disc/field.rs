//! The values of a disc, cell by cell.

use super::spec::DiscSpec;
use crate::figure::heatmap::{Cell, ColorScale, HeatField};
use crate::figure::shown::{Shown, ValueRange};
use crate::figure::subject::Source;
use rayon::prelude::*;

/// The values over a disc, and the ends of its colours.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscField {
    /// Cells of a square around the disc, from −1 to 1 both ways; those whose middle is outside the disc are blank.
    pub cells: HeatField,
    /// Ends of the values.
    pub values: ValueRange,
    /// Ends of the values that the colours are made for: of the data where the model is shown.
    pub reference: ValueRange,
}

impl DiscField {
    /// Cells on a side for a picture `pixels` wide: a multiple of 64, so that it stays while a tile is dragged larger, and
    /// at most `most`.
    pub fn side(pixels: f32, most: usize) -> usize {
        (pixels.max(1.0) as usize).next_multiple_of(64).min(most)
    }

    /// The colours of the values in the settings of a disc.
    pub fn colors(&self, spec: &DiscSpec) -> ColorScale {
        let (values, reference) = (&self.values, &self.reference);
        spec.shown
            .colors(spec.scale, spec.limits, values, reference)
    }
}

impl DiscSpec {
    /// The values of `side` × `side` cells.
    pub fn field(
        &self,
        measured: Option<&Source>,
        model: Option<&Source>,
        side: usize,
    ) -> DiscField {
        let cells = self.cells(measured, model, side);
        let values = ValueRange::of(self.shown, cells.values());
        let reference = match (self.shown, measured) {
            (Shown::Model, Some(_)) => {
                let of_data = Self {
                    shown: Shown::Measured,
                    ..self.clone()
                };
                ValueRange::of(self.shown, of_data.cells(measured, None, side).values())
            }
            _ => values,
        };
        DiscField {
            cells,
            values,
            reference,
        }
    }

    fn cells(&self, measured: Option<&Source>, model: Option<&Source>, side: usize) -> HeatField {
        let edge = |k: usize| 2.0 * k as f64 / side as f64 - 1.0;
        let edges: Vec<f64> = (0..=side).map(edge).collect();
        let middle = |k: usize| 0.5 * (edges[k] + edges[k + 1]);
        let cell = |column: usize, row: usize| {
            let Some(wo) = self.projection.direction([middle(column), middle(row)]) else {
                return Cell::Outside;
            };
            let value = self.value(measured, model, wo);
            value.map_or(Cell::Missing, Cell::Value)
        };
        let cells = (0..side * side)
            .into_par_iter()
            .with_min_len(1024)
            .map(|k| cell(k % side, k / side))
            .collect();
        HeatField {
            x: edges.clone(),
            y: edges,
            cells,
        }
    }
}
