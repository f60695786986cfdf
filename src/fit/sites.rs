//! The cells of a table arranged for passes over all of them.
//!
//! Cells with φd, π − φd (and, unfolded, those plus π) swap wi and wo or mirror them, and every model and weight is
//! symmetric in both: such cells share one **site**, at which the model is evaluated once. With c = cos² φd the
//! cosines are linear along a row of fixed (θh, θd):
//!
//! - `1 − wr·wo = 2 sin²θh cos²θd + 2 sin²θh sin²θd · c`, without cancellation,
//! - `cos θi cos θo = cos²θh cos²θd − sin²θh sin²θd · c`.
//!
//! so that a pass reads f_r and hardly anything else.

use super::lanes::LANES;
use super::options::{GRAZING, Weight};
use super::problem::ProblemError;
use crate::measured::Table;
use crate::measured::grid::{Grid, THETA_D_BINS, THETA_H_BINS};
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// What stands in a site for a cell that does not count.
pub const ABSENT: f32 = -1.0;

/// φd bins that have a site of their own: those below 90°.
const SITES: usize = 90;

/// Which cells are taken: all, or an even sample.
#[derive(Clone, Copy, Debug)]
pub struct Sampling {
    /// Bins of θd taken, evenly from the middle of their shares.
    pub theta_d: usize,
    /// Sites of φd taken, likewise.
    pub phi_d: usize,
}

/// A row of sites with the same (θh, θd).
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Bin of θh.
    pub theta_h: usize,
    /// Bin of θd.
    pub theta_d: usize,
    /// Where its first site is in [`Sites::cos2`].
    pub first: usize,
    /// How many blocks of [`LANES`] sites it has.
    pub blocks: usize,
    /// Where its sites begin among all, in blocks.
    pub site_block: usize,
    /// The weight of a site's cells is `weight[0] + weight[1] · c`, normalised so that Σ w f = 1 over all cells.
    pub weight: [f32; 2],
    /// Sites from here on, counted from the first, are not grazing.
    pub grazing_end: usize,
}

/// All rows, with f_r per site.
#[derive(Clone, Debug)]
pub struct Sites {
    /// By ascending θh, then θd.
    pub rows: Vec<Row>,
    /// The rows of each θh: the units of work of a pass.
    pub slabs: Vec<Range<usize>>,
    /// c = cos² φd per site of a full row, padded to a whole block more.
    pub cos2: Vec<f32>,
    /// Cells per site: 2, or 4 where φd covers the whole turn.
    pub copies: usize,
    /// f_r / `scale` or [`ABSENT`]: block by block, in each by copy and channel, so that a pass reads one stream.
    pub values: Vec<f32>,
    /// Number of blocks in all rows.
    pub blocks: usize,
    /// Number of cells that count.
    pub cells: usize,
    /// The unit of the values in 1/sr, a power of two.
    pub scale: f64,
    /// Σ w f per channel, of the sum over all.
    pub shares: [f64; 3],
    /// Σ w f of the grazing cells, of the sum over all.
    pub grazing_share: f64,
}

impl Sites {
    /// Arranges a table.
    ///
    /// # Errors
    /// Where no cell counts or all that count are 0.
    pub fn new(
        table: &Table,
        weight: Weight,
        limit: f64,
        sampling: Option<Sampling>,
    ) -> Result<Self, ProblemError> {
        let grid = table.grid();
        let copies = grid.phi_d_bins() / SITES;
        let (theta_d_bins, phi_d_bins) = match sampling {
            Some(sampling) => (
                spread(sampling.theta_d, THETA_D_BINS),
                spread(sampling.phi_d, SITES),
            ),
            None => ((0..THETA_D_BINS).collect(), (0..SITES).collect()),
        };
        let cos_phi: Vec<f64> = phi_d_bins
            .iter()
            .map(|phi_d| grid.center(0, 0, *phi_d).phi_d.cos())
            .collect();
        let slabs: Vec<Slab> = (0..THETA_H_BINS)
            .into_par_iter()
            .map(|theta_h| {
                let mut slab = Slab::default();
                for theta_d in &theta_d_bins {
                    slab.add_row(
                        table,
                        weight,
                        limit,
                        (theta_h, *theta_d),
                        &phi_d_bins,
                        &cos_phi,
                    );
                }
                slab
            })
            .collect();
        let sums = slabs.iter().fold([0.0; 3], |mut sums, slab| {
            (0..3).for_each(|k| sums[k] += slab.sums[k]);
            sums
        });
        let weights: f64 = slabs.iter().map(|slab| slab.weights).sum();
        let total: f64 = sums.iter().sum();
        if weights <= 0.0 {
            return Err(ProblemError::NoCells);
        }
        if total <= 0.0 {
            return Err(ProblemError::Black);
        }
        // A power of two changes no digit; it keeps products of f32 away from the ends of their range.
        let scale = (total / (3.0 * weights)).log2().round().exp2();
        let mut sites = Self {
            rows: Vec::new(),
            slabs: Vec::new(),
            cos2: cos_phi.iter().map(|c| (c * c) as f32).collect(),
            copies,
            values: Vec::with_capacity(slabs.iter().map(|slab| slab.values.len()).sum()),
            blocks: 0,
            cells: slabs.iter().map(|slab| slab.cells).sum(),
            scale,
            shares: sums.map(|sum| sum / total),
            grazing_share: slabs.iter().map(|slab| slab.grazing).sum::<f64>() / total,
        };
        sites.cos2.resize(phi_d_bins.len() + LANES, 0.0);
        for slab in slabs {
            let first = sites.rows.len();
            for mut row in slab.rows {
                row.site_block += sites.blocks;
                row.weight = row
                    .weight
                    .map(|w| (f64::from(w) * slab.unit / total * scale) as f32);
                sites.rows.push(row);
            }
            sites.blocks += slab.blocks;
            let scaled = |value: f32| {
                if value < 0.0 {
                    ABSENT
                } else {
                    (f64::from(value) / scale) as f32
                }
            };
            sites.values.extend(slab.values.into_iter().map(scaled));
            sites.slabs.push(first..sites.rows.len());
        }
        Ok(sites)
    }

    /// cos² φd of a row's sites.
    #[inline(always)]
    pub fn cos2_of(&self, row: &Row) -> &[f32] {
        &self.cos2[row.first..][..row.blocks * LANES]
    }

    /// The values of a row: block by block, in each by copy and channel.
    #[inline(always)]
    pub fn values_of(&self, row: &Row) -> &[f32] {
        let block = 3 * self.copies * LANES;
        &self.values[row.site_block * block..][..row.blocks * block]
    }

    /// Bytes that a pass reads of the data.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.values[..])
    }
}

/// Where a cell's value is among those of its row.
pub fn place(copies: usize, site: usize, copy: usize, channel: usize) -> usize {
    LANES * (site / LANES * 3 * copies + 3 * copy + channel) + site % LANES
}

/// `count` of `bins` bins, in the middle of equal shares.
fn spread(count: usize, bins: usize) -> Vec<usize> {
    (0..count)
        .map(|k| (2 * k + 1) * bins / (2 * count))
        .collect()
}

/// The rows of one θh while they are gathered.
#[derive(Default)]
struct Slab {
    rows: Vec<Row>,
    values: Vec<f32>,
    blocks: usize,
    cells: usize,
    sums: [f64; 3],
    grazing: f64,
    weights: f64,
    /// Row weights are in this unit, as f32 hold no 1e-40.
    unit: f64,
}

impl Slab {
    fn add_row(
        &mut self,
        table: &Table,
        weight: Weight,
        limit: f64,
        (theta_h, theta_d): (usize, usize),
        phi_d_bins: &[usize],
        cos_phi: &[f64],
    ) {
        let grid = table.grid();
        let copies = grid.phi_d_bins() / SITES;
        let center = grid.center(theta_h, theta_d, 0);
        let (sin_h, cos_h) = center.theta_h.sin_cos();
        let (sin_d, cos_d) = center.theta_d.sin_cos();
        let (along, across) = (cos_h * cos_d, sin_h * sin_d);
        // The smaller of the two cosines; it grows along the row, as cos φd falls.
        let smaller = |k: usize| along - across * cos_phi[k];
        let low = limit.cos().max(0.0);
        let counts = |k: usize| smaller(k) >= low && smaller(k) > 0.0;
        let Some(first) = (0..cos_phi.len()).find(|k| counts(*k)) else {
            return;
        };
        let measured = |k: usize, copy: usize| {
            let phi_d = mirrored(phi_d_bins[k], copy, grid);
            table.cells()[grid.index(theta_h, theta_d, phi_d)]
        };
        let any =
            (first..cos_phi.len()).any(|k| (0..copies).any(|copy| measured(k, copy)[0] >= 0.0));
        if !any {
            return;
        }
        self.unit = bin_solid_angle(theta_h).max(f64::MIN_POSITIVE);
        let (w0, w1) = match weight {
            Weight::Cells => (1.0 / self.unit, 0.0),
            Weight::SolidAngle => (cos_d * sin_d, 0.0),
            Weight::Cosine => (
                cos_d * sin_d * along * along,
                -cos_d * sin_d * across * across,
            ),
        };
        let grazing_end = (first..cos_phi.len())
            .find(|k| smaller(*k) > GRAZING.cos())
            .unwrap_or(cos_phi.len())
            - first;
        let sites = cos_phi.len() - first;
        let blocks = sites.div_ceil(LANES);
        let values_start = self.values.len();
        self.values
            .resize(values_start + 3 * copies * blocks * LANES, ABSENT);
        let row = &mut self.values[values_start..];
        for copy in 0..copies {
            for site in 0..sites {
                let cell = measured(first + site, copy);
                if cell[0].is_nan() {
                    continue;
                }
                let c = cos_phi[first + site].powi(2);
                let w = self.unit * (w0 + w1 * c);
                self.weights += w;
                self.cells += 1;
                for channel in 0..3 {
                    row[place(copies, site, copy, channel)] = cell[channel];
                    let energy = w * f64::from(cell[channel]);
                    self.sums[channel] += energy;
                    self.grazing += if site < grazing_end { energy } else { 0.0 };
                }
            }
        }
        self.rows.push(Row {
            theta_h,
            theta_d,
            first,
            blocks,
            site_block: self.blocks,
            weight: [w0 as f32, w1 as f32],
            grazing_end,
        });
        self.blocks += blocks;
    }
}

/// The solid angle of a bin of θh, up to a factor that all cells share: all others have the same width.
fn bin_solid_angle(theta_h: usize) -> f64 {
    let edge = |i: usize| (i as f64 / THETA_H_BINS as f64).powi(2) * FRAC_PI_2;
    // cos a − cos b without cancellation.
    2.0 * (0.5 * (edge(theta_h) + edge(theta_h + 1))).sin()
        * (0.5 * (edge(theta_h + 1) - edge(theta_h))).sin()
}

/// The φd bins of a site: φd, π − φd, and both plus π.
fn mirrored(phi_d: usize, copy: usize, grid: Grid) -> usize {
    debug_assert!(phi_d < SITES && copy < grid.phi_d_bins() / SITES);
    let half_turn = 2 * SITES * (copy / 2);
    half_turn
        + if copy.is_multiple_of(2) {
            phi_d
        } else {
            2 * SITES - 1 - phi_d
        }
}
