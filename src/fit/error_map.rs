//! Decomposition of a model's error E over the directions of light and view, and over half and difference angles.
//!
//! It goes over the cells of the table in f64 with the definition of E as it stands, independently of how a fit
//! arranges them: what is shown and what is minimised check each other.

use super::error::ProblemError;
use super::options::Weight;
use crate::brdf::Brdf;
use crate::geom::Rgb;
use crate::measured::Table;
use crate::measured::grid::{Grid, THETA_D_BINS, THETA_H_BINS};
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;

/// Number of bins of θi and of θo, two degrees each.
pub const DIRECTION_BINS: usize = 45;

/// Error and energy of a bin, as shares of Σ w f over all cells and channels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bin {
    /// Σ w |f̂ − f|: what the bin adds to E.
    pub error: f64,
    /// Σ w f: reflected energy in the bin.
    pub energy: f64,
}

impl Bin {
    fn add(&mut self, other: Self, share: f64) {
        self.error += share * other.error;
        self.energy += share * other.energy;
    }

    /// E of the bin alone; `None` where nothing was reflected.
    pub fn own_error(self) -> Option<f64> {
        (self.energy > 0.0).then(|| self.error / self.energy)
    }
}

/// E as sums over bins. The errors of either list add up to it.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMap {
    /// Total E, as a fit reports it.
    pub total: f64,
    /// E per channel, each against its own Σ w f. NaN for a channel that is black.
    pub channels: Rgb,
    /// Bins at θi + [`DIRECTION_BINS`] · θo. Data are reciprocal, so a cell counts half as (θi, θo) and half swapped;
    /// it is spread over the four bins whose centres enclose it, or rows of cells would beat against rows of bins.
    pub directions: Vec<Bin>,
    /// Bins of the grid at θh + 90 θd, summed over φd. `None` where no cell counts.
    pub half_diff: Vec<Option<Bin>>,
}

/// Decomposes the error of a model over a table. `limit` is the grazing limit in radians.
///
/// # Errors
/// Errors of [`super::Problem::new`].
pub fn error_map(
    table: &Table,
    weight: Weight,
    limit: f64,
    brdf: &Brdf,
) -> Result<ErrorMap, ProblemError> {
    let slabs: Vec<Slab> = (0..THETA_H_BINS)
        .into_par_iter()
        .map(|theta_h| Slab::new(table, weight, limit, brdf, theta_h))
        .collect();
    let mut sum = Slab::default();
    let mut half_diff = vec![None; THETA_H_BINS * THETA_D_BINS];
    let mut directions = vec![Bin::default(); DIRECTION_BINS * DIRECTION_BINS];
    for (theta_h, slab) in slabs.into_iter().enumerate() {
        sum.cells += slab.cells;
        (0..3).for_each(|k| sum.error[k] += slab.error[k]);
        (0..3).for_each(|k| sum.energy[k] += slab.energy[k]);
        for (theta_d, row) in slab.rows.into_iter().enumerate() {
            half_diff[theta_h + THETA_H_BINS * theta_d] = row;
        }
        for (bin, part) in directions.iter_mut().zip(slab.directions) {
            bin.add(part, 1.0);
        }
    }
    let energy: f64 = sum.energy.iter().sum();
    if sum.cells == 0 {
        return Err(ProblemError::NoCells);
    }
    if energy <= 0.0 {
        return Err(ProblemError::Black);
    }
    let normalised = |bin: &mut Bin| {
        bin.error /= energy;
        bin.energy /= energy;
    };
    directions.iter_mut().for_each(normalised);
    half_diff.iter_mut().flatten().for_each(normalised);
    Ok(ErrorMap {
        total: sum.error.iter().sum::<f64>() / energy,
        channels: std::array::from_fn(|k| sum.error[k] / sum.energy[k]),
        directions,
        half_diff,
    })
}

/// Sums over one bin of θh.
#[derive(Default)]
struct Slab {
    cells: usize,
    error: [f64; 3],
    energy: [f64; 3],
    rows: Vec<Option<Bin>>,
    directions: Vec<Bin>,
}

impl Slab {
    fn new(table: &Table, weight: Weight, limit: f64, brdf: &Brdf, theta_h: usize) -> Self {
        let grid = table.grid();
        let mut slab = Self {
            directions: vec![Bin::default(); DIRECTION_BINS * DIRECTION_BINS],
            ..Self::default()
        };
        let low = limit.clamp(0.0, FRAC_PI_2).cos();
        for theta_d in 0..THETA_D_BINS {
            let mut row: Option<Bin> = None;
            // Mirrored and swapped cells have the same model and weight.
            for phi_d in 0..90 {
                let center = grid.center(theta_h, theta_d, phi_d);
                let cosines = center.cosines();
                let (cos_i, cos_o) = (cosines.cos_theta_i, cosines.cos_theta_o);
                let smaller = cos_i.min(cos_o);
                if smaller <= 0.0 || smaller < low {
                    continue;
                }
                let w = solid_angle(theta_h, center.theta_d, weight)
                    * match weight {
                        Weight::Cosine => cos_i * cos_o,
                        Weight::Cells | Weight::SolidAngle => 1.0,
                    };
                let model = brdf.eval(&cosines);
                let mut bin = Bin::default();
                let mut any = false;
                for mirrored in mirrored(grid, phi_d) {
                    let Some(f) = table.cell(grid.index(theta_h, theta_d, mirrored)) else {
                        continue;
                    };
                    any = true;
                    slab.cells += 1;
                    for k in 0..3 {
                        let (error, energy) = (w * (model[k] - f[k]).abs(), w * f[k]);
                        slab.error[k] += error;
                        slab.energy[k] += energy;
                        bin.add(Bin { error, energy }, 1.0);
                    }
                }
                if any {
                    row.get_or_insert_default().add(bin, 1.0);
                    let (theta_i, theta_o) = (cos_i.min(1.0).acos(), cos_o.min(1.0).acos());
                    slab.spread(bin, theta_i, theta_o);
                    slab.spread(bin, theta_o, theta_i);
                }
            }
            slab.rows.push(row);
        }
        slab
    }

    /// Adds half of a cell to the bins around (θi, θo), in radians.
    fn spread(&mut self, bin: Bin, theta_i: f64, theta_o: f64) {
        for (i, share_i) in enclosing_bins(theta_i) {
            for (o, share_o) in enclosing_bins(theta_o) {
                self.directions[i + DIRECTION_BINS * o].add(bin, 0.5 * share_i * share_o);
            }
        }
    }
}

/// The two bins whose centres enclose an angle in radians, with the angle's shares of them.
fn enclosing_bins(theta: f64) -> [(usize, f64); 2] {
    let last = DIRECTION_BINS - 1;
    let at = theta / FRAC_PI_2 * DIRECTION_BINS as f64 - 0.5;
    let at = at.clamp(0.0, last as f64);
    let first = (at as usize).min(last - 1);
    let share = at - first as f64;
    [(first, 1.0 - share), (first + 1, share)]
}

/// Solid angle 4 cos θd dωh dωd of a cell up to a factor common to all cells; 1 for [`Weight::Cells`].
fn solid_angle(theta_h: usize, theta_d: f64, weight: Weight) -> f64 {
    if weight == Weight::Cells {
        return 1.0;
    }
    let edge = |i: usize| (i as f64 / THETA_H_BINS as f64).powi(2) * FRAC_PI_2;
    let (from, to) = (edge(theta_h), edge(theta_h + 1));
    // cos a − cos b without cancellation.
    let omega_h = 2.0 * (0.5 * (from + to)).sin() * (0.5 * (to - from)).sin();
    theta_d.cos() * theta_d.sin() * omega_h
}

/// φd bins that mirror one below 90°, itself included: π − φd, and both plus π where the grid has them.
fn mirrored(grid: Grid, phi_d: usize) -> impl Iterator<Item = usize> {
    (0..grid.phi_d_bins())
        .step_by(180)
        .flat_map(move |turn| [turn + phi_d, turn + 179 - phi_d])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::params::lobe_values;
    use crate::brdf::{COMBINED, Fresnel, Params};
    use crate::fit::Problem;
    use crate::fit::options::{NO_LIMIT, WEIGHTS};
    use crate::measured::tabulate;

    fn brdf(s: f64) -> Brdf {
        Brdf {
            model: &COMBINED,
            fresnel: Fresnel::Exact,
            params: Params {
                rho_d: [0.3, 0.2, 0.1],
                k_s: [2.0, 3.0, 4.0],
                lobe: lobe_values([s, 0.4]),
                eta: 1.5,
            },
        }
    }

    /// Table that no model fits exactly: one model at some angles, another at others, with gaps.
    fn table(grid: Grid) -> Table {
        let (a, b) = (brdf(20.0), brdf(60.0));
        let cells = (0..grid.len())
            .map(|index| {
                let (h, d, phi) = grid.bins(index);
                let c = grid.center(h, d, phi).cosines();
                if index % 17 == 3 || !c.above_horizon() {
                    return [-1.0; 3];
                }
                let brdf = if (h / 7 + d / 5 + phi / 11) % 3 == 0 {
                    &b
                } else {
                    &a
                };
                brdf.eval(&c).map(|x| x as f32)
            })
            .collect();
        Table::new(grid, cells)
    }

    fn sum(bins: impl Iterator<Item = Bin>) -> f64 {
        bins.map(|bin| bin.error).sum()
    }

    #[test]
    fn both_lists_add_up_to_the_error_that_a_fit_reports() {
        for grid in [Grid::FOLDED, Grid::FULL] {
            let table = table(grid);
            for weight in WEIGHTS {
                for limit in [NO_LIMIT, 80f64.to_radians()] {
                    let model = brdf(30.0);
                    let map = error_map(&table, weight, limit, &model).expect("cells");
                    let problem = Problem::new(&table, weight, limit).expect("cells");
                    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-6;
                    let error = problem.error(&model);
                    assert!(near(map.total, error), "{weight:?} {} {error}", map.total);
                    let errors = problem.errors(&model);
                    assert!((0..3).all(|k| near(map.channels[k], errors.channels[k])));
                    let directions = sum(map.directions.iter().copied());
                    let half_diff = sum(map.half_diff.iter().flatten().copied());
                    assert!((directions / map.total - 1.0).abs() < 1e-12);
                    assert!((half_diff / map.total - 1.0).abs() < 1e-12);
                    // Planted: another model's, another weight's, another limit's.
                    let planted = [
                        error_map(&table, weight, limit, &brdf(30.01)),
                        error_map(&table, WEIGHTS[(weight as usize + 1) % 3], limit, &model),
                        error_map(&table, weight, limit - 0.1, &model),
                    ];
                    for planted in planted.into_iter().flatten() {
                        assert!(!near(planted.total, error), "{weight:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn light_and_view_are_alike() {
        let table = table(Grid::FOLDED);
        let map = error_map(&table, Weight::Cosine, NO_LIMIT, &brdf(30.0)).expect("cells");
        for i in 0..DIRECTION_BINS {
            for o in 0..DIRECTION_BINS {
                let [a, b] = [i + DIRECTION_BINS * o, o + DIRECTION_BINS * i]
                    .map(|bin| map.directions[bin].error);
                assert!((a - b).abs() <= 1e-14, "{i} {o} {a} {b}");
            }
        }
    }

    #[test]
    fn an_error_is_where_it_was_planted() {
        let grid = Grid::FOLDED;
        let model = brdf(30.0);
        let (h, d, phi) = (40, 30, 70);
        let cells = tabulate(&model, grid).cells().to_vec();
        let mut spoilt = cells.clone();
        spoilt[grid.index(h, d, phi)] = [1000.0; 3];
        let map = |cells| {
            let table = Table::new(grid, cells);
            error_map(&table, Weight::Cosine, NO_LIMIT, &model).expect("cells")
        };
        assert!(map(cells).total < 1e-6);
        let map = map(spoilt);
        let there = map.half_diff[h + THETA_H_BINS * d].expect("cells").error;
        assert!((there / map.total - 1.0).abs() < 1e-4);
        let c = grid.center(h, d, phi).cosines();
        let bin = |cos: f64| (cos.acos().to_degrees() / 2.0) as usize;
        let (i, o) = (bin(c.cos_theta_i), bin(c.cos_theta_o));
        let around = |i: usize, o: usize| {
            let near = |bin: usize, of: usize| bin.abs_diff(of) <= 1;
            let bins = (0..DIRECTION_BINS * DIRECTION_BINS)
                .filter(|b| near(b % DIRECTION_BINS, i) && near(b / DIRECTION_BINS, o));
            sum(bins.map(|b| map.directions[b]))
        };
        assert!((around(i, o) / map.total - 0.5).abs() < 1e-4);
        assert!((around(o, i) / map.total - 0.5).abs() < 1e-4);
    }

    #[test]
    fn nothing_to_measure_is_said() {
        let grid = Grid::FOLDED;
        let black = Table::new(grid, vec![[0.0; 3]; grid.len()]);
        let of = |table: &Table| error_map(table, Weight::Cells, NO_LIMIT, &brdf(1.0));
        assert_eq!(of(&black), Err(ProblemError::Black));
        assert_eq!(of(&Table::unmeasured()), Err(ProblemError::NoCells));
    }
}
