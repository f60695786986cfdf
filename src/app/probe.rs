//! The probe: one pair of directions that every view marks, moved by whichever view is under the pointer.

use super::state::State;
use super::update::Msg;
use crate::figure::Mark;
use crate::geom::{HalfDiff, Rgb, direction, directions};
use glam::DVec3;
use std::f64::consts::PI;

/// Angles in radians that differ less are the same on any screen.
const SAME: f64 = 2e-3;

/// A pair of directions in the local frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// To the light.
    pub wi: DVec3,
    /// To the viewer.
    pub wo: DVec3,
}

impl Probe {
    /// In the plane of incidence with the light from the left: θi and signed θo in radians, θo positive on the right.
    pub fn in_plane(theta_i: f64, theta_o: f64) -> Self {
        Self {
            wi: direction(theta_i, PI),
            wo: direction(theta_o.abs(), if theta_o < 0.0 { PI } else { 0.0 }),
        }
    }

    /// From half and difference angles; `None` where a direction is below the horizon.
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

    /// Where it is in the plane of incidence of `theta_i`, as a signed θo.
    pub fn mark_in_plane(self, theta_i: f64) -> Mark {
        let at = self.signed_theta_o();
        let off_plane = (self.wi.x * self.wo.y - self.wi.y * self.wo.x).abs();
        let sines = self.wi.truncate().length() * self.wo.truncate().length();
        Mark {
            at,
            exact: same(self.theta_i(), theta_i) && off_plane <= SAME * sines.max(SAME),
        }
    }
}

/// Whether two angles in radians are the same for the eye.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME
}

/// Moves the probe to what is under the pointer; says nothing where that is the same as before.
pub fn hover(state: &State, probe: Option<Probe>, out: &mut Vec<Msg>) {
    if probe != state.hovered {
        out.push(Msg::Hover(probe));
    }
}

/// Pins the probe; a second click at the same place lets it go.
pub fn pin(state: &State, probe: Probe, out: &mut Vec<Msg>) {
    let near = |pinned: Probe| {
        (pinned.wi - probe.wi).length() < 0.02 && (pinned.wo - probe.wo).length() < 0.02
    };
    out.push(Msg::Pin(match state.pinned {
        Some(pinned) if near(pinned) => None,
        _ => Some(probe),
    }));
}

impl State {
    /// The pinned probe, or else what is under the pointer.
    pub fn probe(&self) -> Option<Probe> {
        self.pinned.or(self.hovered)
    }

    /// f_r of the shown material and of its model at a pair of directions.
    pub fn values_at(&self, probe: Probe) -> (Option<Rgb>, Option<Rgb>) {
        let Some((material, opened)) = self.current() else {
            return (None, None);
        };
        let measured = material.table.lookup(probe.wi, probe.wo, self.scene.lookup);
        (measured, opened.brdf.f_r(probe.wi, probe.wo))
    }

    /// The probe's angles in degrees and the values there, tab-separated, under a line that names them.
    pub fn probe_row(&self) -> Option<String> {
        let probe = self.probe()?;
        let (material, opened) = self.current()?;
        let (measured, model) = self.values_at(probe);
        let angles = probe.angles();
        let mut names = vec!["material".to_string(), "model".to_string()];
        let mut values = vec![material.name.clone(), opened.brdf.model.key.to_string()];
        let mut degrees = |name: &str, angle: Option<f64>| {
            names.push(format!("{name}_deg"));
            values.push(angle.map_or(String::new(), |x| format!("{:.6}", x.to_degrees())));
        };
        degrees("theta_i", Some(directions::theta(probe.wi)));
        degrees("phi_i", Some(directions::phi(probe.wi)));
        degrees("theta_o", Some(directions::theta(probe.wo)));
        degrees("phi_o", Some(directions::phi(probe.wo)));
        degrees("theta_h", angles.map(|angles| angles.theta_h));
        degrees("theta_d", angles.map(|angles| angles.theta_d));
        degrees("phi_d", angles.map(|angles| angles.phi_d));
        let ratio = measured
            .zip(model)
            .map(|(measured, model)| ratio(measured, model));
        for (name, rgb) in [("measured", measured), ("model", model), ("ratio", ratio)] {
            for (channel, letter) in ["r", "g", "b"].into_iter().enumerate() {
                names.push(format!("{name}_{letter}"));
                let value = rgb
                    .map(|rgb| rgb[channel])
                    .filter(|value| value.is_finite());
                values.push(value.map_or(String::new(), |value| format!("{value:e}")));
            }
        }
        Some(format!("{}\n{}\n", names.join("\t"), values.join("\t")))
    }
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
