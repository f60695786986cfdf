//! Settings of the albedo plot, and the jobs that compute its curves.
//!
//! Measurements and models are apart: a slider changes the model in milliseconds, a table takes seconds.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::albedo::AlbedoSpec;
use crate::figure::faults::Faults;
use crate::figure::panel::PanelView as _;
use serde::{Deserialize, Serialize};

/// Settings of the tile of the albedo plot.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct AlbedoSettings {
    /// Spec of the plot. Its `probe` is left out: it is filled in while drawing.
    pub spec: AlbedoSpec,
}

impl Settings for AlbedoSettings {
    const VIEW: ViewId = ViewId::Albedo;

    fn sanitized(mut self) -> Self {
        self.spec.sanitize(&mut Faults::default());
        self
    }
}
