//! Parameters of the models: their values, and a row of properties for each.

use crate::geom::Rgb;
use std::ops::{Index, IndexMut};

/// Parameter values of a BRDF. ρ_d and k_s are linear RGB; s, α, η are shared by the channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Diffuse reflectance ρ_d, ≥ 0.
    pub rho_d: Rgb,
    /// Specular amplitude k_s in 1/sr, ≥ 0.
    pub k_s: Rgb,
    /// Specular exponent, > 0.
    pub s: f64,
    /// Blend α: weight of the Blinn-Phong cosine in the combined model, in [0, 1].
    pub alpha: f64,
    /// Relative index of refraction η, ≥ 1.
    pub eta: f64,
}

impl Params {
    /// Values of a parameter: three for a colour, one otherwise.
    pub fn get(&self, id: ParamId) -> &[f64] {
        match id {
            ParamId::RhoD => &self.rho_d,
            ParamId::KS => &self.k_s,
            ParamId::S => std::slice::from_ref(&self.s),
            ParamId::Alpha => std::slice::from_ref(&self.alpha),
            ParamId::Eta => std::slice::from_ref(&self.eta),
        }
    }

    /// Mutable values of a parameter: three for a colour, one otherwise.
    pub fn get_mut(&mut self, id: ParamId) -> &mut [f64] {
        match id {
            ParamId::RhoD => &mut self.rho_d,
            ParamId::KS => &mut self.k_s,
            ParamId::S => std::slice::from_mut(&mut self.s),
            ParamId::Alpha => std::slice::from_mut(&mut self.alpha),
            ParamId::Eta => std::slice::from_mut(&mut self.eta),
        }
    }
}

impl Default for Params {
    fn default() -> Self {
        let mut params = Self {
            rho_d: [0.0; 3],
            k_s: [0.0; 3],
            s: 0.0,
            alpha: 0.0,
            eta: 0.0,
        };
        for row in ALL {
            params.get_mut(row.id).fill(row.default);
        }
        params
    }
}

/// Identity of a parameter; the order is that of [`ALL`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ParamId {
    /// Diffuse reflectance ρ_d.
    RhoD,
    /// Specular amplitude k_s.
    KS,
    /// Specular exponent s.
    S,
    /// Lobe blend α.
    Alpha,
    /// Relative index of refraction η.
    Eta,
}

impl ParamId {
    /// Whether the parameter has a value per channel: ρ_d and k_s.
    pub fn is_color(self) -> bool {
        matches!(self, Self::RhoD | Self::KS)
    }

    /// Name of the parameter in files and shaders, e.g. "rho_d".
    pub fn key(self) -> &'static str {
        ALL.iter()
            .find(|row| row.id == self)
            .map_or("", |row| row.key)
    }
}

/// A value of one type for each parameter; indexed by [`ParamId`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PerParam<T> {
    /// Value for the diffuse reflectance ρ_d.
    pub rho_d: T,
    /// Value for the specular amplitude k_s.
    pub k_s: T,
    /// Value for the specular exponent s.
    pub s: T,
    /// Value for the lobe blend α.
    pub alpha: T,
    /// Value for the relative index of refraction η.
    pub eta: T,
}

impl<T> PerParam<T> {
    /// Values made from the row of each parameter in [`ALL`], in that order.
    pub fn from_rows(mut of: impl FnMut(&Param) -> T) -> Self {
        Self {
            rho_d: of(&RHO_D),
            k_s: of(&K_S),
            s: of(&S),
            alpha: of(&ALPHA),
            eta: of(&ETA),
        }
    }
}

impl<T> Index<ParamId> for PerParam<T> {
    type Output = T;

    fn index(&self, id: ParamId) -> &T {
        match id {
            ParamId::RhoD => &self.rho_d,
            ParamId::KS => &self.k_s,
            ParamId::S => &self.s,
            ParamId::Alpha => &self.alpha,
            ParamId::Eta => &self.eta,
        }
    }
}

impl<T> IndexMut<ParamId> for PerParam<T> {
    fn index_mut(&mut self, id: ParamId) -> &mut T {
        match id {
            ParamId::RhoD => &mut self.rho_d,
            ParamId::KS => &mut self.k_s,
            ParamId::S => &mut self.s,
            ParamId::Alpha => &mut self.alpha,
            ParamId::Eta => &mut self.eta,
        }
    }
}

/// Scale of a slider: how values are spread along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Linear.
    Linear,
    /// Logarithmic, down to the given decade, with 0 at the end where the range starts at 0.
    Log {
        /// log10 of the smallest positive value on the slider.
        smallest_exponent: i32,
    },
}

/// Properties of a parameter: names, unit, range, default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// Identity of the parameter.
    pub id: ParamId,
    /// Name in files and on the command line, e.g. "k_s".
    pub key: &'static str,
    /// Symbol, in the markup of [`crate::figure::text`].
    pub symbol: &'static str,
    /// Display name, e.g. "specular amplitude".
    pub name: &'static str,
    /// Unit, e.g. "1/sr"; empty where there is none.
    pub unit: &'static str,
    /// Range of the slider, (smallest, largest).
    pub range: (f64, f64),
    /// Range of accepted values when typed or read, (smallest, largest).
    pub domain: (f64, f64),
    /// Default value, which a reset restores.
    pub default: f64,
    /// Scale of the slider.
    pub scale: Scale,
    /// Description in one sentence.
    pub help: &'static str,
}

impl Param {
    /// Nearest accepted value; the default in place of NaN.
    pub fn clamp(&self, value: f64) -> f64 {
        if value.is_nan() {
            self.default
        } else {
            value.clamp(self.domain.0, self.domain.1)
        }
    }

    /// Whether a value is finite and within the domain.
    pub fn accepts(&self, value: f64) -> bool {
        value.is_finite() && (self.domain.0..=self.domain.1).contains(&value)
    }
}

/// Row of the diffuse reflectance ρ_d.
pub const RHO_D: Param = Param {
    id: ParamId::RhoD,
    key: "rho_d",
    symbol: "ρ_{d}",
    name: "diffuse reflectance",
    unit: "",
    range: (0.0, 1.0),
    domain: (0.0, 1e6),
    default: 0.2,
    scale: Scale::Linear,
    help: "Share of the light that is scattered evenly in all directions.",
};

/// Row of the specular amplitude k_s.
pub const K_S: Param = Param {
    id: ParamId::KS,
    key: "k_s",
    symbol: "k_{s}",
    name: "specular amplitude",
    unit: "1/sr",
    range: (0.0, 1e5),
    domain: (0.0, 1e12),
    default: 1.0,
    scale: Scale::Log {
        smallest_exponent: -4,
    },
    help: "Height of the specular lobe before the Fresnel factor.",
};

/// Row of the specular exponent s.
pub const S: Param = Param {
    id: ParamId::S,
    key: "s",
    symbol: "s",
    name: "specular exponent",
    unit: "",
    range: (0.01, 1e5),
    domain: (1e-3, 1e7),
    default: 50.0,
    scale: Scale::Log {
        smallest_exponent: -2,
    },
    help: "Shininess: the larger, the narrower the highlight.",
};

/// Row of the lobe blend α.
pub const ALPHA: Param = Param {
    id: ParamId::Alpha,
    key: "alpha",
    symbol: "α",
    name: "lobe blend",
    unit: "",
    range: (0.0, 1.0),
    domain: (0.0, 1.0),
    default: 0.5,
    scale: Scale::Linear,
    help: "0 is Phong, 1 is Blinn-Phong with the exponent 4s.",
};

/// Row of the relative index of refraction η.
pub const ETA: Param = Param {
    id: ParamId::Eta,
    key: "eta",
    symbol: "η",
    name: "index of refraction",
    unit: "",
    range: (1.0, 4.0),
    domain: (1.0, 1e3),
    default: 1.5,
    scale: Scale::Linear,
    help: "Relative index of refraction in the Fresnel factor: the smaller, the steeper the rise towards grazing.",
};

/// Rows of all parameters of all models, in the order of the uniform on the GPU.
pub const ALL: [Param; 5] = [RHO_D, K_S, S, ALPHA, ETA];
