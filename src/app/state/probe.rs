//! The probe: one pair of directions that every view marks, moved by whichever view is under the pointer.

use crate::figure::ProbeMark;
use crate::geom::{HalfDiff, Rgb, direction, directions};
use glam::DVec3;
use std::f64::consts::PI;

/// Angles in radians that differ less are the same on any screen.
const SAME: f64 = 2e-3;

/// A pair of directions in the local frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Unit vector to the light.
    pub wi: DVec3,
    /// Unit vector to the viewer.
    pub wo: DVec3,
}

impl Probe {
    /// Probe in the plane of incidence, light from the left: θi and signed θo in radians, θo positive on the right.
    pub fn in_plane(theta_i: f64, theta_o: f64) -> Self {
        Self {
            wi: direction(theta_i, PI),
            wo: direction(theta_o.abs(), if theta_o < 0.0 { PI } else { 0.0 }),
        }
    }

    /// Probe at half and difference angles; `None` where a direction is below the horizon.
    pub fn from_angles(angles: HalfDiff) -> Option<Self> {
        let (wi, wo) = angles.to_directions();
        (wi.z >= 0.0 && wo.z >= 0.0).then_some(Self { wi, wo })
    }

    /// θi in radians.
    pub fn theta_i(self) -> f64 {
        directions::theta(self.wi)
    }

    /// θo in radians, positive on the side of the mirror direction, negative on the side of the light.
    pub fn signed_theta_o(self) -> f64 {
        let theta_o = directions::theta(self.wo);
        let towards_light = self.wi.x * self.wo.x + self.wi.y * self.wo.y;
        if towards_light > 0.0 {
            -theta_o
        } else {
            theta_o
        }
    }

    /// Half and difference angles, φ_d folded into [0, π); `None` for opposite directions.
    pub fn angles(self) -> Option<HalfDiff> {
        HalfDiff::from_directions(self.wi, self.wo).map(HalfDiff::folded)
    }

    /// Mark at its signed θo in radians, for the plane of incidence at `theta_i`; exact where the probe is there.
    pub fn mark_in_plane(self, theta_i: f64) -> ProbeMark {
        let at = self.signed_theta_o();
        let off_plane = (self.wi.x * self.wo.y - self.wi.y * self.wo.x).abs();
        let sines = self.wi.truncate().length() * self.wo.truncate().length();
        ProbeMark {
            at,
            exact: same(self.theta_i(), theta_i) && off_plane <= SAME * sines.max(SAME),
        }
    }
}

/// Whether two angles in radians are the same for the eye.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME
}

/// Model over measurement per channel; NaN where nothing was reflected.
pub fn ratio(measured: Rgb, model: Rgb) -> Rgb {
    std::array::from_fn(|k| {
        if measured[k] > 0.0 {
            model[k] / measured[k]
        } else {
            f64::NAN
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_probe_in_the_plane_is_found_there_wherever_the_light_stands() {
        for (theta_i, theta_o) in [(0.5, 0.9), (1.2, -0.3), (0.0, 0.4), (0.7, 0.0)] {
            let probe = Probe::in_plane(theta_i, theta_o);
            let turn = glam::DMat3::from_rotation_z(1.1);
            let turned = Probe {
                wi: turn * probe.wi,
                wo: turn * probe.wo,
            };
            for probe in [probe, turned] {
                let mark = probe.mark_in_plane(theta_i);
                assert!(
                    (mark.at - theta_o).abs() < 1e-9 && mark.exact,
                    "{theta_i} {theta_o}"
                );
                assert!(!probe.mark_in_plane(theta_i + 0.01).exact);
            }
        }
        let aside = Probe {
            wi: direction(0.5, PI),
            wo: direction(0.9, 0.1),
        };
        assert!(!aside.mark_in_plane(0.5).exact);
    }

    #[test]
    fn angles_and_directions_are_the_same_probe() {
        let angles = HalfDiff {
            theta_h: 0.3,
            theta_d: 0.8,
            phi_d: 1.1,
        };
        let again = Probe::from_angles(angles)
            .and_then(Probe::angles)
            .expect("above the horizon");
        assert!((again.theta_h - 0.3).abs() < 1e-12);
        assert!((again.theta_d - 0.8).abs() < 1e-12);
        assert!((again.phi_d - 1.1).abs() < 1e-12);
    }
}
