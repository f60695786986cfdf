//! Amplitudes ρ_d/π and k_s per channel in the units of the fit: values, bounds, and conversion to the parameters of a
//! model.

use crate::brdf::Params;
use std::f64::consts::PI;

/// Amplitudes ρ_d/π and k_s per channel, in units of `SymmetricCells::scale`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplitudes {
    /// ρ_d/π per channel.
    pub diffuse: [f64; 3],
    /// k_s per channel.
    pub specular: [f64; 3],
}

impl Amplitudes {
    /// Amplitudes [ρ_d/π, k_s] of a channel.
    #[inline(always)]
    pub fn of(&self, channel: usize) -> [f64; 2] {
        [self.diffuse[channel], self.specular[channel]]
    }
}

/// Bounds of the amplitudes in units of `SymmetricCells::scale`, (smallest, largest); the same for all channels unless
/// held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplitudeBounds {
    /// Bounds of ρ_d/π per channel.
    pub diffuse: [(f64, f64); 3],
    /// Bounds of k_s per channel.
    pub specular: [(f64, f64); 3],
}

impl AmplitudeBounds {
    /// Bounds that hold the amplitudes fixed: both ends alike.
    pub fn holding(amplitudes: &Amplitudes) -> Self {
        Self {
            diffuse: amplitudes.diffuse.map(|a| (a, a)),
            specular: amplitudes.specular.map(|b| (b, b)),
        }
    }

    /// Bounds of [ρ_d/π, k_s] of a channel.
    pub fn of(&self, channel: usize) -> [(f64, f64); 2] {
        [self.diffuse[channel], self.specular[channel]]
    }

    /// The nearest amplitudes within the bounds.
    pub fn clamp(&self, mut amplitudes: Amplitudes) -> Amplitudes {
        for channel in 0..3 {
            let [a, b] = self.of(channel);
            amplitudes.diffuse[channel] = amplitudes.diffuse[channel].clamp(a.0, a.1);
            amplitudes.specular[channel] = amplitudes.specular[channel].clamp(b.0, b.1);
        }
        amplitudes
    }
}

/// Units of the amplitudes: the parameter values of an amplitude of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplitudeUnits {
    /// ρ_d at a diffuse amplitude of 1.
    pub rho_d: f64,
    /// k_s in 1/sr at a specular amplitude of 1.
    pub k_s: f64,
}

impl AmplitudeUnits {
    /// Units for amplitudes in units of `scale`, see `SymmetricCells::scale`.
    pub fn new(scale: f64) -> Self {
        Self {
            rho_d: PI * scale,
            k_s: scale,
        }
    }

    /// Amplitudes of a model's parameters.
    pub fn amplitudes(&self, params: &Params) -> Amplitudes {
        Amplitudes {
            diffuse: params.rho_d.map(|rho_d| rho_d / self.rho_d),
            specular: params.k_s.map(|k_s| k_s / self.k_s),
        }
    }

    /// Parameters with ρ_d and k_s replaced by these amplitudes.
    pub fn with(&self, amplitudes: &Amplitudes, params: Params) -> Params {
        Params {
            rho_d: amplitudes.diffuse.map(|a| a * self.rho_d),
            k_s: amplitudes.specular.map(|b| b * self.k_s),
            ..params
        }
    }
}
