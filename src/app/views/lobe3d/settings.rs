//! Settings of the lobes in space: those of their figure.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::faults::Faults;
use crate::figure::lobe3d::Lobe3dSpec;
use crate::figure::panel::PanelView as _;
use crate::geom::limits::MAX_THETA_I;

/// Settings of the lobes in space. θi is that of the light where there is no probe.
pub type Lobe3dSettings = Lobe3dSpec;

impl Settings for Lobe3dSettings {
    const VIEW: ViewId = ViewId::Lobe3d;

    fn sanitized(mut self) -> Self {
        self.sanitize(&mut Faults::default());
        self.theta_i = self.theta_i.min(MAX_THETA_I);
        self
    }
}
