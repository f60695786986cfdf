//! The lobes in space.

use crate::figure::Channel;
use crate::figure::lobe3d::Camera;
use crate::figure::scale::RadialScale;
use crate::geom::degrees;
use serde::{Deserialize, Serialize};

/// What the tile of lobes in space shows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Lobe3dView {
    /// Angle of incidence in radians where there is no probe.
    #[serde(with = "degrees")]
    pub theta_i: f64,
    /// Radius per f_r.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi.
    pub with_cosine: bool,
    /// Which channel.
    pub channel: Channel,
    /// Where it is seen from.
    pub camera: Camera,
}

impl Default for Lobe3dView {
    fn default() -> Self {
        Self {
            theta_i: 45_f64.to_radians(),
            scale: RadialScale::CubeRoot,
            with_cosine: false,
            channel: Channel::Luminance,
            camera: Camera::default(),
        }
    }
}
