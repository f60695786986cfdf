//! Kernels of E and its gradient in the variables of the search.

use super::super::amplitudes::Amplitudes;
use super::super::lobes::{LobeKernel, RowSlopes};
use super::super::simd::{self, Kernel, Lanes, vectors};
use super::super::symmetric_cells::{CellRow, ROW_CELLS, SymmetricCells};
use super::super::threads::Threads;
use super::super::variables::VARIABLES;
use super::rows::{ROWS_PER_SUM, block_of, over_slabs, per_block};
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
        let mut shapes = [0.0; ROW_CELLS];
        let mut slopes = RowSlopes::default();
        // ∂E / ∂ ln shape per cell of the row.
        let mut by_ln_shapes = [0.0; ROW_CELLS];
        let mut sums = ErrorGradient::default();
        for rows in self.rows.chunks(ROWS_PER_SUM) {
            let mut error = zero;
            for row in rows {
                let cos2 = self.cells.cos2_of(row);
                let shapes = &mut shapes[..cos2.len()];
                if GRADIENT {
                    self.lobe.slopes(row, cos2, shapes, &mut slopes);
                } else {
                    self.lobe.shapes(row, cos2, shapes);
                }
                let [w0, w1] = row.weight.map(splat);
                let values = vectors::<S>(self.cells.values_of(row));
                let by_ln_shapes = &mut S::as_mut_simd_f32s(&mut by_ln_shapes).0;
                let by_ln_shapes = &mut by_ln_shapes[..cos2.len() / S::F32_LANES];
                let pairs = vectors::<S>(shapes).iter().zip(vectors::<S>(cos2));
                let pairs = pairs.zip(by_ln_shapes.iter_mut());
                for (vector, ((shape, cos2), by_ln_shape)) in pairs.enumerate() {
                    let shape = Lanes::new(simd, *shape);
                    let weight = w1.mul_add(Lanes::new(simd, *cos2), w0);
                    let mut by_shape = zero;
                    let values = block_of::<S, MIRRORS>(values, vector);
                    for mirror in 0..MIRRORS {
                        let measured: [_; 3] = std::array::from_fn(|channel| {
                            Lanes::new(simd, values[(3 * mirror + channel) * per_block::<S>()])
                        });
                        let weight = weight.where_le(zero, measured[0]);
                        for channel in 0..3 {
                            let model = specular[channel].mul_add(shape, diffuse[channel]);
                            let size = (model - measured[channel]).abs();
                            error = weight.mul_add(size, error);
                            if GRADIENT {
                                // The sign of the residual, softened over a narrow band around 0.
                                let width = band.mul_add(model, smallest);
                                let sign = (model - measured[channel]) / size.max(width);
                                by_shape = (weight * specular[channel]).mul_add(sign, by_shape);
                            }
                        }
                    }
                    if GRADIENT {
                        *by_ln_shape = (by_shape * shape).vector();
                    }
                }
                if GRADIENT {
                    let mut total = zero;
                    for by_ln_shape in by_ln_shapes.iter() {
                        total = total + Lanes::new(simd, *by_ln_shape);
                    }
                    let total = total.total();
                    for (sum, slope) in sums.gradient.iter_mut().zip(slopes.constant) {
                        *sum += total * slope;
                    }
                    for (variable, slopes) in self.lobe.varying().iter().zip(&slopes.varying) {
                        let mut sum = zero;
                        for (by_ln_shape, slope) in by_ln_shapes.iter().zip(vectors::<S>(slopes)) {
                            let by_ln_shape = Lanes::new(simd, *by_ln_shape);
                            sum = by_ln_shape.mul_add(Lanes::new(simd, *slope), sum);
                        }
                        sums.gradient[*variable] += sum.total();
                    }
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
