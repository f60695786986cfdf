//! ρ_d/π and k_s per channel as the fit counts them: values, bounds, and the way to the parameters of a model.

use crate::brdf::Params;
use std::f64::consts::PI;

/// Diffuse and specular amplitudes per channel, in units of [`SymmetricCells::scale`]: ρ_d/π and k_s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplitudes {
    /// ρ_d/π
    pub diffuse: [f64; 3],
    /// k_s
    pub specular: [f64; 3],
}

impl Amplitudes {
    /// Both of a channel.
    #[inline(always)]
    pub fn of(&self, channel: usize) -> [f64; 2] {
        [self.diffuse[channel], self.specular[channel]]
    }
}

/// Bounds of the amplitudes in units of [`SymmetricCells::scale`], the same for all channels unless held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplitudeBounds {
    /// Of ρ_d/π per channel.
    pub diffuse: [(f64, f64); 3],
    /// Of k_s per channel.
    pub specular: [(f64, f64); 3],
}

impl AmplitudeBounds {
    /// No room at all.
    pub fn holding(amplitudes: &Amplitudes) -> Self {
        Self {
            diffuse: amplitudes.diffuse.map(|a| (a, a)),
            specular: amplitudes.specular.map(|b| (b, b)),
        }
    }

    /// The bounds of a and b of a channel.
    pub fn of(&self, channel: usize) -> [(f64, f64); 2] {
        [self.diffuse[channel], self.specular[channel]]
    }

    /// The nearest amplitudes within.
    pub fn clamp(&self, mut amplitudes: Amplitudes) -> Amplitudes {
        for channel in 0..3 {
            let [a, b] = self.of(channel);
            amplitudes.diffuse[channel] = amplitudes.diffuse[channel].clamp(a.0, a.1);
            amplitudes.specular[channel] = amplitudes.specular[channel].clamp(b.0, b.1);
        }
        amplitudes
    }
}

/// What an amplitude of 1 is in each parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplitudeUnits {
    /// In ρ_d.
    pub rho_d: f64,
    /// In k_s.
    pub k_s: f64,
}

impl AmplitudeUnits {
    /// For values in units of `scale`, see [`super::symmetric_cells::SymmetricCells::scale`].
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
