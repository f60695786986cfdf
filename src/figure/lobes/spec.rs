//! The settings of a lobe plot, and what it plots of a subject.

use crate::figure::cosine::CosineFactor;
use crate::figure::mark::ProbeMark;
use crate::figure::scale::RadialScale;
use crate::figure::subject::{Channel, Subject};
use crate::geom::degrees;
use glam::DVec3;
use serde::{Deserialize, Serialize};

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
    pub scale: RadialScale,
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
            scale: RadialScale::default(),
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
