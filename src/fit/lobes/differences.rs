//! Slopes by central differences in the variables of the search.

use crate::brdf::{LobeValues, Model};
use crate::fit::variables::{value, variable};

/// Step in a variable: slopes are good to 1e-8.
pub const STEP: f64 = 1e-4;

/// Values of a lobe's parameters a step below and above in the variable of the k-th.
pub fn moved(model: &Model, lobe: &LobeValues, k: usize) -> [LobeValues; 2] {
    let row = &model.params[k];
    [-STEP, STEP].map(|step| {
        let mut moved = *lobe;
        moved[k] = value(row, variable(row, lobe[k]) + step);
        moved
    })
}

/// ∂ ln f / ∂ variable from f a step below and above; not finite where f is 0.
pub fn log_slope([low, high]: [f64; 2]) -> f64 {
    (high / low).ln() / (2.0 * STEP)
}
