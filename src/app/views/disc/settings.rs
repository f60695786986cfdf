//! Settings of the disc: those of its figure.

use crate::app::state::probe::{Probe, same};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::ProbeMark;
use crate::figure::disc::DiscSpec;
use crate::figure::faults::{Faults, are_limits};
use crate::figure::heatmap::ColorScale;
use crate::figure::panel::PanelView as _;
use crate::geom::directions::{phi, theta, wrap};
use crate::geom::limits::MAX_THETA_I;
use std::f64::consts::TAU;

/// Settings of the disc. The probe is filled in while drawing.
pub type DiscSettings = DiscSpec;

/// Ends of the factor of a ratio that the wheel reaches.
const FACTORS: [f64; 2] = [1.01, 1e6];

impl Settings for DiscSettings {
    const VIEW: ViewId = ViewId::Disc;

    fn sanitized(mut self) -> Self {
        self.sanitize(&mut Faults::default());
        self.theta_i = self.theta_i.min(MAX_THETA_I);
        self
    }
}

/// The disc with the probe on it.
pub fn with_probe(settings: &DiscSettings, probe: Option<Probe>) -> DiscSpec {
    DiscSpec {
        probe: probe.map(|probe| mark(settings, probe)),
        ..settings.clone()
    }
}

/// The place of a probe as θo and φo in radians: its plane of incidence is turned into that of the disc, which is the same
/// for an isotropic material. Exact where its θi is that of the disc.
fn mark(settings: &DiscSettings, probe: Probe) -> ProbeMark<[f64; 2]> {
    let turn = if same(probe.theta_i(), 0.0) {
        0.0
    } else {
        settings.phi_i - phi(probe.wi)
    };
    ProbeMark {
        at: [theta(probe.wo), wrap(phi(probe.wo) + turn, TAU)],
        exact: same(probe.theta_i(), settings.theta_i),
    }
}

/// Settings with the light at a place of the disc, in units of its radius; the nearest one above the horizon.
pub fn with_light_at(settings: &DiscSettings, [x, y]: [f64; 2]) -> DiscSettings {
    let radius = x.hypot(y);
    // In the middle every azimuth is right: the old one stays.
    let phi_i = if radius > 1e-3 {
        wrap(y.atan2(x), TAU)
    } else {
        settings.phi_i
    };
    let theta_i = settings.projection.theta(radius.min(1.0)).min(MAX_THETA_I);
    DiscSettings {
        theta_i,
        phi_i,
        ..settings.clone()
    }
}

/// The ends of the colours `factor` times nearer; `None` where there is nothing more to see.
pub fn zoomed(colors: &ColorScale, factor: f64) -> Option<[f64; 2]> {
    let ends = match colors {
        ColorScale::Amount(axis) | ColorScale::Signed(axis) => axis.zoomed(0.0, factor),
        ColorScale::Ratio(most) => [0.0, most.powf(1.0 / factor).clamp(FACTORS[0], FACTORS[1])],
        ColorScale::Between(..) => return None,
    };
    are_limits(ends).then_some(ends)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::direction;
    use std::f64::consts::PI;

    #[test]
    fn a_probe_is_marked_in_the_plane_of_the_disc() {
        let settings = DiscSettings {
            theta_i: 0.7,
            phi_i: 1.0,
            ..DiscSettings::default()
        };
        // Light from the left, the viewer 0.4 to the left of the mirror direction.
        let probe = Probe {
            wi: direction(0.7, PI),
            wo: direction(0.9, 0.4),
        };
        let found = mark(&settings, probe);
        assert!(found.exact);
        assert!((found.at[0] - 0.9).abs() < 1e-12);
        assert!((found.at[1] - (1.0 + PI + 0.4)).abs() < 1e-12);
        let other = DiscSettings {
            theta_i: 0.71,
            ..settings
        };
        assert!(!mark(&other, probe).exact);
    }

    #[test]
    fn the_light_stays_above_the_horizon_and_keeps_its_azimuth_in_the_middle() {
        let settings = DiscSettings::default();
        let beyond = with_light_at(&settings, [0.0, -3.0]);
        assert_eq!(beyond.theta_i, MAX_THETA_I);
        assert!((beyond.phi_i - 1.5 * PI).abs() < 1e-12);
        let middle = with_light_at(&settings, [0.0, 0.0]);
        assert_eq!((middle.theta_i, middle.phi_i), (0.0, settings.phi_i));
        let half = with_light_at(&settings, [-0.5, 0.0]);
        assert!((half.theta_i - PI / 4.0).abs() < 1e-12);
    }
}
