//! The settings of a disc, and what it shows towards one direction.

use super::projection::DiscProjection;
use crate::figure::cosine::CosineFactor;
use crate::figure::mark::ProbeMark;
use crate::figure::scale::RadialScale;
use crate::figure::shown::Shown;
use crate::figure::subject::{Channel, Source};
use crate::geom::{degrees, direction};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Settings of a disc: light, scale, projection, colours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct DiscSpec {
    /// Data, model, their difference or their ratio.
    pub shown: Shown,
    /// θi in radians, in [0, π/2].
    #[serde(with = "degrees")]
    pub theta_i: f64,
    /// φi in radians, in [0, 2π).
    #[serde(with = "degrees")]
    pub phi_i: f64,
    /// Law from θo to the distance from the middle.
    pub projection: DiscProjection,
    /// Law from values to colours; ratios are always by their logarithm.
    pub scale: RadialScale,
    /// Channel of the values.
    pub channel: Channel,
    /// Cosines that f_r is multiplied by.
    #[serde(rename = "with_cosine")]
    pub cosine: CosineFactor,
    /// Smallest and largest value that has a colour of its own, in 1/sr; of a difference the second counts either way, of
    /// a ratio it is the largest factor. From the values without.
    pub limits: Option<[f64; 2]>,
    /// θo and φo of the probe in radians.
    #[serde(skip)]
    pub probe: Option<ProbeMark<[f64; 2]>>,
}

impl Default for DiscSpec {
    fn default() -> Self {
        Self {
            shown: Shown::Measured,
            theta_i: 60f64.to_radians(),
            phi_i: PI,
            projection: DiscProjection::Linear,
            scale: RadialScale::Log,
            channel: Channel::Luminance,
            cosine: CosineFactor::NONE,
            limits: None,
            probe: None,
        }
    }
}

impl DiscSpec {
    /// Unit vector to the light.
    pub fn wi(&self) -> DVec3 {
        let wi = direction(self.theta_i, self.phi_i);
        wi.with_z(wi.z.max(0.0))
    }

    /// The value towards `wo`, on or above the horizon; `None` where there is none.
    pub fn value(
        &self,
        measured: Option<&Source>,
        model: Option<&Source>,
        wo: DVec3,
    ) -> Option<f64> {
        let wi = self.wi();
        let cosine = self.cosine.of(wi.z, wo.z);
        let of = |source: Option<&Source>| {
            let value = cosine * self.channel.of(source?.f_r(wi, wo)?);
            value.is_finite().then_some(value)
        };
        self.shown.value(|| of(measured), || of(model))
    }
}
