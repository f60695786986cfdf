//! Spec of a slice: the angle that runs, those that are fixed, and how values are shown.

use crate::figure::cosine::CosineFactor;
use crate::figure::mark::ProbeMark;
use crate::figure::scale::RadialScale;
use crate::figure::subject::{Channel, Subject};
use crate::geom::{HalfDiff, degrees};
use crate::keys;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, TAU};

/// The angle that a slice runs over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Over {
    /// Signed θo in the plane of incidence, at one or more θi.
    #[default]
    ThetaO,
    /// θh at fixed θd and φd.
    ThetaH,
    /// θd at fixed θh and φd.
    ThetaD,
    /// φd, the whole turn, at fixed θh and θd.
    PhiD,
}

/// Running angles in the order offered.
pub const OVERS: [Over; 4] = [Over::ThetaO, Over::ThetaH, Over::ThetaD, Over::PhiD];

impl Over {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// The angle in plain letters.
    pub fn name(self) -> &'static str {
        match self {
            Self::ThetaO => "θo",
            Self::ThetaH => "θh",
            Self::ThetaD => "θd",
            Self::PhiD => "φd",
        }
    }

    /// The angle in the markup of [`crate::figure::text`].
    pub fn symbol(self) -> &'static str {
        match self {
            Self::ThetaO => "θ_{o}",
            Self::ThetaH => "θ_{h}",
            Self::ThetaD => "θ_{d}",
            Self::PhiD => "φ_{d}",
        }
    }

    /// Running angle of a key.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }

    /// The ends of the angle in radians.
    pub fn range(self) -> [f64; 2] {
        match self {
            Self::ThetaO => [-FRAC_PI_2, FRAC_PI_2],
            Self::ThetaH | Self::ThetaD => [0.0, FRAC_PI_2],
            Self::PhiD => [0.0, TAU],
        }
    }
}

/// Residual shown below the curves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Residual {
    /// No residual.
    #[default]
    None,
    /// Model − measured.
    Difference,
    /// Model / measured.
    Ratio,
}

/// Residuals in the order offered.
pub const RESIDUALS: [Residual; 3] = [Residual::None, Residual::Difference, Residual::Ratio];

impl Residual {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "No residual",
            Self::Difference => "Difference",
            Self::Ratio => "Ratio",
        }
    }

    /// Residual of a key.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }
}

/// The narrowest window in radians.
const NARROWEST: f64 = 1e-5;
/// Closer to the pole than this, φd would be made up of rounding.
const OFF_POLE: f64 = 1e-9;

/// Settings of a plot of slices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SliceSpec {
    /// The angle that runs.
    pub over: Over,
    /// Angles of incidence of slices over θo, in radians, in [0, π/2].
    #[serde(with = "degrees")]
    pub theta_i: Vec<f64>,
    /// Position of the slice that is drawn strong.
    pub active: usize,
    /// Fixed θh in radians, in slices over θd and φd.
    #[serde(with = "degrees")]
    pub theta_h: f64,
    /// Fixed θd in radians, in slices over θh and φd.
    #[serde(with = "degrees")]
    pub theta_d: f64,
    /// Fixed φd in radians, in slices over θh and θd.
    #[serde(with = "degrees")]
    pub phi_d: f64,
    /// Law from values to heights.
    pub scale: RadialScale,
    /// Cosines that f_r is multiplied by.
    #[serde(rename = "with_cosine")]
    pub cosine: CosineFactor,
    /// Colour channel that is plotted.
    pub channel: Channel,
    /// Residual shown below the curves.
    pub residual: Residual,
    /// The part of the angle that is seen, in radians; all of it without.
    #[serde(with = "degrees")]
    pub window: Option<[f64; 2]>,
    /// The ends of the axis of values in 1/sr; from the curves without.
    pub limits: Option<[f64; 2]>,
    /// The angle under the probe, in radians.
    #[serde(skip)]
    pub probe: Option<ProbeMark>,
}

impl Default for SliceSpec {
    fn default() -> Self {
        Self {
            over: Over::default(),
            theta_i: vec![60f64.to_radians()],
            active: 0,
            theta_h: 0.0,
            theta_d: 45f64.to_radians(),
            phi_d: FRAC_PI_2,
            scale: RadialScale::Log,
            cosine: CosineFactor::NONE,
            channel: Channel::default(),
            residual: Residual::default(),
            window: None,
            limits: None,
            probe: None,
        }
    }
}

impl SliceSpec {
    /// Number of slices: one per θi over θo, else one.
    pub fn slices(&self) -> usize {
        if self.over == Over::ThetaO {
            self.theta_i.len()
        } else {
            1
        }
    }

    /// Whether a slice is drawn strong.
    pub fn is_active(&self, slice: usize) -> bool {
        self.over != Over::ThetaO || slice == self.active
    }

    /// wi and wo of a slice at an angle in radians; below the horizon too.
    pub fn pair(&self, slice: usize, x: f64) -> (DVec3, DVec3) {
        let angles = |theta_h: f64, theta_d, phi_d| {
            HalfDiff {
                theta_h: theta_h.max(OFF_POLE),
                theta_d,
                phi_d,
            }
            .to_directions()
        };
        match self.over {
            Over::ThetaO => {
                let theta_i = self.theta_i.get(slice).copied().unwrap_or(0.0);
                (
                    DVec3::new(-theta_i.sin(), 0.0, theta_i.cos()),
                    DVec3::new(x.sin(), 0.0, x.cos()),
                )
            }
            Over::ThetaH => angles(x, self.theta_d, self.phi_d),
            Over::ThetaD => angles(self.theta_h, x, self.phi_d),
            Over::PhiD => angles(self.theta_h, self.theta_d, x),
        }
    }

    /// Plotted value of `subject` at the angle `x`, in 1/sr; `None` below the horizon and where it is not finite.
    pub fn value(&self, subject: &Subject, slice: usize, x: f64) -> Option<f64> {
        let (wi, wo) = self.pair(slice, x);
        let cosine = self.cosine.of(wi.z, wo.z);
        let value = cosine * self.channel.of(subject.source.f_r(wi, wo)?);
        value.is_finite().then_some(value)
    }

    /// The part of the angle that is seen, in radians.
    pub fn seen(&self) -> [f64; 2] {
        let [first, last] = self.over.range();
        let Some([low, high]) = self.window else {
            return [first, last];
        };
        if !(low.is_finite() && high.is_finite()) {
            return [first, last];
        }
        let low = low.clamp(first, last - NARROWEST);
        [low, high.clamp(low + NARROWEST, last)]
    }
}
