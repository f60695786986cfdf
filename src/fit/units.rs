//! Between the parameters of a model and the amplitudes that passes work with.

use super::passes::Amplitudes;
use crate::brdf::Params;
use std::f64::consts::PI;

/// What an amplitude of 1 is in each parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// In ρ_d.
    pub rho_d: f64,
    /// In k_s.
    pub k_s: f64,
}

impl Units {
    /// For values in units of `scale`, see [`super::sites::Sites::scale`].
    pub fn new(scale: f64) -> Self {
        Self {
            rho_d: PI * scale,
            k_s: scale,
        }
    }

    /// The amplitudes of a model.
    pub fn amplitudes(&self, params: &Params) -> Amplitudes {
        Amplitudes {
            diffuse: params.rho_d.map(|rho_d| rho_d / self.rho_d),
            specular: params.k_s.map(|k_s| k_s / self.k_s),
        }
    }

    /// Parameters with these amplitudes.
    pub fn with(&self, amplitudes: &Amplitudes, params: Params) -> Params {
        Params {
            rho_d: amplitudes.diffuse.map(|a| a * self.rho_d),
            k_s: amplitudes.specular.map(|b| b * self.k_s),
            ..params
        }
    }
}
