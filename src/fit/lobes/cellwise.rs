//! Kernel of any lobe: evaluated cell by cell in f64, its slopes by differences. Right for every model and slow.

use super::differences::{log_slope, moved};
use super::fresnel_rows::FresnelRows;
use super::{LobeKernel, LobeShape, RowSlopes, cosines_at};
use crate::brdf::{LobeValues, Model};
use crate::fit::symmetric_cells::{CellRow, SymmetricCells};
use crate::fit::variables::ETA_VARIABLE;

/// A lobe of which nothing is known but its function.
pub struct Cellwise {
    model: &'static Model,
    lobe: LobeValues,
    fresnel: FresnelRows,
}

/// Index of each variable of a lobe.
const VARIABLES_OF_LOBE: [usize; ETA_VARIABLE] = [0, 1, 2, 3];

impl Cellwise {
    /// Kernel of a shape.
    pub fn new(shape: &LobeShape) -> Self {
        Self {
            model: shape.model,
            lobe: shape.lobe,
            fresnel: FresnelRows::new(shape),
        }
    }
}

/// Cells of rows, as rows with cos² φd.
fn cells_of<'a>(
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
) -> impl Iterator<Item = (&'a CellRow, f64)> {
    rows.iter().flat_map(|row| {
        let along = cells.cos2_of(row).iter();
        along.map(move |cos2| (row, f64::from(*cos2)))
    })
}

impl LobeKernel for Cellwise {
    fn shapes(&self, cells: &SymmetricCells, rows: &[CellRow], shapes: &mut [f32]) {
        for (shape, (row, cos2)) in shapes.iter_mut().zip(cells_of(cells, rows)) {
            let fresnel = self.fresnel.value[row.theta_d];
            *shape = (fresnel * (self.model.lobe)(&self.lobe, &cosines_at(row, cos2))) as f32;
        }
    }

    fn slopes(
        &self,
        cells: &SymmetricCells,
        rows: &[CellRow],
        shapes: &mut [f32],
        slopes: &mut RowSlopes,
    ) {
        self.shapes(cells, rows, shapes);
        for (constant, row) in slopes.constant.iter_mut().zip(rows) {
            constant[ETA_VARIABLE] = self.fresnel.slope[row.theta_d];
        }
        for k in 0..self.model.params.len() {
            let moved = moved(self.model, &self.lobe, k);
            for (slope, (row, cos2)) in slopes.varying[k].iter_mut().zip(cells_of(cells, rows)) {
                let cosines = cosines_at(row, cos2);
                let change = log_slope(moved.map(|lobe| (self.model.lobe)(&lobe, &cosines)));
                *slope = if change.is_finite() {
                    change as f32
                } else {
                    0.0
                };
            }
        }
    }

    fn varying(&self) -> &[usize] {
        &VARIABLES_OF_LOBE[..self.model.params.len()]
    }
}
