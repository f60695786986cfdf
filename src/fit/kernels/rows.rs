//! SIMD lanes along a row of symmetric cells: lobe, weight, values.

use super::super::lobe_kernel::RowCoefficients;
use super::super::simd::{LANES, Lanes};
use super::super::symmetric_cells::{CellRow, SymmetricCells};
use super::super::threads::Threads;
use pulp::Simd;
use rayon::prelude::*;
use std::ops::Range;

/// The largest f32 below 1.
const BELOW_ONE: f32 = 1.0 - 0.5 * f32::EPSILON;

/// Number of rows that are summed in f32 before they are added in f64.
pub(super) const ROWS_PER_SUM: usize = 6;

/// Runs `work` for every slab and folds the results in the order of the slabs.
pub(super) fn over_slabs<T: Send>(
    cells: &SymmetricCells,
    threads: Threads,
    work: impl Fn(Range<usize>) -> T + Sync + Send,
    mut fold: impl FnMut(T),
) {
    match threads {
        Threads::One => cells.slabs.iter().cloned().map(work).for_each(fold),
        Threads::Many => {
            let parts: Vec<T> = cells.slabs.par_iter().cloned().map(work).collect();
            parts.into_iter().for_each(&mut fold);
        }
    }
}

/// Coefficients of a row, each spread over all lanes.
pub(super) struct RowLanes<S: Simd> {
    versine: [Lanes<S>; 2],
    phong: Lanes<S>,
    blinn: Lanes<S>,
    pub(super) s: Lanes<S>,
    fresnel: Lanes<S>,
    weight: [Lanes<S>; 2],
}

/// Lobe at a vector of cells: R_F · lobe, the logarithm of its base, and the versines of wr·wo and of the base.
pub(super) struct LobeLanes<S: Simd> {
    pub(super) shape: Lanes<S>,
    pub(super) ln: Lanes<S>,
    pub(super) phong: Lanes<S>,
    pub(super) versine: Lanes<S>,
}

impl<S: Simd> RowLanes<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, row: &CellRow, lobe: &RowCoefficients) -> Self {
        let splat = |x: f32| Lanes::splat(simd, x);
        Self {
            versine: lobe.versine.map(splat),
            phong: splat(lobe.phong),
            blinn: splat(lobe.blinn),
            s: splat(lobe.s),
            fresnel: splat(lobe.fresnel),
            weight: row.weight.map(splat),
        }
    }

    #[inline(always)]
    pub(super) fn weight(&self, cos2: Lanes<S>) -> Lanes<S> {
        self.weight[1].mul_add(cos2, self.weight[0])
    }

    #[inline(always)]
    pub(super) fn point(&self, simd: S, cos2: Lanes<S>) -> LobeLanes<S> {
        let one = Lanes::splat(simd, 1.0);
        let phong = self.versine[1].mul_add(cos2, self.versine[0]).min(one);
        let versine = self.phong.mul_add(phong, self.blinn);
        let ln = versine.ln_one_minus();
        let shape = (self.s * ln).exp_negative() * self.fresnel;
        LobeLanes {
            // A cosine of 0 is 0 to every power; with s = 0.1 the smallest base that has a logarithm is not.
            shape: shape.where_le(versine, Lanes::splat(simd, BELOW_ONE)),
            ln,
            phong,
            versine,
        }
    }
}

/// Number of vectors per block.
#[inline(always)]
pub const fn per_block<S: Simd>() -> usize {
    LANES / S::F32_LANES
}

/// Values at the cells of the `vector`-th vector of a row: every [`per_block`]-th element of what is returned.
#[inline(always)]
pub fn block_of<S: Simd, const MIRRORS: usize>(values: &[S::f32s], vector: usize) -> &[S::f32s] {
    let block = 3 * MIRRORS * per_block::<S>();
    let start = vector / per_block::<S>() * block + vector % per_block::<S>();
    &values[start..][..block - per_block::<S>() + 1]
}
