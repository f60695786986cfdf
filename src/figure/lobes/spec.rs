//! The settings of a lobe plot, and what it plots of a subject.

use crate::figure::cosine::CosineFactor;
use crate::figure::mark::ProbeMark;
use crate::figure::scale::RadialScale;
use crate::figure::subject::{Channel, Subject};
use crate::geom::degrees;
use crate::keys;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// The law of the radius of a lobe plot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LobeScale {
    /// Chosen from the data, with the rim: linear for a matte material, the cube root for a glossy one, a logarithm for a
    /// needle.
    #[default]
    Auto,
    /// Length in proportion to the value.
    Linear,
    /// Length by the cube root of the value.
    CubeRoot,
    /// Length by the logarithm of the value above a floor.
    Log,
}

/// All scales of lobes in the order offered.
pub const LOBE_SCALES: [LobeScale; 4] = [
    LobeScale::Auto,
    LobeScale::Linear,
    LobeScale::CubeRoot,
    LobeScale::Log,
];

impl LobeScale {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        self.law().map_or("Auto", RadialScale::name)
    }

    /// The law that it names; `None` for one that the data choose.
    pub fn law(self) -> Option<RadialScale> {
        match self {
            Self::Auto => None,
            Self::Linear => Some(RadialScale::Linear),
            Self::CubeRoot => Some(RadialScale::CubeRoot),
            Self::Log => Some(RadialScale::Log),
        }
    }
}

impl From<RadialScale> for LobeScale {
    fn from(law: RadialScale) -> Self {
        match law {
            RadialScale::Linear => Self::Linear,
            RadialScale::CubeRoot => Self::CubeRoot,
            RadialScale::Log => Self::Log,
        }
    }
}

/// Settings of a lobe plot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LobeSpec {
    /// Angles of incidence in radians, in [0, π/2].
    #[serde(with = "degrees")]
    pub theta_i: Vec<f64>,
    /// Position of the θi that is drawn strong, with its vectors.
    pub active: usize,
    /// Law from values to radii.
    pub scale: LobeScale,
    /// Whether each curve is drawn in shares of its own maximum: shapes to compare, not values.
    pub shape_only: bool,
    /// Cosines that f_r is multiplied by.
    #[serde(rename = "with_cosine")]
    pub cosine: CosineFactor,
    /// Colour channel that is plotted.
    pub channel: Channel,
    /// The view direction under the probe: signed θo in radians.
    #[serde(skip)]
    pub probe: Option<ProbeMark>,
    /// The values in the middle and at the rim, in 1/sr; from the curves without.
    pub limits: Option<[f64; 2]>,
    /// Whether it is for paper: nothing to take hold of, no lobe before the others.
    pub still: bool,
}

impl Default for LobeSpec {
    fn default() -> Self {
        Self {
            theta_i: [30.0, 60.0, 80.0].map(f64::to_radians).to_vec(),
            active: 1,
            scale: LobeScale::default(),
            shape_only: false,
            cosine: CosineFactor::NONE,
            channel: Channel::default(),
            probe: None,
            limits: None,
            still: false,
        }
    }
}

impl LobeSpec {
    /// Whether a lobe is drawn strong.
    pub fn is_strong(&self, lobe: usize) -> bool {
        self.still || lobe == self.active
    }

    /// Plotted value of `subject` at these angles in radians (θo signed); `None` where it has no finite value.
    pub fn value(&self, subject: &Subject, theta_i: f64, theta_o: f64) -> Option<f64> {
        let wi = DVec3::new(-theta_i.sin(), 0.0, theta_i.cos());
        let wo = DVec3::new(theta_o.sin(), 0.0, theta_o.cos());
        let cosine = self.cosine.of(wi.z, wo.z);
        let value = cosine * self.channel.of(subject.source.f_r(wi, wo)?);
        value.is_finite().then_some(value)
    }
}
