//! Kernels of E and its gradient in the variables of the search.

use super::super::amplitudes::Amplitudes;
use super::super::lobes::{CELLS_PER_SUM, LobeKernel, RowSlopes};
use super::super::simd::{self, Kernel, Lanes, vectors};
use super::super::symmetric_cells::{CellRow, ROWS_PER_SUM, SymmetricCells};
use super::super::threads::Threads;
use super::super::variables::VARIABLES;
use super::rows::{block_of, over_slabs, per_block, where_measured};
use pulp::Simd;
use std::ops::Range;

/// E and its gradient in the variables of the search with the amplitudes held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorGradient {
    /// E = Σ w |f̂ − f| / Σ w f, both sums over all channels.
    pub error: f64,
    /// Gradient of E; 0 where it was not asked for.
    pub gradient: [f64; VARIABLES],
}

struct ErrorPass<'a, const GRADIENT: bool> {
    lobe: &'a dyn LobeKernel,
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    amplitudes: &'a Amplitudes,
    band: f32,
}

impl<const GRADIENT: bool> Kernel for ErrorPass<'_, GRADIENT> {
    type Output = ErrorGradient;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> ErrorGradient {
        match self.cells.mirror_count {
            2 => self.sum::<S, 2>(simd),
            _ => self.sum::<S, 4>(simd),
        }
    }
}

impl<const GRADIENT: bool> ErrorPass<'_, GRADIENT> {
    #[inline(always)]
    fn sum<S: Simd, const MIRRORS: usize>(self, simd: S) -> ErrorGradient {
        let splat = |x: f32| Lanes::splat(simd, x);
        let zero = splat(0.0);
        let diffuse = self.amplitudes.diffuse.map(|a| splat(a as f32));
        let specular = self.amplitudes.specular.map(|b| splat(b as f32));
        let band = splat(self.band);
        let smallest = splat(f32::MIN_POSITIVE);
        let one = splat(1.0);
        let mut shapes = [0.0; CELLS_PER_SUM];
        let mut slopes = RowSlopes::default();
        // ∂E / ∂ ln shape per cell.
        let mut by_ln_shapes = [0.0; CELLS_PER_SUM];
        let mut sums = ErrorGradient::default();
        for rows in self.rows.chunks(ROWS_PER_SUM) {
            if GRADIENT {
                let slopes = &mut slopes;
                self.lobe.slopes(self.cells, rows, &mut shapes, slopes);
            } else {
                self.lobe.shapes(self.cells, rows, &mut shapes);
            }
            let mut error = zero;
            let mut done = 0;
            for (row, constant) in rows.iter().zip(&slopes.constant) {
                let [w0, w1] = row.weight.map(splat);
                let values = vectors::<S>(self.cells.values_of(row));
                let cos2 = vectors::<S>(self.cells.cos2_of(row));
                // As long as each other: nothing is checked in the loop.
                let shapes = &vectors::<S>(&shapes)[done..][..cos2.len()];
                let by_ln_shapes = &mut S::as_mut_simd_f32s(&mut by_ln_shapes).0[done..];
                done += cos2.len();
                let mut by_ln_shape_of_row = zero;
                let pairs = shapes.iter().zip(cos2).zip(by_ln_shapes);
                for (vector, ((shape, cos2), by_ln_shape)) in pairs.enumerate() {
                    let shape = Lanes::new(simd, *shape);
                    let weight = w1.mul_add(Lanes::new(simd, *cos2), w0);
                    let mut by_shape = zero;
                    let values = block_of::<S, MIRRORS>(values, vector);
                    for mirror in 0..MIRRORS {
                        let measured: [_; 3] = std::array::from_fn(|channel| {
                            Lanes::new(simd, values[(3 * mirror + channel) * per_block::<S>()])
                        });
                        let weight = where_measured(weight, measured[0], zero);
                        let (mut size, mut slope) = (zero, zero);
                        for channel in 0..3 {
                            // The same for every mirror, and so computed once.
                            let model = specular[channel].mul_add(shape, diffuse[channel]);
                            let r = model - measured[channel];
                            size = size + r.abs();
                            if GRADIENT {
                                // The sign of the residual, softened over a narrow band around 0.
                                let steep = one / band.mul_add(model, smallest);
                                let sign = (r * steep).min(one).max(zero - one);
                                slope = specular[channel].mul_add(sign, slope);
                            }
                        }
                        error = weight.mul_add(size, error);
                        if GRADIENT {
                            by_shape = weight.mul_add(slope, by_shape);
                        }
                    }
                    if GRADIENT {
                        let by_ln = by_shape * shape;
                        *by_ln_shape = by_ln.vector();
                        by_ln_shape_of_row = by_ln_shape_of_row + by_ln;
                    }
                }
                if GRADIENT {
                    let total = by_ln_shape_of_row.total();
                    for (sum, slope) in sums.gradient.iter_mut().zip(constant) {
                        *sum += total * slope;
                    }
                }
            }
            if GRADIENT {
                let by_ln_shapes = &vectors::<S>(&by_ln_shapes)[..done];
                for (variable, slopes) in self.lobe.varying().iter().zip(&slopes.varying) {
                    let mut sum = zero;
                    for (by_ln_shape, slope) in by_ln_shapes.iter().zip(vectors::<S>(slopes)) {
                        let by_ln_shape = Lanes::new(simd, *by_ln_shape);
                        sum = by_ln_shape.mul_add(Lanes::new(simd, *slope), sum);
                    }
                    sums.gradient[*variable] += sum.total();
                }
            }
            sums.error += error.total();
        }
        sums
    }
}

/// E of a model: one pass over all cells. This is what the benchmarks call an objective pass.
pub fn error(
    lobe: &dyn LobeKernel,
    cells: &SymmetricCells,
    amplitudes: &Amplitudes,
    threads: Threads,
) -> f64 {
    pass::<false>(lobe, cells, amplitudes, 0.0, threads).error
}

/// E with its gradient. `band` is the half width, relative to the model, of the band in which the sign of residuals is
/// softened.
pub fn slopes(
    lobe: &dyn LobeKernel,
    cells: &SymmetricCells,
    amplitudes: &Amplitudes,
    band: f64,
    threads: Threads,
) -> ErrorGradient {
    pass::<true>(lobe, cells, amplitudes, band as f32, threads)
}

fn pass<const GRADIENT: bool>(
    lobe: &dyn LobeKernel,
    cells: &SymmetricCells,
    amplitudes: &Amplitudes,
    band: f32,
    threads: Threads,
) -> ErrorGradient {
    let work = |slab: Range<usize>| {
        simd::dispatch(ErrorPass::<GRADIENT> {
            lobe,
            cells,
            rows: &cells.rows[slab],
            amplitudes,
            band,
        })
    };
    let mut sum = ErrorGradient::default();
    over_slabs(cells, threads, work, |part| {
        sum.error += part.error;
        (0..VARIABLES).for_each(|k| sum.gradient[k] += part.gradient[k]);
    });
    sum
}
