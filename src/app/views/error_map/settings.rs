//! What the error map is set to show, and the job behind it.

use crate::app::state::cache::{Query, Update, WhenNewer};
use crate::app::state::shared_table::SharedTable;
use crate::brdf::Brdf;
use crate::figure::error_map::Plane;
use crate::figure::heatmap::View;
use crate::figure::scale::RadialScale;
use crate::fit::error_map::{ErrorMap, error_map};
use crate::fit::{ProblemError, Weight};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;

/// What the tile of the error map is set to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ErrorMapView {
    /// Which axes.
    pub plane: Plane,
    /// How shares become colours.
    pub scale: RadialScale,
    /// The part in sight.
    pub view: View,
}

impl Default for ErrorMapView {
    fn default() -> Self {
        Self {
            plane: Plane::Directions,
            scale: RadialScale::CubeRoot,
            view: View::default(),
        }
    }
}

/// The error of a model over a material, taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMapQuery {
    /// The material.
    pub data: SharedTable,
    /// How much a cell counts.
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
