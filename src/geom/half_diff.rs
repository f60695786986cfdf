//! Half and difference angles [Rusinkiewicz98], the coordinates of isotropic measurements.

use super::cosines::{Cosine, Cosines};
use super::directions::{ROUNDING, half_vector, opposite, theta, wrap};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Half and difference angles of a pair of directions, in radians.
///
/// For directions above the horizon `theta_h` and `theta_d` are in [0, π/2]. `phi_d` is in [0, 2π);
/// [`HalfDiff::folded`] brings it into [0, π), where the pairs (wi, wo) and (wo, wi) meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfDiff {
    /// Angle between the normal and the half vector wh.
    pub theta_h: f64,
    /// Angle between wh and wi (and between wh and wo).
    pub theta_d: f64,
    /// Azimuth of wi around wh, from the plane of n and wh; 0 where wh = n or wi = wh leaves it undefined.
    pub phi_d: f64,
}

impl HalfDiff {
    /// Half and difference angles of the unit vectors (wi, wo). `None` where wi = −wo off the horizon, which have no
    /// half vector; on the horizon they are the limit of [`half_vector`].
    pub fn from_directions(wi: DVec3, wo: DVec3) -> Option<Self> {
        if opposite(wi, wo) && wi.z.abs() > ROUNDING {
            return None;
        }
        let wh = half_vector(wi, wo);
        let theta_h = theta(wh);
        // atan2 of chords instead of acos: exact at both ends.
        let theta_d = (wi - wo).length().atan2((wi + wo).length());
        let horizontal = wh.x.hypot(wh.y);
        if horizontal < ROUNDING {
            // Mirror directions. Without a convention the rounding of sines would choose the azimuth.
            return Some(Self {
                theta_h,
                theta_d,
                phi_d: 0.0,
            });
        }
        let (sin_phi_h, cos_phi_h) = (wh.y / horizontal, wh.x / horizontal);
        let tangent = DVec3::new(wh.z * cos_phi_h, wh.z * sin_phi_h, -horizontal);
        let bitangent = DVec3::new(-sin_phi_h, cos_phi_h, 0.0);
        // wi − wo has no component along wh, so it leaves nothing to cancel.
        let across = wi - wo;
        let phi_d = wrap(across.dot(bitangent).atan2(across.dot(tangent)), TAU);
        Some(Self {
            theta_h,
            theta_d,
            phi_d,
        })
    }

    /// A pair of unit vectors (wi, wo) with these angles: the one whose half vector is in the plane y = 0, x ≥ 0.
    pub fn to_directions(self) -> (DVec3, DVec3) {
        let (sin_h, cos_h) = self.theta_h.sin_cos();
        let (sin_d, cos_d) = self.theta_d.sin_cos();
        let (sin_phi, cos_phi) = self.phi_d.sin_cos();
        let wh = DVec3::new(sin_h, 0.0, cos_h);
        let tangent = DVec3::new(cos_h, 0.0, -sin_h);
        let across = sin_d * (cos_phi * tangent + sin_phi * DVec3::Y);
        (cos_d * wh + across, cos_d * wh - across)
    }

    /// Angles with `phi_d` folded by +π into [0, π): reciprocity says f_r(wi, wo) = f_r(wo, wi).
    pub fn folded(self) -> Self {
        Self {
            phi_d: wrap(self.phi_d, PI),
            ..self
        }
    }

    /// Cosines of the pair of directions, from the angles without vectors: `cos θi, cos θo = cos θh cos θd ∓ sin θh sin
    /// θd cos φd` and `wr·wo = 2 cos θi cos θo − cos 2θd`.
    pub fn cosines(self) -> Cosines {
        let (sin_h, cos_h) = self.theta_h.sin_cos();
        let (sin_d, cos_d) = self.theta_d.sin_cos();
        let (along, across) = (cos_h * cos_d, sin_h * sin_d * self.phi_d.cos());
        let (cos_theta_i, cos_theta_o) = (along - across, along + across);
        let wr_dot_wo = 2.0 * cos_theta_i * cos_theta_o - (2.0 * self.theta_d).cos();
        Cosines {
            cos_theta_i,
            cos_theta_o,
            wr_wo: Cosine {
                cos: wr_dot_wo.clamp(0.0, 1.0),
                versine: (1.0 - wr_dot_wo).clamp(0.0, 1.0),
            },
            wh_n: Cosine::of(self.theta_h),
            wi_wh: Cosine::of(self.theta_d),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::directions::NORMAL;
    use super::*;
    use crate::geom::direction;
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;

    /// Distance between two azimuths on a circle of the given period.
    fn azimuth_distance(a: f64, b: f64, period: f64) -> f64 {
        let d = wrap(a - b, period);
        d.min(period - d)
    }

    fn hemisphere() -> impl Strategy<Value = DVec3> {
        (0.0..FRAC_PI_2, 0.0..TAU).prop_map(|(theta, phi)| direction(theta, phi))
    }

    proptest! {
        #[test]
        fn angles_survive_the_way_through_directions(
            theta_h in 1e-4..FRAC_PI_2, theta_d in 1e-4..FRAC_PI_2 - 1e-4, phi_d in 0.0..TAU,
        ) {
            let (wi, wo) = HalfDiff { theta_h, theta_d, phi_d }.to_directions();
            let back = HalfDiff::from_directions(wi, wo).expect("has a half vector");
            prop_assert!((back.theta_h - theta_h).abs() < 1e-12);
            prop_assert!((back.theta_d - theta_d).abs() < 1e-12);
            prop_assert!(azimuth_distance(back.phi_d, phi_d, TAU) < 1e-10);
        }

        #[test]
        fn directions_survive_up_to_a_turn_around_the_normal(wi in hemisphere(), wo in hemisphere()) {
            let Some(angles) = HalfDiff::from_directions(wi, wo) else { return Ok(()) };
            let (wi2, wo2) = angles.to_directions();
            prop_assert!((wi2.z - wi.z).abs() < 1e-12 && (wo2.z - wo.z).abs() < 1e-12);
            prop_assert!((wi2.dot(wo2) - wi.dot(wo)).abs() < 1e-12);
            // A turn is not a reflection: the handedness stays.
            prop_assert!((wi2.cross(wo2).z - wi.cross(wo).z).abs() < 1e-12);
        }

        #[test]
        fn swapping_the_directions_turns_phi_d_by_pi(wi in hemisphere(), wo in hemisphere()) {
            let (Some(a), Some(b)) = (HalfDiff::from_directions(wi, wo), HalfDiff::from_directions(wo, wi))
                else { return Ok(()) };
            prop_assert_eq!(a.theta_h, b.theta_h);
            prop_assert_eq!(a.theta_d, b.theta_d);
            prop_assert!(azimuth_distance(a.phi_d, b.phi_d + PI, TAU) < 1e-9);
            prop_assert!(azimuth_distance(a.folded().phi_d, b.folded().phi_d, PI) < 1e-9);
            prop_assert!((0.0..PI).contains(&a.folded().phi_d));
        }

        #[test]
        fn the_closed_forms_of_the_cosines_agree_with_the_vectors(wi in hemisphere(), wo in hemisphere()) {
            let Some(angles) = HalfDiff::from_directions(wi, wo) else { return Ok(()) };
            let (a, b) = (angles.cosines(), Cosines::from_directions(wi, wo));
            prop_assert!((a.cos_theta_i - b.cos_theta_i).abs() < 1e-12);
            prop_assert!((a.cos_theta_o - b.cos_theta_o).abs() < 1e-12);
            prop_assert!((a.wr_wo.versine - b.wr_wo.versine).abs() < 1e-12);
            prop_assert!((a.wh_n.versine - b.wh_n.versine).abs() < 1e-12);
            prop_assert!((a.wi_wh.cos - b.wi_wh.cos).abs() < 1e-12);
        }
    }

    #[test]
    fn opposite_directions_have_no_half_vector() {
        let w = direction(0.5, 0.3);
        assert_eq!(HalfDiff::from_directions(w, -w), None);
        assert_eq!(half_vector(DVec3::X, -DVec3::X), NORMAL);
    }

    #[test]
    fn the_mirror_direction_at_the_horizon_is_the_limit() {
        for deg in [0.0, 30.0, 45.0, 123.0_f64] {
            let (wi, wo) = (
                direction(FRAC_PI_2, deg.to_radians()),
                direction(FRAC_PI_2, (deg + 180.0).to_radians()),
            );
            let angles = HalfDiff::from_directions(wi, wo).expect("a limit");
            assert_eq!((angles.theta_h, angles.phi_d), (0.0, 0.0));
            assert!((angles.theta_d - FRAC_PI_2).abs() < 1e-12);
            assert_eq!(Cosines::from_directions(wi, wo).wh_n.cos, 1.0);
        }
    }

    #[test]
    fn degenerate_pairs_have_finite_angles() {
        let w = direction(0.7, 1.1);
        let same = HalfDiff::from_directions(w, w).expect("has a half vector");
        assert_eq!(same.theta_d, 0.0);
        assert!((same.theta_h - 0.7).abs() < 1e-15 && same.phi_d == 0.0);

        let mirrored = HalfDiff::from_directions(w, crate::geom::mirror(w)).expect("has one");
        assert_eq!(mirrored.theta_h, 0.0);
        assert!((mirrored.theta_d - 0.7).abs() < 1e-15);

        let top = HalfDiff::from_directions(DVec3::Z, DVec3::Z).expect("has one");
        assert_eq!((top.theta_h, top.theta_d, top.phi_d), (0.0, 0.0, 0.0));
    }

    #[test]
    fn the_fold_is_a_turn_not_a_mirror() {
        let angles = |deg: f64| HalfDiff {
            theta_h: 0.3,
            theta_d: 0.4,
            phi_d: deg.to_radians(),
        };
        assert!((angles(350.0).folded().phi_d.to_degrees() - 170.0).abs() < 1e-12);
        assert!((angles(10.0).folded().phi_d.to_degrees() - 10.0).abs() < 1e-12);
    }
}
