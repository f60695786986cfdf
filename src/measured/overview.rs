//! Summary of a table: width of its highlight, mean reflectance.

use super::grid::{THETA_D_BINS, THETA_H_BINS};
use super::table::Table;
use crate::geom::Rgb;
use crate::geom::color::luminance;

/// Bins of θ_d over which the highlight is averaged: below 5° a gonioreflectometer obstructs its own light, and up to
/// 45° the Fresnel factor hardly changes.
const NEAR_NORMAL: std::ops::Range<usize> = 5..45;
/// Last bin of θ_h of the profile, at 45°: every pair with such a θ_d is above the horizon.
const LAST_PROFILE_BIN: usize = 63;
/// Smallest ratio of the peak's luminance to the least one for a highlight.
const CONTRAST: f64 = 1.5;
/// Steps in bins of θ_d and φ_d between the cells that are sampled for the mean reflectance.
const STRIDE: (usize, usize) = (5, 15);

impl Table {
    /// Half width at half maximum of the highlight in radians of θ_h: of the mean luminance over φ_d and over θ_d from
    /// 5° to 45°, above its least value up to 45°. `None` where no peak is 1.5 times as bright as that.
    pub fn highlight_half_width(&self) -> Option<f64> {
        let profile: Vec<(f64, f64)> = (0..=LAST_PROFILE_BIN)
            .filter_map(|h| {
                let theta_h = self.grid().center(h, 0, 0).theta_h;
                Some((theta_h, self.mean_luminance(h)?))
            })
            .collect();
        let (top, &(_, peak)) = profile
            .iter()
            .enumerate()
            .max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1))?;
        let base = profile.iter().map(|row| row.1).fold(peak, f64::min);
        if peak < CONTRAST * base || peak <= 0.0 {
            return None;
        }
        let half = 0.5 * (peak + base);
        let pair = profile[top..].windows(2).find(|pair| pair[1].1 <= half)?;
        let [(from, above), (to, below)] = [pair[0], pair[1]];
        Some(from + (to - from) * (above - half) / (above - below))
    }

    /// Mean luminance of a θ_h bin over [`NEAR_NORMAL`] in 1/sr; `None` where no cell is valid.
    fn mean_luminance(&self, h: usize) -> Option<f64> {
        let grid = self.grid();
        let (mut sum, mut count) = (0.0, 0);
        for d in NEAR_NORMAL {
            for phi in 0..grid.phi_d_bins() {
                if let Some(f_r) = self.cell(grid.index(h, d, phi)) {
                    sum += luminance(f_r);
                    count += 1;
                }
            }
        }
        (count > 0).then(|| sum / f64::from(count))
    }

    /// Share of uniform light from the whole hemisphere that is reflected, linear RGB, from a sample of the valid
    /// cells; 0 where none is valid.
    pub fn mean_reflectance(&self) -> Rgb {
        let grid = self.grid();
        let (mut sum, mut weights) = ([0.0; 3], 0.0);
        for h in 0..THETA_H_BINS {
            for d in (STRIDE.0 / 2..THETA_D_BINS).step_by(STRIDE.0) {
                for phi in (STRIDE.1 / 2..grid.phi_d_bins()).step_by(STRIDE.1) {
                    let Some(f_r) = self.cell(grid.index(h, d, phi)) else {
                        continue;
                    };
                    let center = grid.center(h, d, phi);
                    let cosines = center.cosines();
                    if !cosines.above_horizon() {
                        continue;
                    }
                    // As dωi dωo = 4 cos θd dωh dωd, and a bin of θ_h is as wide as 2h + 1.
                    let weight = center.theta_d.cos()
                        * center.theta_h.sin()
                        * center.theta_d.sin()
                        * (2 * h + 1) as f64
                        * cosines.cos_theta_i
                        * cosines.cos_theta_o;
                    weights += weight;
                    for (sum, f_r) in sum.iter_mut().zip(f_r) {
                        *sum += weight * f_r;
                    }
                }
            }
        }
        if weights > 0.0 {
            sum.map(|sum| std::f64::consts::PI * sum / weights)
        } else {
            [0.0; 3]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::Grid;

    /// Table of a Blinn-Phong lobe over a diffuse base.
    fn table(exponent: f64) -> Table {
        let grid = Grid::FOLDED;
        let cells = (0..grid.len()).map(|index| {
            let (h, d, phi) = grid.bins(index);
            let center = grid.center(h, d, phi);
            let value = 0.1 + 3.0 * center.theta_h.cos().powf(exponent);
            if center.cosines().above_horizon() {
                [value as f32; 3]
            } else {
                [-1.0; 3]
            }
        });
        Table::new(grid, cells.collect())
    }

    #[test]
    fn the_half_width_of_a_cosine_power_is_known() {
        for exponent in [30.0, 300.0, 30_000.0] {
            let truth = 0.5_f64.powf(1.0 / exponent).acos();
            let width = table(exponent).highlight_half_width().expect("a peak");
            assert!((width / truth - 1.0).abs() < 0.01, "{exponent}: {width}");
            // The law is not just any: half the exponent is wider by √2.
            let wider = table(0.5 * exponent)
                .highlight_half_width()
                .expect("a peak");
            assert!((wider / truth - 1.0).abs() > 0.3);
        }
    }

    #[test]
    fn what_has_no_highlight_has_no_width() {
        let grid = Grid::FOLDED;
        let flat = Table::new(grid, vec![[0.2; 3]; grid.len()]);
        assert_eq!(flat.highlight_half_width(), None);
        assert_eq!(Table::unmeasured().highlight_half_width(), None);
        assert_eq!(Table::unmeasured().mean_reflectance(), [0.0; 3]);
    }

    #[test]
    fn a_diffuse_table_reflects_its_albedo() {
        let grid = Grid::FOLDED;
        let flat = Table::new(grid, vec![[0.1, 0.2, 0.05]; grid.len()]);
        let [r, g, b] = flat.mean_reflectance();
        let pi = std::f64::consts::PI;
        assert!((r - 0.1 * pi).abs() < 1e-6 && (g - 0.2 * pi).abs() < 1e-6);
        assert!((b - 0.05 * pi).abs() < 1e-6 && (b - r).abs() > 0.1);
    }
}
