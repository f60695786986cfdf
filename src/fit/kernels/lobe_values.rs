//! The specular shape R_F · lobe at every symmetric cell.

use super::super::lobes::LobeKernel;
use super::super::simd::LANES;
use super::super::symmetric_cells::SymmetricCells;
use super::super::threads::Threads;
use rayon::prelude::*;

/// R_F · lobe at every symmetric cell, on all threads.
pub fn shapes(lobe: &dyn LobeKernel, cells: &SymmetricCells) -> Vec<f32> {
    let mut shapes = Vec::new();
    fill(lobe, cells, &mut shapes, Threads::Many);
    shapes
}

/// Writes R_F · lobe at every symmetric cell into `shapes`.
pub fn fill(
    lobe: &dyn LobeKernel,
    cells: &SymmetricCells,
    shapes: &mut Vec<f32>,
    threads: Threads,
) {
    shapes.resize(cells.blocks * LANES, 0.0);
    let mut rest = &mut shapes[..];
    let mut slabs = Vec::with_capacity(cells.slabs.len());
    for slab in &cells.slabs {
        let rows = &cells.rows[slab.clone()];
        let blocks: usize = rows.iter().map(|row| row.blocks).sum();
        let (out, after) = rest.split_at_mut(blocks * LANES);
        rest = after;
        slabs.push((rows, out));
    }
    let work = |(rows, out): (&[_], &mut [f32])| lobe.shapes(cells, rows, out);
    match threads {
        Threads::One => slabs.into_iter().for_each(work),
        Threads::Many => slabs.into_par_iter().for_each(work),
    }
}
