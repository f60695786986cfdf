//! Slabs of rows spread over threads, and the values along a row: the common ground of the passes.

use super::super::simd::{LANES, Lanes};
use super::super::symmetric_cells::SymmetricCells;
use super::super::threads::Threads;
use pulp::Simd;
use rayon::prelude::*;
use std::ops::Range;

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

/// Weight where a value is measured, 0 where it is absent: [`ABSENT`](super::super::symmetric_cells::ABSENT) is −1, and
/// no other is below 0.
#[inline(always)]
pub(super) fn where_measured<S: Simd>(
    weight: Lanes<S>,
    value: Lanes<S>,
    zero: Lanes<S>,
) -> Lanes<S> {
    weight.mul_add(value.min(zero), weight)
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
