//! Parameters of a BRDF: their values, and a row of properties for each.
//!
//! ρ_d, k_s and η belong to every BRDF and have their rows here; the parameters of a lobe belong to its model.

use crate::geom::Rgb;

/// Largest number of parameters of a lobe.
pub const MOST_LOBE_PARAMS: usize = 4;

/// Values of a lobe's parameters in the order of [`super::Model::params`]; 0 beyond them.
pub type LobeValues = [f64; MOST_LOBE_PARAMS];

/// Values of the first parameters of a lobe; 0 for the others.
pub fn lobe_values<const N: usize>(first: [f64; N]) -> LobeValues {
    std::array::from_fn(|k| first.get(k).copied().unwrap_or(0.0))
}

/// Parameter values of a BRDF. ρ_d and k_s are linear RGB; the others are shared by the channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Diffuse reflectance ρ_d, ≥ 0.
    pub rho_d: Rgb,
    /// Specular amplitude k_s, ≥ 0: what the lobe is multiplied with; in 1/sr where the lobe has no unit.
    pub k_s: Rgb,
    /// Values of the lobe's parameters.
    pub lobe: LobeValues,
    /// Relative index of refraction η, ≥ 1.
    pub eta: f64,
}

/// Identity of a parameter: its name in files, on the command line and in shaders, e.g. "k_s".
///
/// Models share an identity where their parameters mean the same, as `s` is a specular exponent in each that has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParamId(pub &'static str);

impl ParamId {
    /// Diffuse reflectance ρ_d.
    pub const RHO_D: Self = Self("rho_d");
    /// Specular amplitude k_s.
    pub const K_S: Self = Self("k_s");
    /// Relative index of refraction η.
    pub const ETA: Self = Self("eta");

    /// Whether the parameter has a value per channel: ρ_d and k_s.
    pub fn is_color(self) -> bool {
        self == Self::RHO_D || self == Self::K_S
    }

    /// Name of the parameter in files and shaders.
    pub fn key(self) -> &'static str {
        self.0
    }
}

/// Scale of a parameter: how values are spread along its slider and in the search of a fit.
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

/// Properties of a parameter: names, unit, ranges, default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// Identity of the parameter.
    pub id: ParamId,
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
    /// Bounds of a fit where the user sets none, (smallest, largest).
    pub bounds: (f64, f64),
    /// Meaning of a fit that ends at the smaller and at the larger of these bounds.
    pub at_bounds: [AtBound; 2],
    /// Values at which a fit looks for starts.
    pub starts: Starts,
    /// Default value, which a reset restores.
    pub default: f64,
    /// Scale of the slider and of the search.
    pub scale: Scale,
    /// Description in one sentence.
    pub help: &'static str,
}

/// Values of a parameter at which a fit looks for starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Starts {
    /// So many per decade of the slider's range, which is above 0.
    PerDecade(f64),
    /// These.
    At(&'static [f64]),
}

/// Meaning of an end of a fit at a default bound of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtBound {
    /// The best may lie beyond.
    Unknown,
    /// Nothing to remark: the bound is a value like any other.
    Fine,
    /// Explanation in one sentence, in plain characters.
    Means(&'static str),
}

impl Param {
    /// Name in files, on the command line and in shaders.
    pub fn key(&self) -> &'static str {
        self.id.key()
    }

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
pub static RHO_D: Param = Param {
    id: ParamId::RHO_D,
    symbol: "ρ_{d}",
    name: "diffuse reflectance",
    unit: "",
    range: (0.0, 1.0),
    domain: (0.0, 1e6),
    bounds: (0.0, 1e6),
    at_bounds: [AtBound::Fine; 2],
    starts: Starts::At(&[]),
    default: 0.2,
    scale: Scale::Linear,
    help: "Share of the light that is scattered evenly in all directions.",
};

/// Row of the specular amplitude k_s.
pub static K_S: Param = Param {
    id: ParamId::K_S,
    symbol: "k_{s}",
    name: "specular amplitude",
    unit: "1/sr",
    range: (0.0, 1e5),
    domain: (0.0, 1e12),
    bounds: (0.0, 1e12),
    at_bounds: [AtBound::Fine; 2],
    starts: Starts::At(&[]),
    default: 1.0,
    scale: Scale::Log {
        smallest_exponent: -4,
    },
    help: "Height of the specular lobe before the Fresnel factor.",
};

/// Smallest η of a fit. At 1, R_F vanishes but at grazing.
pub const SMALLEST_ETA: f64 = 1.0001;

/// Row of the relative index of refraction η.
pub static ETA: Param = Param {
    id: ParamId::ETA,
    symbol: "η",
    name: "index of refraction",
    unit: "",
    range: (1.0, 4.0),
    domain: (1.0, 1e3),
    bounds: (SMALLEST_ETA, 1e3),
    // Near 1 a fit says so in words of its own, before it is at the bound.
    at_bounds: [AtBound::Fine, AtBound::Unknown],
    // A steep rise towards grazing, glass, hardly any rise.
    starts: Starts::At(&[1.12, 1.5, 4.0]),
    default: 1.5,
    scale: Scale::Linear,
    help: "Relative index of refraction in the Fresnel factor: the smaller, the steeper the rise towards grazing.",
};
