//! f_r of the synthetic materials: of scattering lobes and of the diffuse ground below the interface.
//!
//! All are even in φ_d about 90° and reciprocal. A lobe is a factor of (θ_h, θ_d), by channel, times a factor of
//! (cos θ_i, cos θ_o): whole rows of the grid share the first.

use crate::geom::Rgb;
use std::f64::consts::PI;

/// Complex index of refraction η + iκ, by channel.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    eta: Rgb,
    kappa: Rgb,
}

/// Gold at the wavelengths of red, green and blue.
pub const GOLD: Interface = Interface {
    eta: [0.143, 0.375, 1.442],
    kappa: [3.983, 2.386, 1.603],
};

/// Interface to a clear medium of index `eta`.
pub const fn dielectric(eta: f64) -> Interface {
    Interface {
        eta: [eta; 3],
        kappa: [0.0; 3],
    }
}

impl Interface {
    /// Fresnel reflectance of unpolarised light, by channel.
    pub fn reflectance(&self, cos_theta: f64) -> Rgb {
        let first = fresnel(cos_theta, self.eta[0], self.kappa[0]);
        let same = |k: usize| self.eta[k] == self.eta[0] && self.kappa[k] == self.kappa[0];
        std::array::from_fn(|k| {
            if same(k) {
                first
            } else {
                fresnel(cos_theta, self.eta[k], self.kappa[k])
            }
        })
    }
}

/// Distribution of facet slopes.
#[derive(Clone, Copy, Debug)]
pub enum SlopeDistribution {
    /// Beckmann: Gaussian [CookTorrance82].
    Beckmann,
    /// GGX, with long tails [Walter07].
    Ggx,
}

/// Scattering lobe of the surface.
#[derive(Clone, Copy, Debug)]
pub enum SurfaceLobe {
    /// Mirror facets with exact Fresnel reflectance and Smith's masking and shadowing, correlated by height
    /// [Walter07, Heitz14]. A function of wh: condensed at grazing angles.
    Facets {
        /// Distribution of the facets' slopes.
        slopes: SlopeDistribution,
        /// Roughness: width of the distribution.
        roughness: f64,
        /// Index of refraction of the facets.
        interface: Interface,
    },
    /// A clear surface (η = 1.5) that is rough on the scale of the wavelength only. It diffracts by the difference of
    /// the tangential components of wo and wr, whatever the angle of incidence [Krywonos11, Low12]: broad at grazing angles.
    Smooth {
        /// 1/e width of the Gaussian spectrum of the roughness, in tangential components.
        width: f64,
    },
    /// A thin layer of loose fibres above the surface: single scattering [HanrahanKrueger93] with the phase function
    /// of Henyey and Greenstein.
    Fibers {
        /// Mean cosine of the scattering angle; > 0 is forward.
        anisotropy: f64,
        /// Optical depth of the layer.
        depth: f64,
    },
}

impl SurfaceLobe {
    /// Factor of f_r in θ_h and θ_d (radians), by channel.
    pub fn of_angles(&self, theta_h: f64, theta_d: f64) -> Rgb {
        let cos_theta_d = theta_d.cos();
        match *self {
            Self::Facets {
                slopes,
                roughness,
                interface,
            } => {
                let facing = slopes.density(theta_h, roughness);
                interface.reflectance(cos_theta_d).map(|f| f * facing)
            }
            Self::Smooth { width } => {
                // |wi + wo| sin θ_h, the tangential part of wi + wo.
                let shift = 2.0 * cos_theta_d * theta_h.sin() / width;
                let spectrum = (-shift * shift).exp() / (PI * width * width);
                dielectric(1.5)
                    .reflectance(cos_theta_d)
                    .map(|f| f * spectrum)
            }
            Self::Fibers { anisotropy: g, .. } => {
                // Light goes along −wi and leaves along wo.
                let cos_scattering = -(2.0 * theta_d).cos();
                let phase =
                    (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * cos_scattering).powf(1.5));
                [phase; 3]
            }
        }
    }

    /// Factor of f_r in cos θ_i and cos θ_o, both > 0.
    pub fn of_cosines(&self, cos_theta_i: f64, cos_theta_o: f64) -> f64 {
        match *self {
            Self::Facets {
                slopes, roughness, ..
            } => {
                let hidden =
                    slopes.lambda(cos_theta_i, roughness) + slopes.lambda(cos_theta_o, roughness);
                1.0 / ((1.0 + hidden) * 4.0 * cos_theta_i * cos_theta_o)
            }
            Self::Smooth { .. } => 1.0,
            Self::Fibers { depth, .. } => {
                let path = 1.0 / cos_theta_i + 1.0 / cos_theta_o;
                -(-depth * path).exp_m1() / (cos_theta_i + cos_theta_o)
            }
        }
    }
}

impl SlopeDistribution {
    /// Density D(θ_h) of facet normals in 1/sr.
    fn density(self, theta_h: f64, roughness: f64) -> f64 {
        let (cos2, m2) = (theta_h.cos().powi(2), roughness * roughness);
        match self {
            Self::Beckmann => (-(1.0 / cos2 - 1.0) / m2).exp() / (PI * m2 * cos2 * cos2),
            Self::Ggx => m2 / (PI * (cos2 * (m2 - 1.0) + 1.0).powi(2)),
        }
    }

    /// Smith's Λ: hidden area per visible area of facets.
    fn lambda(self, cos_theta: f64, roughness: f64) -> f64 {
        let tan2 = 1.0 / (cos_theta * cos_theta) - 1.0;
        match self {
            Self::Beckmann => {
                // The rational fit of [Walter07] to the exact form.
                let a = 1.0 / (roughness * tan2.sqrt());
                if a < 1.6 {
                    (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a)
                } else {
                    0.0
                }
            }
            Self::Ggx => 0.5 * ((1.0 + roughness * roughness * tan2).sqrt() - 1.0),
        }
    }
}

/// f_r per albedo of a diffuse ground below an interface, in 1/sr: light is refracted in and out.
pub fn diffuse_ground(coat: Interface, cos_theta_i: f64, cos_theta_o: f64) -> f64 {
    let enters = |cos| 1.0 - fresnel(cos, coat.eta[0], 0.0);
    enters(cos_theta_i) * enters(cos_theta_o) / (PI * enters(COS_45).powi(2))
}

/// Cosine at which a diffuse ground keeps its albedo: of 45°.
const COS_45: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Fresnel's equations for light on a medium η + iκ, averaged over polarisation.
fn fresnel(cos_theta: f64, eta: f64, kappa: f64) -> f64 {
    let (cos2, sin2) = (cos_theta * cos_theta, 1.0 - cos_theta * cos_theta);
    let t0 = eta * eta - kappa * kappa - sin2;
    let a2_b2 = (t0 * t0 + 4.0 * eta * eta * kappa * kappa).sqrt();
    let a = (0.5 * (a2_b2 + t0)).max(0.0).sqrt();
    let (t1, t2) = (a2_b2 + cos2, 2.0 * a * cos_theta);
    let r_s = (t1 - t2) / (t1 + t2);
    let (t3, t4) = (cos2 * a2_b2 + sin2 * sin2, t2 * sin2);
    let r_p = r_s * (t3 - t4) / (t3 + t4);
    0.5 * (r_s + r_p)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::Fresnel;

    #[test]
    fn without_absorption_the_reflectance_is_that_of_a_dielectric() {
        for k in 1..=90 {
            let cos_theta = f64::from(k) / 90.0;
            let expected = Fresnel::Exact.reflectance(cos_theta, 1.5);
            assert!((fresnel(cos_theta, 1.5, 0.0) - expected).abs() < 1e-13);
        }
        // A metal at normal incidence: ((η−1)² + κ²)/((η+1)² + κ²).
        let expected =
            (0.857_f64.powi(2) + 3.983_f64.powi(2)) / (1.143_f64.powi(2) + 3.983_f64.powi(2));
        assert!((GOLD.reflectance(1.0)[0] - expected).abs() < 1e-13);
    }

    #[test]
    fn facets_cover_the_ground_once() {
        for slopes in [SlopeDistribution::Beckmann, SlopeDistribution::Ggx] {
            let steps = 20_000;
            let step = 0.5 * PI / f64::from(steps);
            let covered: f64 = (0..steps)
                .map(|k| (f64::from(k) + 0.5) * step)
                .map(|theta| slopes.density(theta, 0.3) * theta.cos() * theta.sin() * 2.0 * PI)
                .sum();
            assert!((covered * step - 1.0).abs() < 1e-3, "{covered}");
        }
    }
}
