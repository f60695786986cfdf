//! Kernel of any lobe: evaluated cell by cell in f64, its slopes by differences. Right for every model and slow.

use super::differences::{log_slope, moved};
use super::fresnel_rows::FresnelRows;
use super::{LobeKernel, LobeShape, RowSlopes, cosines_at};
use crate::brdf::{LobeValues, Model};
use crate::fit::symmetric_cells::CellRow;
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

impl LobeKernel for Cellwise {
    fn shapes(&self, row: &CellRow, cos2: &[f32], shapes: &mut [f32]) {
        let fresnel = self.fresnel.value[row.theta_d];
        for (shape, cos2) in shapes.iter_mut().zip(cos2) {
            let cosines = cosines_at(row, f64::from(*cos2));
            *shape = (fresnel * (self.model.lobe)(&self.lobe, &cosines)) as f32;
        }
    }

    fn slopes(&self, row: &CellRow, cos2: &[f32], shapes: &mut [f32], slopes: &mut RowSlopes) {
        self.shapes(row, cos2, shapes);
        slopes.constant[ETA_VARIABLE] = self.fresnel.slope[row.theta_d];
        for k in 0..self.model.params.len() {
            let moved = moved(self.model, &self.lobe, k);
            for (slope, cos2) in slopes.varying[k].iter_mut().zip(cos2) {
                let cosines = cosines_at(row, f64::from(*cos2));
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
