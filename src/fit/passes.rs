//! The passes over all sites: the shape, the error with its slopes, the sums that the regression needs.
//!
//! Sums are in f32 over a few rows, in f64 beyond; the parts are those of the θh slabs and are added in their order,
//! so that the number of threads changes nothing.

mod parts;
mod sums;

pub use parts::parts;
pub use sums::{ChannelSums, regression};

use super::lanes::{self, Kernel, LANES, Lanes, vectors};
use super::shape::{Lobe, RowLobe, Threads};
use super::sites::{Row, Sites};
use pulp::Simd;
use rayon::prelude::*;
use std::ops::Range;

/// Diffuse and specular amplitudes per channel, in units of [`Sites::scale`]: ρ_d/π and k_s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amplitudes {
    /// ρ_d/π
    pub diffuse: [f64; 3],
    /// k_s
    pub specular: [f64; 3],
}

impl Amplitudes {
    /// Both of a channel.
    #[inline(always)]
    pub fn of(&self, channel: usize) -> [f64; 2] {
        [self.diffuse[channel], self.specular[channel]]
    }
}

/// The largest f32 below 1.
const BELOW_ONE: f32 = 1.0 - 0.5 * f32::EPSILON;

/// Rows that are summed in f32 before they are added to the rest.
const ROWS_PER_SUM: usize = 6;

/// Runs `work` for every slab and folds what it returns in their order.
fn over_slabs<T: Send>(
    sites: &Sites,
    threads: Threads,
    work: impl Fn(Range<usize>) -> T + Sync + Send,
    mut fold: impl FnMut(T),
) {
    match threads {
        Threads::One => sites.slabs.iter().cloned().map(work).for_each(fold),
        Threads::Many => {
            let parts: Vec<T> = sites.slabs.par_iter().cloned().map(work).collect();
            parts.into_iter().for_each(&mut fold);
        }
    }
}

/// What the lanes of a row have in common, spread over them.
struct RowLanes<S: Simd> {
    versine: [Lanes<S>; 2],
    phong: Lanes<S>,
    blinn: Lanes<S>,
    s: Lanes<S>,
    fresnel: Lanes<S>,
    weight: [Lanes<S>; 2],
}

/// The lobe at a few sites: R_F · lobe, the logarithm of its base, and the versine of wr·wo and of the base.
struct Point<S: Simd> {
    shape: Lanes<S>,
    ln: Lanes<S>,
    phong: Lanes<S>,
    versine: Lanes<S>,
}

impl<S: Simd> RowLanes<S> {
    #[inline(always)]
    fn new(simd: S, row: &Row, lobe: &RowLobe) -> Self {
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
    fn weight(&self, cos2: Lanes<S>) -> Lanes<S> {
        self.weight[1].mul_add(cos2, self.weight[0])
    }

    #[inline(always)]
    fn point(&self, simd: S, cos2: Lanes<S>) -> Point<S> {
        let one = Lanes::splat(simd, 1.0);
        let phong = self.versine[1].mul_add(cos2, self.versine[0]).min(one);
        let versine = self.phong.mul_add(phong, self.blinn);
        let ln = versine.ln_one_minus();
        let shape = (self.s * ln).exp_negative() * self.fresnel;
        Point {
            // A cosine of 0 is 0 to every power; with s = 0.1 the smallest base that has a logarithm is not.
            shape: shape.where_le(versine, Lanes::splat(simd, BELOW_ONE)),
            ln,
            phong,
            versine,
        }
    }
}

/// Vectors per block.
#[inline(always)]
pub const fn per_block<S: Simd>() -> usize {
    LANES / S::F32_LANES
}

/// The values at the sites of the `vector`-th vector of a row: every [`per_block`]-th of what is returned.
#[inline(always)]
pub fn block_of<S: Simd, const COPIES: usize>(values: &[S::f32s], vector: usize) -> &[S::f32s] {
    let block = 3 * COPIES * per_block::<S>();
    let start = vector / per_block::<S>() * block + vector % per_block::<S>();
    &values[start..][..block - per_block::<S>() + 1]
}

struct Fill<'a> {
    lobe: &'a Lobe,
    sites: &'a Sites,
    rows: &'a [Row],
    out: &'a mut [f32],
}

impl Kernel for Fill<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let mut out = S::as_mut_simd_f32s(self.out).0.iter_mut();
        for row in self.rows {
            let lanes = RowLanes::new(simd, row, &self.lobe.row(row));
            for (cos2, out) in vectors::<S>(self.sites.cos2_of(row)).iter().zip(&mut out) {
                *out = lanes.point(simd, Lanes::new(simd, *cos2)).shape.vector();
            }
        }
    }
}

/// R_F · lobe at every site, into `shapes`.
pub fn fill(lobe: &Lobe, sites: &Sites, shapes: &mut Vec<f32>, threads: Threads) {
    shapes.resize(sites.blocks * LANES, 0.0);
    let mut rest = &mut shapes[..];
    let mut work = Vec::with_capacity(sites.slabs.len());
    for slab in &sites.slabs {
        let rows = &sites.rows[slab.clone()];
        let blocks: usize = rows.iter().map(|row| row.blocks).sum();
        let (out, after) = rest.split_at_mut(blocks * LANES);
        rest = after;
        work.push(Fill {
            lobe,
            sites,
            rows,
            out,
        });
    }
    match threads {
        Threads::One => work.into_iter().for_each(lanes::dispatch),
        Threads::Many => work.into_par_iter().for_each(lanes::dispatch),
    }
}

/// E and its slopes in (ln s, α, ln(η − 1)) with the amplitudes held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slopes {
    /// Σ w |f̂ − f| / Σ w f, all channels over all channels.
    pub error: f64,
    /// Its gradient; 0 unless asked for.
    pub gradient: [f64; 3],
}

struct ErrorPass<'a, const GRADIENT: bool> {
    lobe: &'a Lobe,
    sites: &'a Sites,
    rows: &'a [Row],
    amplitudes: &'a Amplitudes,
    band: f32,
}

impl<const GRADIENT: bool> Kernel for ErrorPass<'_, GRADIENT> {
    type Output = Slopes;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Slopes {
        match self.sites.copies {
            2 => self.sum::<S, 2>(simd),
            _ => self.sum::<S, 4>(simd),
        }
    }
}

impl<const GRADIENT: bool> ErrorPass<'_, GRADIENT> {
    #[inline(always)]
    fn sum<S: Simd, const COPIES: usize>(self, simd: S) -> Slopes {
        let splat = |x: f32| Lanes::splat(simd, x);
        let zero = splat(0.0);
        let diffuse = self.amplitudes.diffuse.map(|a| splat(a as f32));
        let specular = self.amplitudes.specular.map(|b| splat(b as f32));
        let band = splat(self.band);
        let smallest = splat(f32::MIN_POSITIVE);
        let mut slopes = Slopes::default();
        for rows in self.rows.chunks(ROWS_PER_SUM) {
            let [mut error, mut by_s, mut by_alpha] = [zero; 3];
            for row in rows {
                let lobe = self.lobe.row(row);
                let lanes = RowLanes::new(simd, row, &lobe);
                let versine4 = splat(lobe.versine4);
                let mut by_eta = zero;
                let values = vectors::<S>(self.sites.values_of(row));
                for (site, cos2) in vectors::<S>(self.sites.cos2_of(row)).iter().enumerate() {
                    let cos2 = Lanes::new(simd, *cos2);
                    let point = lanes.point(simd, cos2);
                    let weight = lanes.weight(cos2);
                    let mut push = zero;
                    let values = block_of::<S, COPIES>(values, site);
                    for copy in 0..COPIES {
                        let measured: [_; 3] = std::array::from_fn(|channel| {
                            Lanes::new(simd, values[(3 * copy + channel) * per_block::<S>()])
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
                                push = (weight * specular[channel]).mul_add(sign, push);
                            }
                        }
                    }
                    if GRADIENT {
                        let pull = push * point.shape;
                        by_eta = by_eta + pull;
                        let pull = pull * lanes.s;
                        by_s = pull.mul_add(point.ln, by_s);
                        // d ln(1 − v)/dα with v the versine of the base; at a base of 0 the slope has no bound.
                        let base = (splat(1.0) - point.versine).max(splat(1e-3));
                        by_alpha = pull.mul_add((point.phong - versine4) / base, by_alpha);
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

/// E of a model: one pass over everything. This is what the benchmarks call an objective pass.
pub fn error(lobe: &Lobe, sites: &Sites, amplitudes: &Amplitudes, threads: Threads) -> f64 {
    pass::<false>(lobe, sites, amplitudes, 0.0, threads).error
}

/// E with its slopes. `band` is the relative half width of residuals that count as nearly 0.
pub fn slopes(
    lobe: &Lobe,
    sites: &Sites,
    amplitudes: &Amplitudes,
    band: f64,
    threads: Threads,
) -> Slopes {
    pass::<true>(lobe, sites, amplitudes, band as f32, threads)
}

fn pass<const GRADIENT: bool>(
    lobe: &Lobe,
    sites: &Sites,
    amplitudes: &Amplitudes,
    band: f32,
    threads: Threads,
) -> Slopes {
    let work = |slab: Range<usize>| {
        lanes::dispatch(ErrorPass::<GRADIENT> {
            lobe,
            sites,
            rows: &sites.rows[slab],
            amplitudes,
            band,
        })
    };
    let mut sum = Slopes::default();
    over_slabs(sites, threads, work, |part| {
        sum.error += part.error;
        (0..3).for_each(|k| sum.gradient[k] += part.gradient[k]);
    });
    sum
}
