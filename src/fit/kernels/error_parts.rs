//! Kernel of the error per channel and of the grazing cells.

use super::super::amplitudes::Amplitudes;
use super::super::lobes::{CELLS_PER_SUM, LobeKernel};
use super::super::simd::{self, Kernel, LANES, Lanes, vectors};
use super::super::symmetric_cells::{CellRow, ROWS_PER_SUM, SymmetricCells};
use super::super::threads::Threads;
use super::rows::{block_of, over_slabs, per_block, where_measured};
use pulp::Simd;
use std::ops::Range;

/// Parts of Σ w |f̂ − f|, normalised so that Σ w f over all cells and channels is 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// Sum over all cells, per channel.
    pub channels: [f64; 3],
    /// Sum over the grazing cells, all channels.
    pub grazing: f64,
}

struct PartsPass<'a> {
    lobe: &'a dyn LobeKernel,
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    amplitudes: &'a Amplitudes,
}

impl Kernel for PartsPass<'_> {
    type Output = Parts;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Parts {
        match self.cells.mirror_count {
            2 => self.sum::<S, 2>(simd),
            _ => self.sum::<S, 4>(simd),
        }
    }
}

impl PartsPass<'_> {
    #[inline(always)]
    fn sum<S: Simd, const MIRRORS: usize>(self, simd: S) -> Parts {
        let splat = |x: f32| Lanes::splat(simd, x);
        let zero = splat(0.0);
        let diffuse = self.amplitudes.diffuse.map(|a| splat(a as f32));
        let specular = self.amplitudes.specular.map(|b| splat(b as f32));
        let places: [f32; LANES] = std::array::from_fn(|lane| lane as f32);
        let places = Lanes::new(simd, vectors::<S>(&places)[0]);
        let mut shapes = [0.0; CELLS_PER_SUM];
        let mut parts = Parts::default();
        for rows in self.rows.chunks(ROWS_PER_SUM) {
            self.lobe.shapes(self.cells, rows, &mut shapes);
            let mut shapes = vectors::<S>(&shapes).iter();
            let mut channels = [zero; 3];
            let mut grazing = zero;
            for row in rows {
                let [w0, w1] = row.weight.map(splat);
                let values = vectors::<S>(self.cells.values_of(row));
                // Cells first: the iterator of what remains then ends with the row.
                let pairs = vectors::<S>(self.cells.cos2_of(row))
                    .iter()
                    .zip(&mut shapes);
                for (vector, (cos2, shape)) in pairs.enumerate() {
                    let shape = Lanes::new(simd, *shape);
                    let weight = w1.mul_add(Lanes::new(simd, *cos2), w0);
                    let values = block_of::<S, MIRRORS>(values, vector);
                    let mut here = [zero; 3];
                    for mirror in 0..MIRRORS {
                        for channel in 0..3 {
                            let plane = (3 * mirror + channel) * per_block::<S>();
                            let measured = Lanes::new(simd, values[plane]);
                            let weight = where_measured(weight, measured, zero);
                            let model = specular[channel].mul_add(shape, diffuse[channel]);
                            here[channel] = weight.mul_add((model - measured).abs(), here[channel]);
                        }
                    }
                    (0..3).for_each(|k| channels[k] = channels[k] + here[k]);
                    let first = (vector * S::F32_LANES) as f32;
                    let last = splat(row.grazing_end as f32 - 1.0 - first);
                    let all = here[0] + here[1] + here[2];
                    grazing = grazing + all.where_le(places, last);
                }
            }
            (0..3).for_each(|k| parts.channels[k] += channels[k].total());
            parts.grazing += grazing.total();
        }
        parts
    }
}

/// Parts of E of a model: one pass over all cells.
pub fn parts(
    lobe: &dyn LobeKernel,
    cells: &SymmetricCells,
    amplitudes: &Amplitudes,
    threads: Threads,
) -> Parts {
    let work = |slab: Range<usize>| {
        simd::dispatch(PartsPass {
            lobe,
            cells,
            rows: &cells.rows[slab],
            amplitudes,
        })
    };
    let mut sum = Parts::default();
    over_slabs(cells, threads, work, |part| {
        (0..3).for_each(|k| sum.channels[k] += part.channels[k]);
        sum.grazing += part.grazing;
    });
    sum
}
