//! Descriptions of models, and a BRDF: a model with its parameter values.

use super::along_phi_d::AlongPhiD;
use super::fresnel::Fresnel;
use super::params::{self, LobeValues, Param, ParamId, Params};
use crate::geom::{Cosines, Rgb};
use glam::DVec3;
use std::f64::consts::PI;

/// A reflection model: its specular lobe, the parameters of that, and its texts for people.
///
/// ρ_d, k_s and η belong to every [`Brdf`] and are not listed here.
#[derive(Debug)]
pub struct Model {
    /// Name in files and on the command line, e.g. "blinn-phong".
    pub key: &'static str,
    /// Display name, e.g. "Blinn-Phong".
    pub name: &'static str,
    /// Name before "model" in a sentence, e.g. "combined".
    pub word: &'static str,
    /// Source of the formula, e.g. "[Nielsen14] after [AkenineMoller08]".
    pub source: &'static str,
    /// Formula of the lobe, in the markup of [`crate::figure::text`].
    pub formula: &'static str,
    /// Parameters of the lobe in the order of their sliders; the first sets the width of the highlight.
    pub params: &'static [Param],
    /// Specular lobe without amplitude or Fresnel factor; finite for any cosines and any values in the domains.
    pub lobe: fn(&LobeValues, &Cosines) -> f64,
    /// WGSL twin of `lobe`: text that defines `fn lobe_<key with _ for ->(<an f32 per parameter>, c: Cosines) -> f32`.
    pub wgsl: &'static str,
    /// k_s / ρ_s of the normalised form; `None` where the source gives no normalisation.
    pub normalization: Option<fn(&LobeValues) -> f64>,
    /// How the lobe varies along φd, which is what makes a fit fast.
    pub along_phi_d: AlongPhiD,
    /// Models that this one equals at some value of its last parameters.
    pub contains: &'static [Contained],
}

/// A model that another one contains.
#[derive(Debug)]
pub struct Contained {
    /// The contained model.
    pub model: &'static Model,
    /// Values of the containing model's first parameters as multiples of those of the contained one, one for each of
    /// these.
    pub factors: &'static [f64],
    /// Values of the other parameters of the containing model.
    pub fixed: &'static [f64],
}

impl Contained {
    /// Values of the containing model that equal those of the contained one.
    pub fn outer(&self, inner: &LobeValues) -> LobeValues {
        let mut outer = LobeValues::default();
        let scaled = self.factors.iter().zip(inner).map(|(factor, x)| factor * x);
        let all = scaled.chain(self.fixed.iter().copied());
        outer.iter_mut().zip(all).for_each(|(to, from)| *to = from);
        outer
    }

    /// Values of the contained model from the parameters that both share.
    pub fn inner(&self, outer: &LobeValues) -> LobeValues {
        let mut inner = LobeValues::default();
        for ((to, from), factor) in inner.iter_mut().zip(outer).zip(self.factors) {
            *to = from / factor;
        }
        inner
    }
}

impl Eq for Model {}

impl PartialEq for Model {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

impl Model {
    /// Rows of all parameters of a BRDF of this model: ρ_d, k_s, those of the lobe, η.
    pub fn rows(&self) -> impl Iterator<Item = &'static Param> + Clone {
        let common = [&params::RHO_D, &params::K_S];
        let lobe = self.params.iter();
        common.into_iter().chain(lobe).chain([&params::ETA])
    }

    /// Row of a parameter; `None` where the model does not have it.
    pub fn param(&self, id: ParamId) -> Option<&'static Param> {
        self.rows().find(|row| row.id == id)
    }

    /// Position of a parameter of the lobe among its values; `None` for others.
    pub fn position(&self, id: ParamId) -> Option<usize> {
        self.params.iter().position(|row| row.id == id)
    }

    /// Default values of the lobe's parameters.
    pub fn default_lobe(&self) -> LobeValues {
        std::array::from_fn(|k| self.params.get(k).map_or(0.0, |row| row.default))
    }

    /// Default values of all parameters.
    pub fn default_params(&self) -> Params {
        Params {
            rho_d: [params::RHO_D.default; 3],
            k_s: [params::K_S.default; 3],
            lobe: self.default_lobe(),
            eta: params::ETA.default,
        }
    }

    /// Name of the lobe's function in WGSL.
    pub fn wgsl_name(&self) -> String {
        format!("lobe_{}", self.key.replace('-', "_"))
    }

    /// The relation to a model that this one contains.
    pub fn containing(&self, other: &Self) -> Option<&'static Contained> {
        self.contains.iter().find(|inner| inner.model == other)
    }
}

/// A model with its Fresnel factor and parameter values: a BRDF that can be evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Brdf {
    /// Reflection model.
    pub model: &'static Model,
    /// Fresnel factor on the specular term.
    pub fresnel: Fresnel,
    /// Parameter values. η is kept where no Fresnel factor needs it.
    pub params: Params,
}

impl Brdf {
    /// BRDF of a model with default parameters.
    pub fn new(model: &'static Model, fresnel: Fresnel) -> Self {
        Self {
            model,
            fresnel,
            params: model.default_params(),
        }
    }

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
        self.fresnel.reflectance(c.wi_wh.cos, self.params.eta) * self.lobe(c)
    }

    /// The lobe, without amplitude or Fresnel factor.
    pub fn lobe(&self, c: &Cosines) -> f64 {
        (self.model.lobe)(&self.params.lobe, c)
    }

    /// Whether changing a parameter changes the BRDF: the model has it, and η only matters with a Fresnel factor.
    pub fn uses(&self, id: ParamId) -> bool {
        self.model.param(id).is_some() && (id != ParamId::ETA || self.fresnel != Fresnel::None)
    }

    /// Rows of the parameters that count: all of the model's, η only with a Fresnel factor.
    pub fn used(&self) -> impl Iterator<Item = &'static Param> + Clone + use<> {
        let with_eta = self.fresnel != Fresnel::None;
        let rows = self.model.rows();
        rows.filter(move |row| with_eta || row.id != ParamId::ETA)
    }

    /// Values of a parameter: three for a colour, one otherwise; none where the model does not have it.
    pub fn get(&self, id: ParamId) -> &[f64] {
        match id {
            ParamId::RHO_D => &self.params.rho_d,
            ParamId::K_S => &self.params.k_s,
            ParamId::ETA => std::slice::from_ref(&self.params.eta),
            id => match self.model.position(id) {
                Some(k) => std::slice::from_ref(&self.params.lobe[k]),
                None => &[],
            },
        }
    }

    /// Mutable values of a parameter, as [`Brdf::get`] has them.
    pub fn get_mut(&mut self, id: ParamId) -> &mut [f64] {
        match id {
            ParamId::RHO_D => &mut self.params.rho_d,
            ParamId::K_S => &mut self.params.k_s,
            ParamId::ETA => std::slice::from_mut(&mut self.params.eta),
            id => match self.model.position(id) {
                Some(k) => std::slice::from_mut(&mut self.params.lobe[k]),
                None => &mut [],
            },
        }
    }

    /// Value of a parameter that the channels share; `None` for a colour and where the model does not have it.
    pub fn number(&self, id: ParamId) -> Option<f64> {
        match self.get(id) {
            [one] => Some(*one),
            _ => None,
        }
    }

    /// ρ_s of the normalised form with this k_s, per channel; `None` where the model has no normalised form.
    pub fn rho_s(&self) -> Option<Rgb> {
        let factor = (self.model.normalization?)(&self.params.lobe);
        Some(self.params.k_s.map(|k| k / factor))
    }

    /// k_s · R_F(0), what the lobe is multiplied with at normal incidence; as η → 1 only this product is determined.
    pub fn specular_at_normal(&self) -> Rgb {
        let r0 = self.fresnel.reflectance(1.0, self.params.eta);
        self.params.k_s.map(|k| k * r0)
    }
}
