//! Cells of a table arranged for passes over all of them.
//!
//! Cells with φd, π − φd (and, unfolded, those plus π) swap wi and wo or mirror them, and every model and weight is
//! symmetric in both: they form one **symmetric cell**, at which the model is evaluated once. With c = cos² φd the
//! cosines are linear along a row of fixed (θh, θd):
//!
//! - `1 − wr·wo = 2 sin²θh cos²θd + 2 sin²θh sin²θd · c`, without cancellation,
//! - `cos θi cos θo = cos²θh cos²θd − sin²θh sin²θd · c`.
//!
//! so that a pass reads f_r and hardly anything else.

use super::error::ProblemError;
use super::options::Weight;
use super::simd::LANES;
use crate::geom::limits::GRAZING_THETA;
use crate::measured::Table;
use crate::measured::grid::{Grid, THETA_D_BINS, THETA_H_BINS};
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// Value in place of f_r of a cell that is invalid or does not count.
pub const ABSENT: f32 = -1.0;

/// Number of symmetric cells in a full row: one per φd bin below 90°.
const PER_ROW: usize = 90;

/// Largest number of cells in a row, padded to whole blocks.
pub const ROW_CELLS: usize = PER_ROW.next_multiple_of(LANES);

/// Number of rows that a pass takes at a time: their sums are in f32, all of them together in f64.
pub const ROWS_PER_SUM: usize = 6;

/// Size of an even sample of the cells.
#[derive(Clone, Copy, Debug)]
pub struct Sampling {
    /// Number of θd bins taken, from the middle of equal shares.
    pub theta_d: usize,
    /// Number of symmetric cells along φd taken, from the middle of equal shares.
    pub phi_d: usize,
}

/// A row of symmetric cells with the same (θh, θd).
#[derive(Clone, Copy, Debug)]
pub struct CellRow {
    /// Bin of θh.
    pub theta_h: usize,
    /// Bin of θd.
    pub theta_d: usize,
    /// Index of the row's first cell in [`SymmetricCells::cos2`].
    pub first: usize,
    /// Number of blocks of [`LANES`] cells.
    pub blocks: usize,
    /// Index of the row's first block among those of all rows.
    pub first_block: usize,
    /// Coefficients of the weight of each measured cell, `weight[0] + weight[1] · c`, normalised so that Σ w f = 1 over
    /// all cells.
    pub weight: [f32; 2],
    /// Number of leading cells of the row that are grazing.
    pub grazing_end: usize,
}

/// f_r of a table, row by row, with the weights and sums that E needs.
#[derive(Clone, Debug)]
pub struct SymmetricCells {
    /// Rows by ascending θh, then θd.
    pub rows: Vec<CellRow>,
    /// Range of the rows of each θh: the units of work that a pass spreads over threads.
    pub slabs: Vec<Range<usize>>,
    /// c = cos² φd per cell of a full row, padded to a whole block more.
    pub cos2: Vec<f32>,
    /// Number of measured cells per symmetric cell: 2, or 4 where φd covers the whole turn.
    pub mirror_count: usize,
    /// f_r / `scale` or [`ABSENT`]: block by block, in each by mirror and channel, so that a pass reads one stream.
    pub values: Vec<f32>,
    /// Number of blocks in all rows.
    pub blocks: usize,
    /// Number of measured cells that count.
    pub cell_count: usize,
    /// Unit of the values in 1/sr, a power of two.
    pub scale: f64,
    /// Σ w f per channel, as a share of the sum over all channels.
    pub energy: [f64; 3],
    /// Σ w f of the grazing cells, as a share of the sum over all cells and channels.
    pub grazing_energy: f64,
}

impl SymmetricCells {
    /// Arranges a table; `limit` is the grazing limit in radians, `sampling` `None` for all cells.
    ///
    /// # Errors
    /// No cell counts, or all that count are 0.
    pub fn new(
        table: &Table,
        weight: Weight,
        limit: f64,
        sampling: Option<Sampling>,
    ) -> Result<Self, ProblemError> {
        let grid = table.grid();
        let mirror_count = grid.phi_d_bins() / PER_ROW;
        let (theta_d_bins, phi_d_bins) = match sampling {
            Some(sampling) => (
                spread(sampling.theta_d, THETA_D_BINS),
                spread(sampling.phi_d, PER_ROW),
            ),
            None => ((0..THETA_D_BINS).collect(), (0..PER_ROW).collect()),
        };
        let cos_phi: Vec<f64> = phi_d_bins
            .iter()
            .map(|phi_d| grid.center(0, 0, *phi_d).phi_d.cos())
            .collect();
        let slabs: Vec<SlabBuilder> = (0..THETA_H_BINS)
            .into_par_iter()
            .map(|theta_h| {
                let mut slab = SlabBuilder::default();
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
        let mut all = Self {
            rows: Vec::new(),
            slabs: Vec::new(),
            cos2: cos_phi.iter().map(|c| (c * c) as f32).collect(),
            mirror_count,
            values: Vec::with_capacity(slabs.iter().map(|slab| slab.values.len()).sum()),
            blocks: 0,
            cell_count: slabs.iter().map(|slab| slab.cells).sum(),
            scale,
            energy: sums.map(|sum| sum / total),
            grazing_energy: slabs.iter().map(|slab| slab.grazing).sum::<f64>() / total,
        };
        all.cos2.resize(phi_d_bins.len() + LANES, 0.0);
        for slab in slabs {
            let first = all.rows.len();
            for mut row in slab.rows {
                row.first_block += all.blocks;
                row.weight = row
                    .weight
                    .map(|w| (f64::from(w) * slab.unit / total * scale) as f32);
                all.rows.push(row);
            }
            all.blocks += slab.blocks;
            let scaled = |value: f32| {
                if value < 0.0 {
                    ABSENT
                } else {
                    (f64::from(value) / scale) as f32
                }
            };
            all.values.extend(slab.values.into_iter().map(scaled));
            all.slabs.push(first..all.rows.len());
        }
        Ok(all)
    }

    /// cos² φd of the cells of a row.
    #[inline(always)]
    pub fn cos2_of(&self, row: &CellRow) -> &[f32] {
        &self.cos2[row.first..][..row.blocks * LANES]
    }

    /// Values of a row: block by block, in each by mirror and channel.
    #[inline(always)]
    pub fn values_of(&self, row: &CellRow) -> &[f32] {
        let block = 3 * self.mirror_count * LANES;
        &self.values[row.first_block * block..][..row.blocks * block]
    }

    /// Number of bytes of f_r that a pass reads.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.values[..])
    }
}

/// Index among the values of a row, of a cell, one of its mirrors and a channel.
fn value_index(mirror_count: usize, cell: usize, mirror: usize, channel: usize) -> usize {
    LANES * (cell / LANES * 3 * mirror_count + 3 * mirror + channel) + cell % LANES
}

/// Indices of `count` out of `bins` bins, in the middle of equal shares.
fn spread(count: usize, bins: usize) -> Vec<usize> {
    (0..count)
        .map(|k| (2 * k + 1) * bins / (2 * count))
        .collect()
}

/// Accumulated rows and sums of one θh.
#[derive(Default)]
struct SlabBuilder {
    rows: Vec<CellRow>,
    values: Vec<f32>,
    blocks: usize,
    cells: usize,
    sums: [f64; 3],
    grazing: f64,
    weights: f64,
    /// Unit of the rows' weights, as f32 cannot hold 1e-40.
    unit: f64,
}

impl SlabBuilder {
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
        let mirror_count = grid.phi_d_bins() / PER_ROW;
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
        let measured = |k: usize, mirror: usize| {
            let phi_d = mirrored(phi_d_bins[k], mirror, grid);
            table.cells()[grid.index(theta_h, theta_d, phi_d)]
        };
        let any = (first..cos_phi.len())
            .any(|k| (0..mirror_count).any(|mirror| measured(k, mirror)[0] >= 0.0));
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
            .find(|k| smaller(*k) > GRAZING_THETA.cos())
            .unwrap_or(cos_phi.len())
            - first;
        let count = cos_phi.len() - first;
        let blocks = count.div_ceil(LANES);
        let values_start = self.values.len();
        self.values
            .resize(values_start + 3 * mirror_count * blocks * LANES, ABSENT);
        let row = &mut self.values[values_start..];
        for mirror in 0..mirror_count {
            for k in 0..count {
                let cell = measured(first + k, mirror);
                if cell[0].is_nan() {
                    continue;
                }
                let c = cos_phi[first + k].powi(2);
                let w = self.unit * (w0 + w1 * c);
                self.weights += w;
                self.cells += 1;
                for channel in 0..3 {
                    row[value_index(mirror_count, k, mirror, channel)] = cell[channel];
                    let energy = w * f64::from(cell[channel]);
                    self.sums[channel] += energy;
                    self.grazing += if k < grazing_end { energy } else { 0.0 };
                }
            }
        }
        self.rows.push(CellRow {
            theta_h,
            theta_d,
            first,
            blocks,
            first_block: self.blocks,
            weight: [w0 as f32, w1 as f32],
            grazing_end,
        });
        self.blocks += blocks;
    }
}

/// Solid angle of a bin of θh, up to a factor common to all cells: θd and φd bins have the same width.
fn bin_solid_angle(theta_h: usize) -> f64 {
    let edge = |i: usize| (i as f64 / THETA_H_BINS as f64).powi(2) * FRAC_PI_2;
    // cos a − cos b without cancellation.
    2.0 * (0.5 * (edge(theta_h) + edge(theta_h + 1))).sin()
        * (0.5 * (edge(theta_h + 1) - edge(theta_h))).sin()
}

/// φd bin of a mirror of a symmetric cell: φd, π − φd, and both plus π.
fn mirrored(phi_d: usize, mirror: usize, grid: Grid) -> usize {
    debug_assert!(phi_d < PER_ROW && mirror < grid.phi_d_bins() / PER_ROW);
    let half_turn = 2 * PER_ROW * (mirror / 2);
    half_turn
        + if mirror.is_multiple_of(2) {
            phi_d
        } else {
            2 * PER_ROW - 1 - phi_d
        }
}
