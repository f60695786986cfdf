//! Options of a fit: variant, weight, stages, held values, start and bounds.

use super::stages::{Stage, StageSet};
use crate::brdf::{Brdf, Fresnel, MODELS, Model, Param, ParamId, Params, PerParam};
use crate::geom::Rgb;
use crate::keys;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// Weight of a cell in the error E.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weight {
    /// 1 for every cell.
    Cells,
    /// Solid angle dωi dωo = 4 cos θd dωh dωd of the cell.
    SolidAngle,
    /// Solid angle times cos θi cos θo: E is the share of reflected energy that is misplaced under uniform light.
    #[default]
    Cosine,
}

/// All weights in the order in which they are offered.
pub const WEIGHTS: [Weight; 3] = [Weight::Cells, Weight::SolidAngle, Weight::Cosine];

impl Weight {
    /// Name in files and on the command line, e.g. "solid-angle".
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Display name, e.g. "Solid angle".
    pub fn name(self) -> &'static str {
        match self {
            Self::Cells => "Cells",
            Self::SolidAngle => "Solid angle",
            Self::Cosine => "Cosine",
        }
    }

    /// Description in one sentence.
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

    /// The weight with this `key`.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }
}

/// Model and Fresnel factor whose parameters are fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// Reflection model.
    pub model: &'static Model,
    /// Fresnel factor on the specular term.
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

    /// BRDF of the variant with these parameters.
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

/// Values of some of the parameters; `None` for the others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Partial {
    /// Diffuse reflectance ρ_d, linear RGB.
    pub rho_d: Option<Rgb>,
    /// Specular amplitude k_s in 1/sr, linear RGB.
    pub k_s: Option<Rgb>,
    /// Specular exponent s of the fitted model.
    pub s: Option<f64>,
    /// Lobe blend α.
    pub alpha: Option<f64>,
    /// Relative index of refraction η.
    pub eta: Option<f64>,
}

impl Partial {
    /// Whether a parameter has a value.
    pub fn has(&self, id: ParamId) -> bool {
        match id {
            ParamId::RhoD => self.rho_d.is_some(),
            ParamId::KS => self.k_s.is_some(),
            ParamId::S => self.s.is_some(),
            ParamId::Alpha => self.alpha.is_some(),
            ParamId::Eta => self.eta.is_some(),
        }
    }

    /// Sets a parameter to its value in `from`.
    pub fn set(&mut self, id: ParamId, from: &Params) {
        match id {
            ParamId::RhoD => self.rho_d = Some(from.rho_d),
            ParamId::KS => self.k_s = Some(from.k_s),
            ParamId::S => self.s = Some(from.s),
            ParamId::Alpha => self.alpha = Some(from.alpha),
            ParamId::Eta => self.eta = Some(from.eta),
        }
    }

    /// `params` with the values that are present replaced.
    pub fn over(&self, mut params: Params) -> Params {
        params.rho_d = self.rho_d.unwrap_or(params.rho_d);
        params.k_s = self.k_s.unwrap_or(params.k_s);
        params.s = self.s.unwrap_or(params.s);
        params.alpha = self.alpha.unwrap_or(params.alpha);
        params.eta = self.eta.unwrap_or(params.eta);
        params
    }
}

/// Smallest η of a fit. At 1, R_F vanishes but at grazing.
pub const SMALLEST_ETA: f64 = 1.0001;

/// Bounds of a fit where the user sets none: the slider's range for s and α, the domain for the others, with η at least
/// [`SMALLEST_ETA`].
pub fn default_bounds(row: &Param) -> Bounds {
    match row.id {
        ParamId::RhoD | ParamId::KS => row.domain,
        ParamId::S | ParamId::Alpha => row.range,
        ParamId::Eta => (SMALLEST_ETA, row.domain.1),
    }
}

/// Bounds of a parameter, (smallest, largest).
pub type Bounds = (f64, f64);

/// Options of a fit: stages, held values, start, bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// Stages that are run.
    pub stages: StageSet,
    /// Values of the parameters that are held fixed.
    pub held: Partial,
    /// Values at which stage 1 starts instead of those that the data suggest. Stage 4 tries the data's starts as well.
    pub start: Partial,
    /// Bounds of the parameters; [`default_bounds`] where `None`.
    pub bounds: PerParam<Option<Bounds>>,
}

impl Default for FitOptions {
    /// All stages, with every parameter free within its default bounds.
    fn default() -> Self {
        Self {
            stages: StageSet::ALL,
            held: Partial::default(),
            start: Partial::default(),
            bounds: PerParam::default(),
        }
    }
}

impl FitOptions {
    /// Whether a stage is run.
    pub fn runs(&self, stage: Stage) -> bool {
        self.stages[stage]
    }

    /// Bounds of a parameter of a model: those set, else the default ones.
    pub fn bounds_of(&self, row: &Param) -> Bounds {
        self.bounds[row.id].unwrap_or_else(|| default_bounds(row))
    }
}

/// Grazing limit that leaves no direction out, in radians.
pub const NO_LIMIT: f64 = FRAC_PI_2;
