//! Settings of the slices, and the mark of the probe in them.

use crate::app::state::probe::{Probe, same};
use crate::app::state::sanitize::offered;
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::ProbeMark;
use crate::figure::faults::Faults;
use crate::figure::panel::PanelView as _;
use crate::figure::slices::{Over, SliceSpec};
use crate::geom::HalfDiff;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};

/// Settings of the tile of the slices.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SliceSettings {
    /// Spec of the plot. Its `probe` is left out: it is filled in while drawing.
    pub spec: SliceSpec,
    /// Whether the fixed angles are those of the probe.
    pub follow: bool,
}

impl Settings for SliceSettings {
    const VIEW: ViewId = ViewId::Slices;

    fn sanitized(mut self) -> Self {
        let spec = &mut self.spec;
        spec.sanitize(&mut Faults::default());
        offered(&mut spec.theta_i, FRAC_PI_2);
        spec.active = spec.active.min(spec.theta_i.len() - 1);
        self
    }
}

/// Slices of `spec` moved to the probe's angles.
pub fn through(spec: &SliceSpec, probe: Probe) -> SliceSpec {
    let mut spec = spec.clone();
    let active = spec.active;
    if spec.over == Over::ThetaO {
        if let Some(theta_i) = spec.theta_i.get_mut(active) {
            *theta_i = probe.theta_i().min(FRAC_PI_2);
        }
    } else if let Some(angles) = HalfDiff::from_directions(probe.wi, probe.wo) {
        spec.theta_d = angles.theta_d;
        // At the pole any φd is right: the old one stays.
        if angles.theta_h > 1e-6 && angles.theta_d > 1e-6 {
            spec.phi_d = angles.phi_d;
        }
        spec.theta_h = angles.theta_h;
    }
    spec
}

/// Mark of the probe in the slices.
pub fn mark(spec: &SliceSpec, probe: Probe) -> Option<ProbeMark> {
    if spec.over == Over::ThetaO {
        return Some(probe.mark_in_plane(*spec.theta_i.get(spec.active)?));
    }
    let angles = HalfDiff::from_directions(probe.wi, probe.wo)?;
    let theta_h = same(angles.theta_h, spec.theta_h);
    let theta_d = same(angles.theta_d, spec.theta_d);
    // (wi, wo) and (wo, wi) are half a turn apart. Near the poles every φd is the same pair.
    let turn = (angles.phi_d - spec.phi_d).rem_euclid(PI);
    let apart = turn.min(PI - turn) * angles.theta_h.min(angles.theta_d);
    let phi_d = same(apart, 0.0);
    Some(match spec.over {
        Over::ThetaO | Over::ThetaH => ProbeMark {
            at: angles.theta_h,
            exact: theta_d && phi_d,
        },
        Over::ThetaD => ProbeMark {
            at: angles.theta_d,
            exact: theta_h && phi_d,
        },
        Over::PhiD => ProbeMark {
            at: angles.phi_d,
            exact: theta_h && theta_d,
        },
    })
}

/// The pair of directions at an angle of the active slice; `None` below the horizon.
pub fn probe_at(spec: &SliceSpec, x: f64) -> Option<Probe> {
    if spec.over == Over::ThetaO {
        return Some(Probe::in_plane(*spec.theta_i.get(spec.active)?, x));
    }
    let (wi, wo) = spec.pair(spec.active, x);
    (wi.z >= 0.0 && wo.z >= 0.0).then_some(Probe { wi, wo })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::slices::OVERS;

    fn spec(over: Over) -> SliceSpec {
        SliceSpec {
            over,
            theta_h: 0.2,
            theta_d: 0.7,
            phi_d: 1.1,
            ..SliceSpec::default()
        }
    }

    #[test]
    fn a_probe_of_a_slice_is_marked_where_it_was_taken() {
        for over in OVERS {
            let spec = spec(over);
            for x in [0.1, 0.6] {
                let probe = probe_at(&spec, x).expect("above the horizon");
                let mark = mark(&spec, probe).expect("a mark");
                assert!(
                    mark.exact && (mark.at - x).abs() < 1e-9,
                    "{over:?} {mark:?}"
                );
                let mut other = spec.clone();
                other.theta_i[0] += 0.01;
                other.theta_h += 0.01;
                other.theta_d += 0.01;
                assert!(
                    !crate::app::views::slices::settings::mark(&other, probe)
                        .expect("a mark")
                        .exact
                );
            }
        }
        assert_eq!(probe_at(&spec(Over::ThetaH), 1.5), None);
    }

    #[test]
    fn slices_through_a_probe_hold_it() {
        for over in OVERS {
            let probe = Probe::in_plane(0.9, 0.3);
            let spec = through(&spec(over), probe);
            let mark = mark(&spec, probe).expect("a mark");
            assert!(mark.exact, "{over:?}");
            // And again: it stays where it is.
            let again = probe_at(&spec, mark.at).expect("above the horizon");
            let twice = through(&spec, again);
            assert!((twice.theta_d - spec.theta_d).abs() < 1e-9);
            assert!((twice.phi_d - spec.phi_d).abs() < 1e-9);
        }
    }
}
