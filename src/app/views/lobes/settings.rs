//! Settings of the polar lobes: those of their figure.

use crate::app::state::probe::Probe;
use crate::app::state::sanitize::offered;
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::faults::Faults;
use crate::figure::lobes::LobeSpec;
use crate::figure::panel::PanelView as _;
use crate::geom::limits::MAX_THETA_I;

/// Settings of the polar lobes. The probe is filled in while drawing.
pub type LobeSettings = LobeSpec;

impl Settings for LobeSettings {
    const VIEW: ViewId = ViewId::Lobes;

    fn sanitized(mut self) -> Self {
        self.sanitize(&mut Faults::default());
        offered(&mut self.theta_i, MAX_THETA_I);
        self.active = self.active.min(self.theta_i.len() - 1);
        self.still = false;
        self
    }
}

/// The plot of these settings, with the probe on it.
pub fn drawable(settings: &LobeSettings, probe: Option<Probe>) -> LobeSpec {
    let theta_i = settings.theta_i.get(settings.active);
    LobeSpec {
        probe: probe
            .zip(theta_i)
            .map(|(probe, theta_i)| probe.mark_in_plane(*theta_i)),
        ..settings.clone()
    }
}
