//! Settings of the polar lobes.

use crate::figure::Channel;
use crate::figure::scale::RadialScale;
use crate::geom::degrees;
use serde::{Deserialize, Serialize};

/// What the lobe tile shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LobeTile {
    /// Angles of incidence in radians.
    #[serde(with = "degrees")]
    pub theta_i: Vec<f64>,
    /// The one whose vectors are drawn.
    pub active: usize,
    /// Radius per f_r.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi.
    pub with_cosine: bool,
    /// Which channel.
    pub channel: Channel,
    /// The values in the middle and at the rim, in 1/sr, where the wheel has set them.
    #[serde(default)]
    pub limits: Option<[f64; 2]>,
}
