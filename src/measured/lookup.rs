//! Lookup of f_r in a table: nearest cell or trilinear.

use super::grid::{THETA_D_BINS, THETA_H_BINS};
use super::table::Table;
use crate::geom::{HalfDiff, Rgb};
use crate::keys;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Interpolation of values in a table.
///
/// Both start from the bin coordinates (h, d, p) of [`crate::measured::Grid::bin_coordinates`]: h = 90 √(θ_h / 90°), d and p are
/// θ_d and φ_d in degrees, φ_d wrapped to the grid (modulo 180° where it is folded, else 360°). Both have no value where
/// the cell that holds the angles, ⌊(h, d, p)⌋ with 90 counted to the last bin, is invalid: gaps are the same in both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Lookup {
    /// Value of the cell that holds the angles, as measured.
    #[default]
    Nearest,
    /// Trilinear between the centres of the eight cells around, which lowers sharp peaks a little.
    ///
    /// With x = h − ½ clamped to [0, 89]: i = min(⌊x⌋, 88), weights 1 − (x − i) on bin i and x − i on bin i + 1.
    /// θ_d likewise. With x = p − ½: i = ⌊x⌋, weights 1 − (x − i) on bin i and x − i on bin i + 1, both bins modulo
    /// the number of φ_d bins. The value is Σ w f / Σ w over the valid ones of the eight. The cell that holds the
    /// angles has a weight of at least 1/8, so the divisor is never small.
    Smooth,
}

/// All lookups, in the order in which they are offered.
pub const LOOKUPS: [Lookup; 2] = [Lookup::Nearest, Lookup::Smooth];

impl Lookup {
    /// Name in files and on the command line, e.g. "nearest".
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// The lookup with this `key`.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }
}

impl Table {
    /// f_r of the unit vectors (wi, wo) in 1/sr, linear RGB. `None` where either is below the horizon, and where the
    /// cell that holds the angles is invalid.
    pub fn lookup(&self, wi: DVec3, wo: DVec3, lookup: Lookup) -> Option<Rgb> {
        if wi.z < 0.0 || wo.z < 0.0 {
            return None;
        }
        self.lookup_angles(HalfDiff::from_directions(wi, wo)?, lookup)
    }

    /// f_r at half and difference angles in 1/sr; `None` where the cell that holds them is invalid. The horizon is not
    /// looked at: cells that it cuts through are valid as a whole or not at all.
    pub fn lookup_angles(&self, angles: HalfDiff, lookup: Lookup) -> Option<Rgb> {
        let (h, d, phi) = self.grid().bins_of(angles);
        let nearest = self.cell(self.grid().index(h, d, phi))?;
        match lookup {
            Lookup::Nearest => Some(nearest),
            Lookup::Smooth => Some(self.smooth(angles)),
        }
    }

    /// f_r by [`Lookup::Smooth`] where the cell that holds the angles is valid.
    fn smooth(&self, angles: HalfDiff) -> Rgb {
        let grid = self.grid();
        let [h, d, phi] = grid.bin_coordinates(angles);
        let (h, d) = (neighbors(h, THETA_H_BINS), neighbors(d, THETA_D_BINS));
        let phi = neighbors_around(phi, grid.phi_d_bins());
        let mut sum = [0.0; 3];
        let mut weights = 0.0;
        for (bin_h, weight_h) in h {
            for (bin_d, weight_d) in d {
                for (bin_phi, weight_phi) in phi {
                    let Some(f_r) = self.cell(grid.index(bin_h, bin_d, bin_phi)) else {
                        continue;
                    };
                    let weight = weight_h * weight_d * weight_phi;
                    weights += weight;
                    for (sum, f_r) in sum.iter_mut().zip(f_r) {
                        *sum += weight * f_r;
                    }
                }
            }
        }
        sum.map(|sum| sum / weights)
    }
}

/// The two bins whose centres enclose a bin coordinate, with their weights; clamped at both ends.
fn neighbors(coordinate: f64, bins: usize) -> [(usize, f64); 2] {
    let x = (coordinate - 0.5).clamp(0.0, (bins - 1) as f64);
    let bin = (x as usize).min(bins - 2);
    let t = x - bin as f64;
    [(bin, 1.0 - t), (bin + 1, t)]
}

/// The two bins whose centres enclose a bin coordinate on a circle, with their weights.
fn neighbors_around(coordinate: f64, bins: usize) -> [(usize, f64); 2] {
    let x = coordinate - 0.5 + bins as f64;
    let t = x - x.floor();
    let bin = x as usize % bins;
    [(bin, 1.0 - t), ((bin + 1) % bins, t)]
}

#[cfg(test)]
mod tests;
