//! What the image slice is set to show.

use crate::app::state::probe::{Probe, same};
use crate::figure::Mark;
use crate::figure::heatmap::View;
use crate::figure::image_slice::{ImageSpec, Shown};
use crate::figure::scale::RadialScale;
use crate::figure::subject::Channel;
use crate::geom::degrees;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// What the tile of the image slice is set to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ImageView {
    /// Data, model or their difference.
    pub shown: Shown,
    /// φd in radians, in [0, π].
    #[serde(with = "degrees")]
    pub phi_d: f64,
    /// Whether θh is spread by its square root.
    pub root: bool,
    /// How values become colours.
    pub scale: RadialScale,
    /// Which channel.
    pub channel: Channel,
    /// Whether f_r is multiplied by cos θi.
    pub with_cosine: bool,
    /// The part in sight.
    pub view: View,
}

impl Default for ImageView {
    fn default() -> Self {
        let spec = ImageSpec::default();
        Self {
            shown: spec.shown,
            phi_d: spec.phi_d,
            root: spec.root,
            scale: spec.scale,
            channel: spec.channel,
            with_cosine: spec.with_cosine,
            view: spec.view,
        }
    }
}

impl ImageView {
    /// As a figure, with the probe on it.
    pub fn spec(&self, probe: Option<Probe>) -> ImageSpec {
        ImageSpec {
            shown: self.shown,
            phi_d: self.phi_d,
            root: self.root,
            scale: self.scale,
            channel: self.channel,
            with_cosine: self.with_cosine,
            limits: None,
            view: self.view,
            probe: probe.and_then(|probe| mark(probe, self.phi_d)),
        }
    }
}

/// Where a probe is on θh and θd, in degrees; exact where its φd is that of the picture.
pub fn mark(probe: Probe, phi_d: f64) -> Option<Mark<[f64; 2]>> {
    let angles = probe.angles()?;
    let apart = (angles.phi_d - phi_d).rem_euclid(PI);
    // φd means nothing in the mirror direction and where light and view are the same.
    let any = same(angles.theta_h, 0.0) || same(angles.theta_d, 0.0);
    Some(Mark {
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
