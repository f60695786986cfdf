//! Kernel of the specular shape R_F · lobe at every symmetric cell.

use super::super::lobe_kernel::LobeKernel;
use super::super::simd::{self, Kernel, LANES, Lanes, vectors};
use super::super::symmetric_cells::{CellRow, SymmetricCells};
use super::super::threads::Threads;
use super::rows::RowLanes;
use pulp::Simd;
use rayon::prelude::*;

/// R_F · lobe at every symmetric cell, on all threads.
pub fn shapes(lobe: &LobeKernel, cells: &SymmetricCells) -> Vec<f32> {
    let mut shapes = Vec::new();
    fill(lobe, cells, &mut shapes, Threads::Many);
    shapes
}

struct Fill<'a> {
    lobe: &'a LobeKernel,
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    out: &'a mut [f32],
}

impl Kernel for Fill<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let mut out = S::as_mut_simd_f32s(self.out).0.iter_mut();
        for row in self.rows {
            let lanes = RowLanes::new(simd, row, &self.lobe.row(row));
            for (cos2, out) in vectors::<S>(self.cells.cos2_of(row)).iter().zip(&mut out) {
                *out = lanes.point(simd, Lanes::new(simd, *cos2)).shape.vector();
            }
        }
    }
}

/// Writes R_F · lobe at every symmetric cell into `shapes`.
pub fn fill(lobe: &LobeKernel, cells: &SymmetricCells, shapes: &mut Vec<f32>, threads: Threads) {
    shapes.resize(cells.blocks * LANES, 0.0);
    let mut rest = &mut shapes[..];
    let mut work = Vec::with_capacity(cells.slabs.len());
    for slab in &cells.slabs {
        let rows = &cells.rows[slab.clone()];
        let blocks: usize = rows.iter().map(|row| row.blocks).sum();
        let (out, after) = rest.split_at_mut(blocks * LANES);
        rest = after;
        work.push(Fill {
            lobe,
            cells,
            rows,
            out,
        });
    }
    match threads {
        Threads::One => work.into_iter().for_each(simd::dispatch),
        Threads::Many => work.into_par_iter().for_each(simd::dispatch),
    }
}
