//! Computation of the view in the background.

use crate::app::state::cache::{Query, Update, WhenNewer};
use crate::app::state::shared_table::SharedTable;
use crate::brdf::Brdf;
use crate::fit::error_map::{ErrorMap, error_map};
use crate::fit::{ProblemError, Weight};
use std::ops::ControlFlow;

/// The error of a model over a material, taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMapQuery {
    /// The material.
    pub data: SharedTable,
    /// Weight of the cells in E.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// The model.
    pub brdf: Brdf,
}

impl Query for ErrorMapQuery {
    type Output = Result<ErrorMap, ProblemError>;
    const DOING: &'static str = "taking the error apart";
    const WHEN_NEWER: WhenNewer = WhenNewer::FinishFirst;

    fn run(
        &self,
        _report: &mut dyn FnMut(Update<Self::Output>) -> ControlFlow<()>,
    ) -> Option<Self::Output> {
        Some(error_map(&self.data.0, self.weight, self.limit, &self.brdf))
    }
}
