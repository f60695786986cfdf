//! What is fitted and how: weight, grazing limit, stages, what is free.

use crate::brdf::{Brdf, Fresnel, MODELS, Model, Param, ParamId, Params};
use crate::geom::Rgb;
use crate::keys;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// How much a cell counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weight {
    /// Every cell the same.
    Cells,
    /// dωi dωo = 4 cos θd dωh dωd.
    SolidAngle,
    /// The solid angle times cos θi cos θo: E is the share of reflected energy that is misplaced under uniform light.
    #[default]
    Cosine,
}

/// All weights in the order offered.
pub const WEIGHTS: [Weight; 3] = [Weight::Cells, Weight::SolidAngle, Weight::Cosine];

impl Weight {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cells => "Cells",
            Self::SolidAngle => "Solid angle",
            Self::Cosine => "Cosine",
        }
    }

    /// One sentence for people.
    pub fn help(self) -> &'static str {
        match self {
            Self::Cells => {
                "Every measured cell counts the same; a few huge values at the horizon decide."
            }
            Self::SolidAngle => {
                "A cell counts as much as the solid angles of light and view that it covers."
            }
            Self::Cosine => {
                "Solid angle times both cosines: E is the share of reflected energy that is misplaced under uniform light."
            }
        }
    }

    /// The weight whose `key` this is.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }
}

/// A step of the staged fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// 1: ρ_d and k_s for fixed s, α, η; exact [Nielsen14].
    Amplitudes,
    /// 2: s, α and η for fixed ρ_d and k_s [Nielsen14].
    Shape,
    /// 3: s, α, k_s and η for fixed ρ_d [Nielsen14].
    ShapeAndSpecular,
    /// 4: all parameters together, from several starts.
    Joint,
}

/// All stages in order.
pub const STAGES: [Stage; 4] = [
    Stage::Amplitudes,
    Stage::Shape,
    Stage::ShapeAndSpecular,
    Stage::Joint,
];

impl Stage {
    /// 1 to 4, as in the poster and then one more.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// The stage of this number.
    pub fn by_number(number: usize) -> Option<Self> {
        STAGES.into_iter().find(|stage| stage.number() == number)
    }

    /// What it moves, in the markup of [`crate::figure::text`].
    pub fn symbols(self) -> &'static str {
        match self {
            Self::Amplitudes => "ρ_{d}, k_{s}",
            Self::Shape => "s, α, η",
            Self::ShapeAndSpecular => "s, α, η, k_{s}",
            Self::Joint => "all",
        }
    }

    /// Whether the stage may move a parameter.
    pub fn moves(self, id: ParamId) -> bool {
        match self {
            Self::Amplitudes => id.is_color(),
            Self::Shape => !id.is_color(),
            Self::ShapeAndSpecular => id != ParamId::RhoD,
            Self::Joint => true,
        }
    }
}

/// A model with its Fresnel factor: what is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The formula.
    pub model: &'static Model,
    /// The factor on its specular term.
    pub fresnel: Fresnel,
}

impl Variant {
    /// Every model without a Fresnel factor and with this one: six variants; three for [`Fresnel::None`].
    pub fn all(fresnel: Fresnel) -> Vec<Self> {
        let mut fresnels = vec![Fresnel::None, fresnel];
        fresnels.dedup();
        let of = |fresnel| MODELS.map(|model| Self { model, fresnel });
        fresnels.into_iter().flat_map(of).collect()
    }

    /// The variant with these numbers.
    pub fn with(self, params: Params) -> Brdf {
        Brdf {
            model: self.model,
            fresnel: self.fresnel,
            params,
        }
    }
}

impl From<&Brdf> for Variant {
    fn from(brdf: &Brdf) -> Self {
        Self {
            model: brdf.model,
            fresnel: brdf.fresnel,
        }
    }
}

/// Values for some of the parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Partial {
    /// ρ_d
    pub rho_d: Option<Rgb>,
    /// k_s
    pub k_s: Option<Rgb>,
    /// s, as the fitted model means it
    pub s: Option<f64>,
    /// α
    pub alpha: Option<f64>,
    /// η
    pub eta: Option<f64>,
}

impl Partial {
    /// Whether there is a value for the parameter.
    pub fn has(&self, id: ParamId) -> bool {
        match id {
            ParamId::RhoD => self.rho_d.is_some(),
            ParamId::KS => self.k_s.is_some(),
            ParamId::S => self.s.is_some(),
            ParamId::Alpha => self.alpha.is_some(),
            ParamId::Eta => self.eta.is_some(),
        }
    }

    /// Takes the value of one parameter.
    pub fn set(&mut self, id: ParamId, from: &Params) {
        match id {
            ParamId::RhoD => self.rho_d = Some(from.rho_d),
            ParamId::KS => self.k_s = Some(from.k_s),
            ParamId::S => self.s = Some(from.s),
            ParamId::Alpha => self.alpha = Some(from.alpha),
            ParamId::Eta => self.eta = Some(from.eta),
        }
    }

    /// `params` with the values that are here.
    pub fn over(&self, mut params: Params) -> Params {
        params.rho_d = self.rho_d.unwrap_or(params.rho_d);
        params.k_s = self.k_s.unwrap_or(params.k_s);
        params.s = self.s.unwrap_or(params.s);
        params.alpha = self.alpha.unwrap_or(params.alpha);
        params.eta = self.eta.unwrap_or(params.eta);
        params
    }
}

/// How near η may come to 1, where R_F vanishes but at grazing.
pub const SMALLEST_ETA: f64 = 1.0001;

/// The bounds that a fit keeps where the user sets none: the slider's range of s and α, all that is accepted else.
pub fn default_bounds(row: &Param) -> (f64, f64) {
    match row.id {
        ParamId::RhoD | ParamId::KS => row.domain,
        ParamId::S | ParamId::Alpha => row.range,
        ParamId::Eta => (SMALLEST_ETA, row.domain.1),
    }
}

/// How to fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Which stages are run, in order; by position in [`STAGES`].
    pub stages: [bool; 4],
    /// Parameters that the user holds fixed, with their values.
    pub held: Partial,
    /// Where the stages begin instead of at what the data say. Stage 4 tries the data's starts as well.
    pub start: Partial,
    /// Bounds by position in [`crate::brdf::params::ALL`]; [`default_bounds`] where `None`.
    pub bounds: [Option<(f64, f64)>; 5],
}

impl Default for Options {
    /// All stages, everything free.
    fn default() -> Self {
        Self {
            stages: [true; 4],
            held: Partial::default(),
            start: Partial::default(),
            bounds: [None; 5],
        }
    }
}

impl Options {
    /// Whether a stage is run.
    pub fn runs(&self, stage: Stage) -> bool {
        self.stages[stage.number() - 1]
    }

    /// The bounds of a parameter of a model.
    pub fn bounds_of(&self, row: &Param) -> (f64, f64) {
        let set = crate::brdf::params::ALL
            .iter()
            .position(|other| other.id == row.id)
            .and_then(|index| self.bounds[index]);
        set.unwrap_or_else(|| default_bounds(row))
    }
}

/// The grazing limit that leaves nothing out, in radians.
pub const NO_LIMIT: f64 = FRAC_PI_2;
