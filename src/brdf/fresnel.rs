//! The Fresnel factor of the specular term: unpolarised light on a dielectric, seen from outside.

use crate::keys;
use serde::{Deserialize, Serialize};

/// Reflectance R_F(wi·wh, η) that multiplies the specular term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Fresnel {
    /// R_F = 1.
    None,
    /// The Fresnel equations for unpolarised light [CookTorrance82].
    Exact,
    /// Schlick's approximation [Schlick94] with R_F(0) = ((η−1)/(η+1))².
    Schlick,
}

/// All Fresnel factors in the order in which they are offered, which is also their index on the GPU.
pub const FRESNELS: [Fresnel; 3] = [Fresnel::None, Fresnel::Exact, Fresnel::Schlick];

impl Fresnel {
    /// Name in files and on the command line, e.g. "exact".
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Display name, e.g. "Exact".
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "None",
            Self::Exact => "Exact",
            Self::Schlick => "Schlick",
        }
    }

    /// Formula in words with the key of its source; empty for [`Fresnel::None`].
    pub fn source(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Exact => "the Fresnel equations for unpolarised light [CookTorrance82]",
            Self::Schlick => "Schlick's approximation [Schlick94]",
        }
    }

    /// The Fresnel factor with this `key`.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }

    /// Index in [`FRESNELS`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// R_F in [0, 1] at `cos_theta` = wi·wh in [0, 1] for the relative index of refraction `eta` ≥ 1.
    pub fn reflectance(self, cos_theta: f64, eta: f64) -> f64 {
        match self {
            Self::None => 1.0,
            Self::Exact => fresnel_exact(cos_theta, eta),
            Self::Schlick => fresnel_schlick(cos_theta, eta),
        }
    }
}

fn fresnel_exact(cos_theta: f64, eta: f64) -> f64 {
    let c = cos_theta.clamp(0.0, 1.0);
    // cos of the refracted angle times η. At η = 1, c = 0 both are 0 and nothing is reflected but at the limit.
    let g = (eta * eta - 1.0 + c * c).sqrt();
    if g + c == 0.0 {
        return 1.0;
    }
    // [CookTorrance82] eq. for unpolarised light, in c and g.
    let a = (g - c) / (g + c);
    let b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    0.5 * a * a * (1.0 + b * b)
}

fn fresnel_schlick(cos_theta: f64, eta: f64) -> f64 {
    let r0 = ((eta - 1.0) / (eta + 1.0)).powi(2);
    r0 + (1.0 - r0) * (1.0 - cos_theta.clamp(0.0, 1.0)).powi(5)
}
