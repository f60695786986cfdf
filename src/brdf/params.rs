//! The parameters of the models as rows of a table.

use crate::geom::Rgb;

/// The numbers of a BRDF. ρ_d and k_s are linear RGB; s, α, η are shared by the channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Diffuse reflectance ρ_d, ≥ 0.
    pub rho_d: Rgb,
    /// Specular amplitude k_s in 1/sr, ≥ 0.
    pub k_s: Rgb,
    /// Specular exponent, > 0.
    pub s: f64,
    /// Weight of the Blinn-Phong cosine in the combined model, in [0, 1].
    pub alpha: f64,
    /// Relative index of refraction, ≥ 1.
    pub eta: f64,
}

impl Params {
    /// A parameter's values: three for a colour, one otherwise.
    pub fn get(&self, id: ParamId) -> &[f64] {
        match id {
            ParamId::RhoD => &self.rho_d,
            ParamId::KS => &self.k_s,
            ParamId::S => std::slice::from_ref(&self.s),
            ParamId::Alpha => std::slice::from_ref(&self.alpha),
            ParamId::Eta => std::slice::from_ref(&self.eta),
        }
    }

    /// The same, to be written.
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

/// Which parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ParamId {
    /// ρ_d
    RhoD,
    /// k_s
    KS,
    /// s
    S,
    /// α
    Alpha,
    /// η
    Eta,
}

impl ParamId {
    /// Whether the parameter has a value per channel.
    pub fn is_color(self) -> bool {
        matches!(self, Self::RhoD | Self::KS)
    }

    /// The key of the parameter in files and shaders.
    pub fn key(self) -> &'static str {
        ALL.iter()
            .find(|row| row.id == self)
            .map_or("", |row| row.key)
    }
}

/// How a slider divides its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Evenly in the logarithm, down to the given decade, with 0 at the end where the range starts at 0.
    Log {
        /// log10 of the smallest positive value on the slider.
        smallest_exponent: i32,
    },
}

/// One parameter: what it is called and what it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// Which one.
    pub id: ParamId,
    /// Name in files and on the command line.
    pub key: &'static str,
    /// The symbol, in the markup of [`crate::figure::text`].
    pub symbol: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Unit, empty where there is none.
    pub unit: &'static str,
    /// Ends of the slider.
    pub range: (f64, f64),
    /// What is accepted at all, when typed or read.
    pub domain: (f64, f64),
    /// Where a reset leads.
    pub default: f64,
    /// How the slider divides its way.
    pub scale: Scale,
    /// One sentence for people.
    pub help: &'static str,
}

impl Param {
    /// The nearest accepted value; the default in place of NaN.
    pub fn clamp(&self, value: f64) -> f64 {
        if value.is_nan() {
            self.default
        } else {
            value.clamp(self.domain.0, self.domain.1)
        }
    }

    /// Whether a value is accepted.
    pub fn accepts(&self, value: f64) -> bool {
        value.is_finite() && (self.domain.0..=self.domain.1).contains(&value)
    }
}

/// ρ_d
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

/// k_s
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

/// s
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

/// α
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

/// η
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

/// Every parameter that some model has; the order of the uniform on the GPU.
pub const ALL: [Param; 5] = [RHO_D, K_S, S, ALPHA, ETA];
