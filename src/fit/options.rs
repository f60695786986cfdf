//! Options of a fit: variant, weight, stages, held values, start and bounds.

use super::stages::{Stage, StageSet};
use crate::brdf::{Brdf, Fresnel, Model, Param, ParamId, Params};
use crate::geom::Rgb;
use crate::keys;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
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
    /// Models without a Fresnel factor and with this one: two variants a model; one for [`Fresnel::None`].
    pub fn of(models: &[&'static Model], fresnel: Fresnel) -> Vec<Self> {
        let mut fresnels = vec![Fresnel::None, fresnel];
        fresnels.dedup();
        let of = |fresnel| models.iter().map(move |model| Self { model, fresnel });
        fresnels.into_iter().flat_map(of).collect()
    }

    /// BRDF of the variant with default parameters.
    pub fn defaults(self) -> Brdf {
        Brdf::new(self.model, self.fresnel)
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

/// Values of some of the parameters, by their identities: those that a model does not have do not count for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Partial {
    /// Diffuse reflectance ρ_d, linear RGB.
    pub rho_d: Option<Rgb>,
    /// Specular amplitude k_s in 1/sr, linear RGB.
    pub k_s: Option<Rgb>,
    /// Parameters that the channels share: those of the lobe, and η.
    pub shared: BTreeMap<ParamId, f64>,
}

impl Partial {
    /// Values of no parameter.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Whether a parameter has a value.
    pub fn has(&self, id: ParamId) -> bool {
        !self.get(id).is_empty()
    }

    /// Values of a parameter: three for a colour, one otherwise; none where it has no value.
    pub fn get(&self, id: ParamId) -> &[f64] {
        match id {
            ParamId::RHO_D => self.rho_d.as_ref().map_or(&[], |rgb| &rgb[..]),
            ParamId::K_S => self.k_s.as_ref().map_or(&[], |rgb| &rgb[..]),
            id => self.shared.get(&id).map_or(&[], std::slice::from_ref),
        }
    }

    /// Value of a parameter that the channels share.
    pub fn number(&self, id: ParamId) -> Option<f64> {
        self.shared.get(&id).copied()
    }

    /// Sets a parameter to its value in `from`, if that has it.
    pub fn set(&mut self, id: ParamId, from: &Brdf) {
        match id {
            ParamId::RHO_D => self.rho_d = Some(from.params.rho_d),
            ParamId::K_S => self.k_s = Some(from.params.k_s),
            id => self.shared.extend(from.number(id).map(|value| (id, value))),
        }
    }

    /// `brdf` with the values that are present replaced.
    pub fn over(&self, mut brdf: Brdf) -> Brdf {
        for row in brdf.model.rows() {
            let values = self.get(row.id);
            if !values.is_empty() {
                brdf.get_mut(row.id).copy_from_slice(values);
            }
        }
        brdf
    }
}

/// Bounds of a parameter, (smallest, largest).
pub type Bounds = (f64, f64);

/// Options of a fit: stages, held values, start, bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Stages that are run.
    pub stages: StageSet,
    /// Values of the parameters that are held fixed.
    pub held: Partial,
    /// Values at which stage 1 starts instead of those that the data suggest. Stage 4 tries the data's starts as well.
    pub start: Partial,
    /// Bounds of parameters in place of those of their rows.
    pub bounds: BTreeMap<ParamId, Bounds>,
}

impl Default for FitOptions {
    /// All stages, with every parameter free within its default bounds.
    fn default() -> Self {
        Self {
            stages: StageSet::ALL,
            held: Partial::default(),
            start: Partial::default(),
            bounds: BTreeMap::new(),
        }
    }
}

impl FitOptions {
    /// Whether a stage is run.
    pub fn runs(&self, stage: Stage) -> bool {
        self.stages[stage]
    }

    /// Bounds of a parameter of a model: those set, else those of its row.
    pub fn bounds_of(&self, row: &Param) -> Bounds {
        self.bounds.get(&row.id).copied().unwrap_or(row.bounds)
    }
}

/// Grazing limit that leaves no direction out, in radians.
pub const NO_LIMIT: f64 = FRAC_PI_2;
