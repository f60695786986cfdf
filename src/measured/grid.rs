//! Grid of the MERL files [Matusik03]: bins of θ_h (denser towards the highlight), θ_d and φ_d.

use crate::geom::{HalfDiff, directions::wrap};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Number of θ_h bins. Bin i covers 90°·[i², (i+1)²)/90².
pub const THETA_H_BINS: usize = 90;
/// Number of θ_d bins, one degree each.
pub const THETA_D_BINS: usize = 90;
/// Number of φ_d bins in the usual files: [0°, 180°), the rest by reciprocity.
pub const PHI_D_BINS_FOLDED: usize = 180;
/// Number of φ_d bins in files that cover the whole turn.
pub const PHI_D_BINS_FULL: usize = 360;

/// Shape of a table: 90 × 90 bins of θ_h and θ_d, and 180 or 360 bins of φ_d, one degree each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Grid {
    phi_d_bins: usize,
}

impl Grid {
    /// Grid with φ_d in [0°, 180°).
    pub const FOLDED: Self = Self {
        phi_d_bins: PHI_D_BINS_FOLDED,
    };
    /// Grid with φ_d in [0°, 360°).
    pub const FULL: Self = Self {
        phi_d_bins: PHI_D_BINS_FULL,
    };

    /// Number of φ_d bins: 180 or 360.
    pub fn phi_d_bins(self) -> usize {
        self.phi_d_bins
    }

    /// Number of cells.
    pub fn len(self) -> usize {
        THETA_H_BINS * THETA_D_BINS * self.phi_d_bins
    }

    /// Always false: a grid has cells.
    pub fn is_empty(self) -> bool {
        false
    }

    /// Index of a cell in the file's order, φ_d fastest: φ_d + bins·(θ_d + 90 θ_h).
    pub fn index(self, theta_h: usize, theta_d: usize, phi_d: usize) -> usize {
        debug_assert!(theta_h < THETA_H_BINS && theta_d < THETA_D_BINS && phi_d < self.phi_d_bins);
        phi_d + self.phi_d_bins * (theta_d + THETA_D_BINS * theta_h)
    }

    /// Bins (θ_h, θ_d, φ_d) of a cell: the inverse of [`Grid::index`].
    pub fn bins(self, index: usize) -> (usize, usize, usize) {
        let phi_d = index % self.phi_d_bins;
        let rest = index / self.phi_d_bins;
        (rest / THETA_D_BINS, rest % THETA_D_BINS, phi_d)
    }

    /// Angles of a cell's value in radians: the centre of its bins, in √θ_h.
    pub fn center(self, theta_h: usize, theta_d: usize, phi_d: usize) -> HalfDiff {
        HalfDiff {
            theta_h: ((theta_h as f64 + 0.5) / THETA_H_BINS as f64).powi(2) * FRAC_PI_2,
            theta_d: (theta_d as f64 + 0.5).to_radians(),
            phi_d: (phi_d as f64 + 0.5).to_radians(),
        }
    }

    /// Bin coordinates (θ_h, θ_d, φ_d), such that bin i covers [i, i+1) on each axis; φ_d folded or wrapped to the
    /// grid.
    ///
    /// θ_h is in the square-root index. Angles past the last edge give values past 90.
    pub fn bin_coordinates(self, angles: HalfDiff) -> [f64; 3] {
        let turn = if self == Self::FOLDED { 0.5 * TAU } else { TAU };
        [
            THETA_H_BINS as f64 * (angles.theta_h / FRAC_PI_2).sqrt(),
            angles.theta_d.to_degrees(),
            wrap(angles.phi_d, turn).to_degrees(),
        ]
    }

    /// Bins (θ_h, θ_d, φ_d) that hold these angles; the last bins hold 90° too.
    pub fn bins_of(self, angles: HalfDiff) -> (usize, usize, usize) {
        let [h, d, phi] = self.bin_coordinates(angles);
        (
            (h as usize).min(THETA_H_BINS - 1),
            (d as usize).min(THETA_D_BINS - 1),
            (phi as usize).min(self.phi_d_bins - 1),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_is_found_at_its_centre() {
        for grid in [Grid::FOLDED, Grid::FULL] {
            for index in 0..grid.len() {
                let (h, d, phi) = grid.bins(index);
                assert_eq!(grid.index(h, d, phi), index);
                assert_eq!(grid.bins_of(grid.center(h, d, phi)), (h, d, phi));
            }
        }
    }

    #[test]
    fn the_grid_has_the_constants_of_the_format() {
        assert_eq!(Grid::FOLDED.len(), 1_458_000);
        assert_eq!(Grid::FULL.len(), 2_916_000);
        assert_eq!(Grid::FOLDED.index(1, 2, 3), 3 + 180 * (2 + 90));
        let last = Grid::FOLDED.center(89, 89, 179);
        assert!((last.theta_h.to_degrees() - 89.5_f64.powi(2) / 90.0).abs() < 1e-12);
        assert!((last.theta_d.to_degrees() - 89.5).abs() < 1e-12);
        assert!((last.phi_d.to_degrees() - 179.5).abs() < 1e-12);
    }

    #[test]
    fn ninety_degrees_is_in_the_last_bin() {
        let angles = HalfDiff {
            theta_h: FRAC_PI_2,
            theta_d: FRAC_PI_2,
            phi_d: 0.0,
        };
        assert_eq!(Grid::FOLDED.bins_of(angles), (89, 89, 0));
    }
}
