//! Variables of the search: the parameters of a lobe and η, each on a scale on which a step means about the same anywhere.

use crate::brdf::params::{MOST_LOBE_PARAMS, SMALLEST_ETA, Scale};
use crate::brdf::{Param, ParamId};

/// Largest number of variables of a search: one per parameter of the lobe, and η.
pub const VARIABLES: usize = MOST_LOBE_PARAMS + 1;

/// Index of the variable of η.
pub const ETA_VARIABLE: usize = MOST_LOBE_PARAMS;

/// Point of the search: the lobe's parameters in their order, logarithms where their scale is logarithmic, 0 beyond them; last ln(η − 1).
pub type SearchPoint = [f64; VARIABLES];

/// Variable of a parameter's value.
pub fn variable(row: &Param, value: f64) -> f64 {
    match (row.id, row.scale) {
        (ParamId::ETA, _) => (value.max(SMALLEST_ETA) - 1.0).ln(),
        (_, Scale::Log { .. }) => value.ln(),
        (_, Scale::Linear) => value,
    }
}

/// Value of a parameter from its variable.
pub fn value(row: &Param, variable: f64) -> f64 {
    match (row.id, row.scale) {
        (ParamId::ETA, _) => 1.0 + variable.exp(),
        (_, Scale::Log { .. }) => variable.exp(),
        (_, Scale::Linear) => variable,
    }
}
