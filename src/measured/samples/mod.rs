//! Synthetic materials in the form of measured ones, for use without a file.
//!
//! Each is made by richer physics than the models that are fitted to it: see [`surface`]. Then noise and gaps at the
//! horizon are added, as a measurement has them. They are deterministic.

mod measure;
mod surface;

use super::table::Table;
use crate::geom::Rgb;
use surface::{GOLD, Interface, SlopeDistribution, SurfaceLobe, dielectric};

/// Recipe of a synthetic material.
#[derive(Debug)]
pub struct SyntheticMaterial {
    /// Name in files and on the command line, e.g. "copper-glaze".
    pub key: &'static str,
    /// Display name, which ends in "(synthetic)".
    pub name: &'static str,
    /// Description in one sentence.
    pub about: &'static str,
    /// Albedo of the diffuse ground below the interface, linear RGB.
    albedo: Rgb,
    /// Interface above the diffuse ground.
    coat: Interface,
    /// Surface lobes, each with its share.
    lobes: &'static [(f64, SurfaceLobe)],
    /// Seed of the noise.
    seed: u64,
}

/// All synthetic materials; the window starts with the first.
pub static SAMPLES: [SyntheticMaterial; 5] = [
    SyntheticMaterial {
        key: "copper-glaze",
        name: "Copper glaze (synthetic)",
        about: "Between Phong and Blinn-Phong: a smooth glaze with a share of rough facets; at grazing angles neither model fits.",
        albedo: [0.55, 0.17, 0.07],
        coat: dielectric(1.5),
        lobes: &[
            (0.8, SurfaceLobe::Smooth { width: 0.35 }),
            (
                0.2,
                SurfaceLobe::Facets {
                    slopes: SlopeDistribution::Beckmann,
                    roughness: 0.25,
                    interface: dielectric(1.5),
                },
            ),
        ],
        seed: 1,
    },
    SyntheticMaterial {
        key: "green-lacquer",
        name: "Green lacquer (synthetic)",
        about: "Phong-like: a nearly smooth lacquer that scatters evenly around the mirror direction, so its grazing highlight is broad.",
        albedo: [0.03, 0.26, 0.13],
        coat: dielectric(1.5),
        lobes: &[(1.0, SurfaceLobe::Smooth { width: 0.25 })],
        seed: 2,
    },
    SyntheticMaterial {
        key: "hammered-gold",
        name: "Hammered gold (synthetic)",
        about: "Blinn-Phong-like: facets with a spread of slopes, so its grazing highlight is condensed towards the plane of incidence.",
        albedo: [0.012, 0.008, 0.003],
        coat: dielectric(1.5),
        lobes: &[(
            1.0,
            SurfaceLobe::Facets {
                slopes: SlopeDistribution::Beckmann,
                roughness: 0.25,
                interface: GOLD,
            },
        )],
        seed: 3,
    },
    SyntheticMaterial {
        key: "blue-porcelain",
        name: "Blue porcelain (synthetic)",
        about: "Very glossy, with the long tails of GGX facets: a peak that no cosine power follows to its foot.",
        albedo: [0.10, 0.22, 0.60],
        coat: dielectric(1.6),
        lobes: &[(
            1.0,
            SurfaceLobe::Facets {
                slopes: SlopeDistribution::Ggx,
                roughness: 0.06,
                interface: dielectric(1.6),
            },
        )],
        seed: 4,
    },
    SyntheticMaterial {
        key: "violet-felt",
        name: "Violet felt (synthetic)",
        about: "Matte with a rim: loose fibres over a diffuse ground, bright where light grazes through them.",
        albedo: [0.34, 0.12, 0.42],
        coat: dielectric(1.15),
        lobes: &[
            (
                0.22,
                SurfaceLobe::Fibers {
                    anisotropy: 0.65,
                    depth: 0.25,
                },
            ),
            (
                0.08,
                SurfaceLobe::Fibers {
                    anisotropy: -0.4,
                    depth: 0.25,
                },
            ),
        ],
        seed: 5,
    },
];

impl SyntheticMaterial {
    /// The material with this `key`.
    pub fn by_key(key: &str) -> Option<&'static Self> {
        SAMPLES.iter().find(|sample| sample.key == key)
    }

    /// Table of the material on the folded grid, with noise and gaps; deterministic.
    pub fn synthesize(&self) -> Table {
        measure::measure(self)
    }
}

#[cfg(test)]
mod tests;
