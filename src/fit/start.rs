//! A first guess of the parameters, read off the data: where the sliders stand when a material opens.

use crate::brdf::{Brdf, Fresnel, MODELS, ParamId, Params, params};
use crate::geom::Rgb;
use crate::geom::color::luminance;
use crate::measured::Table;
use crate::measured::grid::{THETA_D_BINS, THETA_H_BINS};
use std::f64::consts::PI;

/// θ_d up to which a row of the profile is averaged: below it Fresnel and grazing effects are small.
const PROFILE_THETA_D_BINS: usize = 45;
/// θ_h from which the highlight of all but the dullest materials is over.
const DIFFUSE_THETA_H_BINS: std::ops::Range<usize> = 60..75;

/// The combined model halfway between Phong and Blinn-Phong, with the table's diffuse level, peak and half width.
///
/// The data give three things: the level far from the highlight (ρ_d), the height of the highlight over it
/// (k_s R_F(0)), and the θ_h at which it has fallen to half (s, as cos^{4s} θ_h = ½). α and η stay at their defaults.
pub fn from_table(table: &Table) -> Brdf {
    let profile: Vec<Option<Rgb>> = (0..THETA_H_BINS).map(|h| mean_of_row(table, h)).collect();
    let diffuse = diffuse_level(&profile);
    let peak = profile.iter().flatten().next().copied().unwrap_or(diffuse);
    let height: Rgb = std::array::from_fn(|k| (peak[k] - diffuse[k]).max(0.0));
    let exponent = half_width(table, &profile, diffuse, height)
        .map_or(params::S.default, |theta_h| 0.25 * 0.5f64.ln() / theta_h.cos().ln());
    let r0 = Fresnel::Exact.reflectance(1.0, params::ETA.default);
    let mut brdf = Brdf {
        model: MODELS[2],
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: diffuse.map(|level| PI * level),
            k_s: height.map(|level| level / r0),
            s: exponent,
            ..Params::default()
        },
    };
    for row in brdf.model.params {
        for value in brdf.params.get_mut(row.id) {
            *value = row.clamp(*value);
        }
    }
    debug_assert!(brdf.model.param(ParamId::Alpha).is_some());
    brdf
}

/// Mean over the valid cells of one θ_h bin with small θ_d.
fn mean_of_row(table: &Table, theta_h: usize) -> Option<Rgb> {
    let grid = table.grid();
    let mut sum = [0.0; 3];
    let mut count = 0.0;
    for theta_d in 0..PROFILE_THETA_D_BINS.min(THETA_D_BINS) {
        let start = grid.index(theta_h, theta_d, 0);
        for cell in &table.cells()[start..start + grid.phi_d_bins()] {
            if !cell[0].is_nan() {
                for (total, value) in sum.iter_mut().zip(cell) {
                    *total += f64::from(*value);
                }
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| sum.map(|total| total / count))
}

fn diffuse_level(profile: &[Option<Rgb>]) -> Rgb {
    let rows: Vec<Rgb> = profile[DIFFUSE_THETA_H_BINS].iter().flatten().copied().collect();
    if rows.is_empty() {
        return [0.0; 3];
    }
    std::array::from_fn(|k| rows.iter().map(|row| row[k]).fold(f64::INFINITY, f64::min))
}

/// The θ_h in radians where the luminance over the diffuse level has fallen to half of its peak.
fn half_width(table: &Table, profile: &[Option<Rgb>], diffuse: Rgb, height: Rgb) -> Option<f64> {
    let (base, half) = (luminance(diffuse), 0.5 * luminance(height));
    if half <= 0.0 {
        return None;
    }
    let bin = profile
        .iter()
        .position(|row| row.is_some_and(|row| luminance(row) - base < half))?;
    Some(table.grid().center(bin.max(1), 0, 0).theta_h)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::Grid;

    fn table_of(brdf: &Brdf) -> Table {
        let grid = Grid::FOLDED;
        let cells = (0..grid.len())
            .map(|index| {
                let (h, d, phi) = grid.bins(index);
                let c = grid.center(h, d, phi).cosines();
                if c.above_horizon() {
                    brdf.eval(&c).map(|x| x as f32)
                } else {
                    [-1.0; 3]
                }
            })
            .collect();
        Table::new(grid, cells)
    }

    #[test]
    fn the_guess_is_near_the_model_that_made_the_data() {
        let mut truth = Brdf {
            model: MODELS[2],
            fresnel: Fresnel::Exact,
            params: Params { rho_d: [0.3, 0.2, 0.1], k_s: [40.0, 50.0, 60.0], s: 60.0, ..Params::default() },
        };
        let guess = from_table(&table_of(&truth));
        for k in 0..3 {
            assert!((guess.params.rho_d[k] / truth.params.rho_d[k] - 1.0).abs() < 0.1, "{guess:?}");
            assert!((guess.params.k_s[k] / truth.params.k_s[k] - 1.0).abs() < 0.25, "{guess:?}");
        }
        assert!((guess.params.s / truth.params.s).ln().abs() < 0.4, "{guess:?}");
        // A planted change of the data moves the guess.
        truth.params.s = 600.0;
        assert!(from_table(&table_of(&truth)).params.s > 4.0 * guess.params.s);
    }

    #[test]
    fn data_without_a_highlight_still_give_finite_parameters() {
        let flat = Table::new(Grid::FOLDED, vec![[0.1; 3]; Grid::FOLDED.len()]);
        let guess = from_table(&flat);
        assert!((guess.params.rho_d[0] - 0.1 * PI).abs() < 1e-6);
        assert_eq!(guess.params.k_s, [0.0; 3]);
        assert_eq!(guess.params.s, params::S.default);
    }
}
