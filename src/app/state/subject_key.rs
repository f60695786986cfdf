//! Names of what the plots show.

use crate::app::state::material::MaterialId;
use crate::fit::Variant;

/// Which values of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// The data.
    Measured,
    /// The model over them.
    Model,
    /// A kept fit.
    Fit(Variant),
}

/// Names a subject as long as its material is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SubjectKey {
    /// Of which material.
    pub material: MaterialId,
    /// What of it.
    pub what: What,
}
