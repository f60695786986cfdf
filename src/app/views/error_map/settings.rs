//! Settings of the error map, and the job behind it.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::error_map::Plane;
use crate::figure::faults::Faults;
use crate::figure::heatmap::HeatView;
use crate::figure::scale::RadialScale;
use serde::{Deserialize, Serialize};

/// Settings of the tile of the error map.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ErrorMapSettings {
    /// Axes of the map.
    pub plane: Plane,
    /// Law from shares to colours.
    pub scale: RadialScale,
    /// The part in sight.
    pub view: HeatView,
}

impl Default for ErrorMapSettings {
    fn default() -> Self {
        Self {
            plane: Plane::Directions,
            scale: RadialScale::CubeRoot,
            view: HeatView::default(),
        }
    }
}

impl Settings for ErrorMapSettings {
    const VIEW: ViewId = ViewId::ErrorMap;

    fn sanitized(mut self) -> Self {
        self.view.sanitize(&mut Faults::default());
        self
    }
}
