//! Settings of the error landscape, and the job behind it.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::faults::Faults;
use crate::figure::heatmap::HeatView;
use serde::{Deserialize, Serialize};

/// Settings of the tile of the error landscape.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LandscapeSettings {
    /// Whether η is the best one at each point instead of the slider's.
    pub solve_eta: bool,
    /// The part in sight.
    pub view: HeatView,
}

impl Settings for LandscapeSettings {
    const VIEW: ViewId = ViewId::Landscape;

    fn sanitized(mut self) -> Self {
        self.view.sanitize(&mut Faults::default());
        self
    }
}
