//! Exact minimum of the L1 regression in (ρ_d, k_s), to the last digit, which single cells decide.

use super::amplitudes::{AmplitudeBounds, Amplitudes};
use super::kernels::{block_of, per_block};
use super::simd::{self, Kernel, LANES, Lanes, vectors};
use super::symmetric_cells::{CellRow, SymmetricCells};
use super::vertex_walk::{L1Sum, Observation};
use pulp::Simd;
use rayon::prelude::*;
use std::ops::Range;

/// Initial half width of the band of cells that are looked at one by one, relative to the model.
const BAND: f64 = 2e-4;
/// Largest number of rounds; the band grows fourfold with each.
const ROUNDS: usize = 5;
/// Number of cells in the band above which the model meets the data nearly exactly, and nothing is left to gain.
const MOST_CELLS: usize = 50_000;
/// Number of cells below which all of them are in the band.
const FEW_CELLS: usize = 2000;

/// Amplitudes at the exact minimum of stage 1, from amplitudes `near` it.
///
/// Cells far from the model keep the sign of their residual and enter as two slopes; only those within a narrow band
/// are looked at one by one [Portnoy97]. Amplitudes move only as far as the others keep their signs. A minimum short of
/// that is the minimum over all cells, by convexity; else the band is laid anew from there, and wider.
pub fn solve(
    cells: &SymmetricCells,
    shapes: &[f32],
    near: &Amplitudes,
    limits: &AmplitudeBounds,
) -> Amplitudes {
    let mut at = limits.clamp(*near);
    let few = cells.cell_count < FEW_CELLS;
    let mut band = if few { f64::INFINITY } else { BAND };
    let mut done = [false; 3];
    for _ in 0..ROUNDS {
        let sums = gather(cells, shapes, &at, limits, band, done);
        let moves: Vec<([f64; 2], bool)> = (0..3)
            .into_par_iter()
            .map(|k| {
                let from = at.of(k);
                if done[k] || sums[k].cells.len() > MOST_CELLS {
                    return (from, true);
                }
                let to = sums[k].minimise(from);
                let inside = |i: usize| {
                    let [low, high] = [sums[k].bounds[i].0, sums[k].bounds[i].1];
                    let limit = limits.of(k)[i];
                    (to[i] > low || low == limit.0) && (to[i] < high || high == limit.1)
                };
                (to, inside(0) && inside(1))
            })
            .collect();
        for (k, (to, finished)) in moves.into_iter().enumerate() {
            (at.diffuse[k], at.specular[k]) = (to[0], to[1]);
            done[k] = finished;
        }
        if done == [true; 3] {
            break;
        }
        band *= 4.0;
    }
    at
}

/// Half width of the band where the model is 0.
fn floor(cells: &SymmetricCells, channel: usize) -> f64 {
    1e-3 * cells.energy[channel]
}

/// L1 sum of each channel: cells within the band, slopes of the others, and the bounds within which these hold.
fn gather(
    cells: &SymmetricCells,
    shapes: &[f32],
    at: &Amplitudes,
    limits: &AmplitudeBounds,
    band: f64,
    done: [bool; 3],
) -> [L1Sum; 3] {
    let floor: [f64; 3] = std::array::from_fn(|channel| floor(cells, channel));
    // So that |Δa + Δb·x| ≤ band · (a + b·x + 2 floor), for x is in [0, 1].
    let reach = |channel: usize, k: usize| match k {
        _ if band.is_infinite() => f64::INFINITY,
        0 => band * (at.diffuse[channel] + floor[channel]),
        _ => band * (at.specular[channel] + floor[channel]),
    };
    let bounds = |channel: usize| {
        std::array::from_fn(|k| {
            let (low, high) = limits.of(channel)[k];
            let at = at.of(channel)[k];
            (
                low.max(at - reach(channel, k)),
                high.min(at + reach(channel, k)),
            )
        })
    };
    let empty = || -> [L1Sum; 3] {
        std::array::from_fn(|channel| L1Sum {
            cells: Vec::new(),
            linear: [0.0; 2],
            bounds: bounds(channel),
        })
    };
    let of_slab = |slab: &Range<usize>| {
        simd::dispatch(Gather {
            cells,
            rows: &cells.rows[slab.clone()],
            shapes,
            at,
            band,
            floor,
            done,
            sums: empty(),
        })
    };
    let parts: Vec<[L1Sum; 3]> = cells.slabs.par_iter().map(of_slab).collect();
    let mut sums = empty();
    for part in parts {
        for (sum, part) in sums.iter_mut().zip(part) {
            sum.cells.extend(part.cells);
            (0..2).for_each(|k| sum.linear[k] += part.linear[k]);
        }
    }
    sums
}

/// SIMD pass of [`gather`] over a slab.
struct Gather<'a> {
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    shapes: &'a [f32],
    at: &'a Amplitudes,
    band: f64,
    floor: [f64; 3],
    done: [bool; 3],
    sums: [L1Sum; 3],
}

impl Kernel for Gather<'_> {
    type Output = [L1Sum; 3];
    #[inline(always)]
    fn run<S: Simd>(mut self, simd: S) -> [L1Sum; 3] {
        for channel in (0..3).filter(|channel| !self.done[*channel]) {
            let mut sum = std::mem::take(&mut self.sums[channel]);
            match self.cells.mirror_count {
                2 => self.channel::<S, 2>(simd, channel, &mut sum),
                _ => self.channel::<S, 4>(simd, channel, &mut sum),
            }
            self.sums[channel] = sum;
        }
        self.sums
    }
}

impl Gather<'_> {
    #[inline(always)]
    fn channel<S: Simd, const MIRRORS: usize>(&self, simd: S, channel: usize, sum: &mut L1Sum) {
        let splat = |x: f32| Lanes::splat(simd, x);
        let zero = splat(0.0);
        let [a, b] = self.at.of(channel).map(|x| splat(x as f32));
        let (band, floor) = if self.band.is_infinite() {
            (zero, splat(f32::MAX))
        } else {
            let floor = 2.0 * self.band * self.floor[channel];
            (splat(self.band as f32), splat(floor as f32))
        };
        for row in self.rows {
            let [w0, w1] = row.weight.map(splat);
            let shapes = &self.shapes[row.first_block * LANES..][..row.blocks * LANES];
            let cos2 = vectors::<S>(self.cells.cos2_of(row));
            let values = vectors::<S>(self.cells.values_of(row));
            let mut linear = [zero; 2];
            let mut in_band = zero;
            for (vector, (cos2, x)) in cos2.iter().zip(vectors::<S>(shapes)).enumerate() {
                let x = Lanes::new(simd, *x);
                let weight = w1.mul_add(Lanes::new(simd, *cos2), w0);
                let model = b.mul_add(x, a);
                let width = band.mul_add(model, floor);
                let values = block_of::<S, MIRRORS>(values, vector);
                for mirror in 0..MIRRORS {
                    let plane = (3 * mirror + channel) * per_block::<S>();
                    let r = model - Lanes::new(simd, values[plane]);
                    let present = weight.where_le(zero, Lanes::new(simd, values[plane]));
                    let near = present.where_le(r.abs(), width);
                    let slope = (present - near).with_sign_of(r);
                    linear[0] = linear[0] + slope;
                    linear[1] = slope.mul_add(x, linear[1]);
                    in_band = in_band + near;
                }
            }
            (0..2).for_each(|k| sum.linear[k] += linear[k].total());
            // Seldom, so the row is looked at again rather than every vector of it asked at once.
            if in_band.total() <= 0.0 {
                continue;
            }
            for (vector, (cos2, x)) in cos2.iter().zip(vectors::<S>(shapes)).enumerate() {
                let x = Lanes::new(simd, *x);
                let weight = w1.mul_add(Lanes::new(simd, *cos2), w0);
                let model = b.mul_add(x, a);
                let width = band.mul_add(model, floor);
                let values = block_of::<S, MIRRORS>(values, vector);
                for mirror in 0..MIRRORS {
                    let plane = (3 * mirror + channel) * per_block::<S>();
                    let measured = Lanes::new(simd, values[plane]);
                    let present = weight.where_le(zero, measured);
                    let near = present.where_le((model - measured).abs(), width);
                    for lane in (0..S::F32_LANES).filter(|lane| near.lanes()[*lane] > 0.0) {
                        sum.cells.push(Observation {
                            x: x.lanes()[lane].into(),
                            f: measured.lanes()[lane].into(),
                            w: near.lanes()[lane].into(),
                        });
                    }
                }
            }
        }
    }
}
