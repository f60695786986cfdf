//! Names of what the plots show.

use crate::app::state::material::MaterialId;
use crate::fit::Variant;

/// Values of a material: data, model or a fit.
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
    /// Material of the subject.
    pub material: MaterialId,
    /// Values of it.
    pub what: What,
}
