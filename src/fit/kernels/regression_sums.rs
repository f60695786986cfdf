//! Kernel of the sums from which the regression of stage 1 takes its steps.

use super::super::amplitudes::Amplitudes;
use super::super::simd::{self, Kernel, LANES, Lanes, vectors};
use super::super::symmetric_cells::{CellRow, ROWS_PER_SUM, SymmetricCells};
use super::super::threads::Threads;
use super::rows::{block_of, over_slabs, per_block, where_measured};
use pulp::Simd;
use std::ops::Range;

/// Sums of one channel's regression at (a, b) over its cells, with w the weight and x = R_F · lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChannelSums {
    /// Σ w |r|
    pub error: f64,
    /// Gradient in (a, b) of Σ w ρ(r), where ρ is |r|, rounded off within the band.
    pub slope: [f64; 2],
    /// Second derivatives (aa, ab, bb): Σ w/band over the residuals within the band.
    pub curvature: [f64; 3],
    /// Second derivatives (aa, ab, bb) of a quadratic majorant: Σ w/max(|r|, band).
    pub majorant: [f64; 3],
}

struct RegressionPass<'a> {
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    shapes: &'a [f32],
    amplitudes: &'a Amplitudes,
    bands: [f32; 3],
    floor: [f32; 3],
    wanted: [bool; 3],
}

impl Kernel for RegressionPass<'_> {
    type Output = [ChannelSums; 3];
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [ChannelSums; 3] {
        match self.cells.mirror_count {
            2 => self.sum::<S, 2>(simd),
            _ => self.sum::<S, 4>(simd),
        }
    }
}

impl RegressionPass<'_> {
    #[inline(always)]
    fn sum<S: Simd, const MIRRORS: usize>(self, simd: S) -> [ChannelSums; 3] {
        let splat = |x: f32| Lanes::splat(simd, x);
        let zero = splat(0.0);
        let mut sums = [ChannelSums::default(); 3];
        for (channel, sum) in sums.iter_mut().enumerate() {
            if !self.wanted[channel] {
                continue;
            }
            let a = splat(self.amplitudes.diffuse[channel] as f32);
            let b = splat(self.amplitudes.specular[channel] as f32);
            let (band, floor) = (splat(self.bands[channel]), splat(self.floor[channel]));
            for rows in self.rows.chunks(ROWS_PER_SUM) {
                let mut error = zero;
                let mut slope = [zero; 2];
                let [mut curvature, mut majorant] = [[zero; 3]; 2];
                for row in rows {
                    let [w0, w1] = row.weight.map(splat);
                    let shapes = &self.shapes[row.first_block * LANES..][..row.blocks * LANES];
                    let cos2 = vectors::<S>(self.cells.cos2_of(row));
                    let values = vectors::<S>(self.cells.values_of(row));
                    for (vector, (cos2, x)) in cos2.iter().zip(vectors::<S>(shapes)).enumerate() {
                        let x = Lanes::new(simd, *x);
                        let weight = w1.mul_add(Lanes::new(simd, *cos2), w0);
                        let model = b.mul_add(x, a);
                        let width = band.mul_add(model, floor);
                        let [mut by_a, mut inside, mut all] = [zero; 3];
                        let values = block_of::<S, MIRRORS>(values, vector);
                        for mirror in 0..MIRRORS {
                            let plane = (3 * mirror + channel) * per_block::<S>();
                            let measured = Lanes::new(simd, values[plane]);
                            let weight = where_measured(weight, measured, zero);
                            let r = model - measured;
                            let size = r.abs();
                            error = weight.mul_add(size, error);
                            let w = weight / size.max(width);
                            by_a = w.mul_add(r, by_a);
                            all = all + w;
                            inside = inside + w.where_le(size, width);
                        }
                        slope[0] = slope[0] + by_a;
                        slope[1] = by_a.mul_add(x, slope[1]);
                        for (sums, w) in [(&mut curvature, inside), (&mut majorant, all)] {
                            let wx = w * x;
                            sums[0] = sums[0] + w;
                            sums[1] = sums[1] + wx;
                            sums[2] = wx.mul_add(x, sums[2]);
                        }
                    }
                }
                sum.error += error.total();
                (0..2).for_each(|k| sum.slope[k] += slope[k].total());
                (0..3).for_each(|k| sum.curvature[k] += curvature[k].total());
                (0..3).for_each(|k| sum.majorant[k] += majorant[k].total());
            }
        }
        sums
    }
}

/// Sums of the wanted channels at these amplitudes, 0 of the others. A channel's band is `bands · f̂ + floor`, f̂ its
/// model.
pub fn regression(
    cells: &SymmetricCells,
    shapes: &[f32],
    amplitudes: &Amplitudes,
    bands: [f64; 3],
    floor: [f64; 3],
    wanted: [bool; 3],
    threads: Threads,
) -> [ChannelSums; 3] {
    let work = |slab: Range<usize>| {
        simd::dispatch(RegressionPass {
            cells,
            rows: &cells.rows[slab],
            shapes,
            amplitudes,
            bands: bands.map(|x| x as f32),
            floor: floor.map(|x| x as f32),
            wanted,
        })
    };
    let mut sums = [ChannelSums::default(); 3];
    over_slabs(cells, threads, work, |part| {
        for (sum, part) in sums.iter_mut().zip(part) {
            sum.error += part.error;
            (0..2).for_each(|k| sum.slope[k] += part.slope[k]);
            (0..3).for_each(|k| sum.curvature[k] += part.curvature[k]);
            (0..3).for_each(|k| sum.majorant[k] += part.majorant[k]);
        }
    });
    sums
}
