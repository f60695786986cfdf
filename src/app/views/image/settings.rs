//! Settings of the image slice.

use crate::app::state::probe::{Probe, same};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::ProbeMark;
use crate::figure::faults::Faults;
use crate::figure::image_slice::ImageSpec;
use crate::figure::panel::PanelView as _;
use std::f64::consts::PI;

/// Settings of the image slice: those of its figure. The probe is filled in while drawing.
pub type ImageSettings = ImageSpec;

impl Settings for ImageSettings {
    const VIEW: ViewId = ViewId::Image;

    fn sanitized(mut self) -> Self {
        self.sanitize(&mut Faults::default());
        self
    }
}

/// The image slice with the probe on it.
pub fn with_probe(settings: &ImageSettings, probe: Option<Probe>) -> ImageSpec {
    ImageSpec {
        probe: probe.and_then(|probe| mark(probe, settings.phi_d)),
        ..settings.clone()
    }
}

/// Mark of a probe on θh and θd, in degrees; exact where its φd is that of the picture.
pub fn mark(probe: Probe, phi_d: f64) -> Option<ProbeMark<[f64; 2]>> {
    let angles = probe.angles()?;
    let apart = (angles.phi_d - phi_d).rem_euclid(PI);
    // φd means nothing in the mirror direction and where light and view are the same.
    let any = same(angles.theta_h, 0.0) || same(angles.theta_d, 0.0);
    Some(ProbeMark {
        at: [angles.theta_h.to_degrees(), angles.theta_d.to_degrees()],
        exact: any || same(apart.min(PI - apart), 0.0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::HalfDiff;

    #[test]
    fn a_probe_is_exact_at_its_own_azimuth_and_hollow_at_others() {
        let angles = |phi_d: f64| HalfDiff {
            theta_h: 0.3,
            theta_d: 0.5,
            phi_d,
        };
        for phi_d in [0.0, 0.7, PI / 2.0] {
            // Swapped directions are the same by reciprocity.
            for turn in [0.0, PI] {
                let probe = Probe::from_angles(angles(phi_d + turn)).expect("above");
                let mark_here = mark(probe, phi_d).expect("angles");
                assert!(mark_here.exact);
                assert!((mark_here.at[0] - 0.3f64.to_degrees()).abs() < 1e-9);
                assert!((mark_here.at[1] - 0.5f64.to_degrees()).abs() < 1e-9);
                assert!(!mark(probe, phi_d + 0.1).expect("angles").exact);
            }
        }
        let probe = Probe::from_angles(angles(0.0)).expect("above");
        assert!(mark(probe, PI).expect("angles").exact);
    }
}
