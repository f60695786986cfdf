//! Descriptions of models, and a BRDF: a model with its parameter values.

use super::fresnel::Fresnel;
use super::params::{Param, ParamId, Params};
use crate::geom::{Cosines, Rgb};
use glam::DVec3;
use std::f64::consts::PI;

/// A reflection model of the Phong family: its specular lobe, its parameters, and its texts for people.
#[derive(Debug)]
pub struct Model {
    /// Name in files and on the command line, e.g. "blinn-phong".
    pub key: &'static str,
    /// Display name, e.g. "Blinn-Phong".
    pub name: &'static str,
    /// Source of the formula, e.g. "[Nielsen14] after [AkenineMoller08]".
    pub source: &'static str,
    /// Formula of the lobe, in the markup of [`crate::figure::text`].
    pub formula: &'static str,
    /// Parameters of the model, in the order of its sliders.
    pub params: &'static [Param],
    /// Specular lobe, at most 1, without amplitude or Fresnel factor.
    pub lobe: fn(&Params, &Cosines) -> f64,
    /// WGSL twin of `lobe`: text that defines `fn lobe_<key with _ for ->(p: Params, c: Cosines) -> f32`.
    pub wgsl: &'static str,
    /// k_s / ρ_s of the normalised form as a function of s; `None` where the source gives no normalisation.
    pub normalization: Option<fn(f64) -> f64>,
    /// Exponent s of this model that gives the same highlight at normal incidence as Phong's s = 1.
    pub exponent_ratio: f64,
    /// α at which the combined model equals this one; `None` where α is a parameter itself.
    pub alpha: Option<f64>,
}

impl Eq for Model {}

impl PartialEq for Model {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

impl Model {
    /// Row of a parameter; `None` where the model does not have it.
    pub fn param(&self, id: ParamId) -> Option<&'static Param> {
        self.params.iter().find(|param| param.id == id)
    }
}

/// A model with its Fresnel factor and parameter values: a BRDF that can be evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Brdf {
    /// Reflection model.
    pub model: &'static Model,
    /// Fresnel factor on the specular term.
    pub fresnel: Fresnel,
    /// Parameter values. Those that the model does not have are kept and unused.
    pub params: Params,
}

impl Brdf {
    /// f_r in 1/sr, linear RGB. Cosines are clamped at 0 before use; below the horizon the formula continues, so use
    /// [`Brdf::f_r`] where that matters.
    pub fn eval(&self, c: &Cosines) -> Rgb {
        let shape = self.specular_shape(c);
        std::array::from_fn(|k| self.params.rho_d[k] / PI + self.params.k_s[k] * shape)
    }

    /// f_r of (wi, wo) in 1/sr, linear RGB; `None` below the horizon of either.
    pub fn f_r(&self, wi: DVec3, wo: DVec3) -> Option<Rgb> {
        let cosines = Cosines::from_directions(wi, wo);
        cosines.above_horizon().then(|| self.eval(&cosines))
    }

    /// Specular term for k_s = 1: R_F · lobe.
    pub fn specular_shape(&self, c: &Cosines) -> f64 {
        self.fresnel.reflectance(c.wi_dot_wh, self.params.eta) * (self.model.lobe)(&self.params, c)
    }

    /// Whether changing a parameter changes the BRDF: the model has it, and η only matters with a Fresnel factor.
    pub fn uses(&self, id: ParamId) -> bool {
        self.model.param(id).is_some() && (id != ParamId::Eta || self.fresnel != Fresnel::None)
    }

    /// ρ_s of the normalised form with this k_s, per channel; `None` where the model has no normalised form.
    pub fn rho_s(&self) -> Option<Rgb> {
        let factor = (self.model.normalization?)(self.params.s);
        Some(self.params.k_s.map(|k| k / factor))
    }

    /// k_s · R_F(0) in 1/sr, the specular amplitude at normal incidence; as η → 1 only this product is determined.
    pub fn specular_at_normal(&self) -> Rgb {
        let r0 = self.fresnel.reflectance(1.0, self.params.eta);
        self.params.k_s.map(|k| k * r0)
    }

    /// BRDF of another model that looks alike, exactly where one model contains the other: Phong is the combined model
    /// with α = 0, Blinn-Phong with exponent 4s is the one with α = 1. Elsewhere the highlight at normal incidence is
    /// kept.
    pub fn with_model(&self, model: &'static Model) -> Self {
        let mut params = self.params;
        params.s *= model.exponent_ratio / self.model.exponent_ratio;
        if let Some(row) = model.param(ParamId::S) {
            params.s = row.clamp(params.s);
        }
        if let (Some(alpha), None) = (self.model.alpha, model.alpha) {
            params.alpha = alpha;
        }
        Self {
            model,
            params,
            ..*self
        }
    }
}
