//! What the error map is set to show, and the job behind it.

use super::background::{Data, in_background};
use crate::app::derived::{Derived, Slot, Step, Wish};
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
pub struct ErrorWish {
    /// The material.
    pub data: Data,
    /// How much a cell counts.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// The model.
    pub brdf: Brdf,
}

impl Wish for ErrorWish {
    type Made = Result<ErrorMap, ProblemError>;
    const ENDS_FIRST: bool = true;

    fn slot(derived: &mut Derived) -> &mut Slot<Self> {
        &mut derived.error_map
    }

    fn make(
        &self,
        _follow: &mut dyn FnMut(Step<Self::Made>) -> ControlFlow<()>,
    ) -> Option<Self::Made> {
        Some(in_background(|| {
            error_map(&self.data.0, self.weight, self.limit, &self.brdf)
        }))
    }
}
