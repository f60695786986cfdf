//! Kernels of E and its gradient in the variables of the search.

use super::super::amplitudes::Amplitudes;
use super::super::lobe_kernel::LobeKernel;
use super::super::simd::{self, Kernel, Lanes, vectors};
use super::super::symmetric_cells::{CellRow, SymmetricCells};
use super::super::threads::Threads;
use super::rows::{ROWS_PER_SUM, RowLanes, block_of, over_slabs, per_block};
use pulp::Simd;
use std::ops::Range;

/// E and its gradient in (ln s, α, ln(η − 1)) with the amplitudes held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorGradient {
    /// E = Σ w |f̂ − f| / Σ w f, both sums over all channels.
    pub error: f64,
    /// Gradient of E; 0 where it was not asked for.
    pub gradient: [f64; 3],
}

struct ErrorPass<'a, const GRADIENT: bool> {
    lobe: &'a LobeKernel,
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
        let mut slopes = ErrorGradient::default();
        for rows in self.rows.chunks(ROWS_PER_SUM) {
            let [mut error, mut by_s, mut by_alpha] = [zero; 3];
            for row in rows {
                let lobe = self.lobe.row(row);
                let lanes = RowLanes::new(simd, row, &lobe);
                let versine4 = splat(lobe.versine4);
                let mut by_eta = zero;
                let values = vectors::<S>(self.cells.values_of(row));
                for (vector, cos2) in vectors::<S>(self.cells.cos2_of(row)).iter().enumerate() {
                    let cos2 = Lanes::new(simd, *cos2);
                    let point = lanes.point(simd, cos2);
                    let weight = lanes.weight(cos2);
                    let mut by_shape = zero;
                    let values = block_of::<S, MIRRORS>(values, vector);
                    for mirror in 0..MIRRORS {
                        let measured: [_; 3] = std::array::from_fn(|channel| {
                            Lanes::new(simd, values[(3 * mirror + channel) * per_block::<S>()])
                        });
                        let weight = weight.where_le(zero, measured[0]);
                        for channel in 0..3 {
                            let model = specular[channel].mul_add(point.shape, diffuse[channel]);
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
                        let by_ln_shape = by_shape * point.shape;
                        by_eta = by_eta + by_ln_shape;
                        let by_ln_base = by_ln_shape * lanes.s;
                        by_s = by_ln_base.mul_add(point.ln, by_s);
                        // d ln(1 − v)/dα with v the versine of the base; at a base of 0 the slope has no bound.
                        let base = (splat(1.0) - point.versine).max(splat(1e-3));
                        by_alpha = by_ln_base.mul_add((point.phong - versine4) / base, by_alpha);
                    }
                }
                if GRADIENT {
                    slopes.gradient[2] += by_eta.total() * lobe.fresnel_slope;
                }
            }
            slopes.error += error.total();
            if GRADIENT {
                slopes.gradient[0] += by_s.total();
                slopes.gradient[1] += by_alpha.total();
            }
        }
        slopes
    }
}

/// E of a model: one pass over all cells. This is what the benchmarks call an objective pass.
pub fn error(
    lobe: &LobeKernel,
    cells: &SymmetricCells,
    amplitudes: &Amplitudes,
    threads: Threads,
) -> f64 {
    pass::<false>(lobe, cells, amplitudes, 0.0, threads).error
}

/// E with its gradient. `band` is the half width, relative to the model, of the band in which the sign of residuals is
/// softened.
pub fn slopes(
    lobe: &LobeKernel,
    cells: &SymmetricCells,
    amplitudes: &Amplitudes,
    band: f64,
    threads: Threads,
) -> ErrorGradient {
    pass::<true>(lobe, cells, amplitudes, band as f32, threads)
}

fn pass<const GRADIENT: bool>(
    lobe: &LobeKernel,
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
        (0..3).for_each(|k| sum.gradient[k] += part.gradient[k]);
    });
    sum
}
