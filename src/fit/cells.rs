//! Passes that go cell by cell in f64: the last digits of stage 1, and the errors that are reported.

use super::lanes::LANES;
use super::outcome::Errors;
use super::passes::Amplitudes;
use super::regression::Limits;
use super::sites::{Row, Sites};
use super::vertex::{Cell, Sum};
use rayon::prelude::*;

/// Calls `visit(channel, cell, is grazing)` for every cell of a row.
fn for_each_cell(
    sites: &Sites,
    row: &Row,
    shapes: &[f32],
    mut visit: impl FnMut(usize, Cell, bool),
) {
    let count = row.blocks * LANES;
    let shapes = &shapes[row.site_block * LANES..][..count];
    let cos2 = sites.cos2_of(row);
    let values = sites.values_of(row);
    for (plane, lanes) in values.chunks_exact(LANES).enumerate() {
        let block = plane / (3 * sites.copies);
        for (lane, f) in lanes.iter().enumerate() {
            if *f >= 0.0 {
                let site = block * LANES + lane;
                let cell = Cell {
                    x: f64::from(shapes[site]),
                    f: f64::from(*f),
                    w: f64::from(row.weight[0]) + f64::from(row.weight[1]) * f64::from(cos2[site]),
                };
                visit(plane % 3, cell, site < row.grazing_end);
            }
        }
    }
}

/// E in total and in parts. `with_grazing` says whether there is a grazing part to speak of.
pub fn errors(
    sites: &Sites,
    shapes: &[f32],
    amplitudes: &Amplitudes,
    with_grazing: bool,
) -> Errors {
    #[derive(Clone, Copy, Default)]
    struct Part {
        error: [f64; 3],
        energy: [f64; 3],
        grazing: [f64; 2],
    }
    let parts: Vec<Part> = sites
        .slabs
        .par_iter()
        .map(|slab| {
            let mut part = Part::default();
            for row in &sites.rows[slab.clone()] {
                for_each_cell(sites, row, shapes, |channel, cell, grazing| {
                    let model = amplitudes.diffuse[channel] + amplitudes.specular[channel] * cell.x;
                    let error = cell.w * (model - cell.f).abs();
                    part.error[channel] += error;
                    part.energy[channel] += cell.w * cell.f;
                    if grazing {
                        part.grazing[0] += error;
                        part.grazing[1] += cell.w * cell.f;
                    }
                });
            }
            part
        })
        .collect();
    let mut sum = Part::default();
    for part in parts {
        (0..3).for_each(|k| sum.error[k] += part.error[k]);
        (0..3).for_each(|k| sum.energy[k] += part.energy[k]);
        (0..2).for_each(|k| sum.grazing[k] += part.grazing[k]);
    }
    Errors {
        total: sum.error.iter().sum::<f64>() / sum.energy.iter().sum::<f64>(),
        grazing: (with_grazing && sum.grazing[1] > 0.0).then(|| sum.grazing[0] / sum.grazing[1]),
        channels: std::array::from_fn(|k| sum.error[k] / sum.energy[k]),
    }
}

/// Half width of the band of cells that the exact solution looks at, relative to the model, to begin with.
const BAND: f64 = 2e-4;
/// Rounds at most; the band grows fourfold with each.
const ROUNDS: usize = 5;
/// With more cells than this in the band the model meets the data nearly exactly, and nothing is left to gain.
const MOST_CELLS: usize = 50_000;
/// With fewer cells than this all of them are in the band.
const FEW_CELLS: usize = 2000;

/// The exact minimum of stage 1 from amplitudes that are near.
///
/// Cells far from the model keep the sign of their residual and enter as two slopes; only those within a narrow band
/// are looked at one by one [Portnoy97]. Amplitudes move no further than the others keep their signs. A minimum
/// short of that is the minimum of all, by convexity; else the band is laid anew from there, and wider.
pub fn exact(sites: &Sites, shapes: &[f32], near: &Amplitudes, limits: &Limits) -> Amplitudes {
    let mut at = limits.clamp(*near);
    let few = sites.cells < FEW_CELLS;
    let mut band = if few { f64::INFINITY } else { BAND };
    let mut done = [false; 3];
    for _ in 0..ROUNDS {
        let sums = gather(sites, shapes, &at, limits, band, done);
        let moves: Vec<([f64; 2], bool)> = (0..3)
            .into_par_iter()
            .map(|k| {
                let from = [at.diffuse[k], at.specular[k]];
                if done[k] || sums[k].cells.len() > MOST_CELLS {
                    return (from, true);
                }
                let to = sums[k].minimise(from);
                let inside = |i: usize| {
                    let [low, high] = [sums[k].bounds[i].0, sums[k].bounds[i].1];
                    let limit = limits.of(k)[i];
                    (to[i] > low || low == limit.0) && (to[i] < high || high == limit.1)
                };
                (to, inside(0) && inside(1))
            })
            .collect();
        for (k, (to, finished)) in moves.into_iter().enumerate() {
            (at.diffuse[k], at.specular[k]) = (to[0], to[1]);
            done[k] = finished;
        }
        if done == [true; 3] {
            break;
        }
        band *= 4.0;
    }
    at
}

/// What the band is wide where the model is 0.
fn floor(sites: &Sites, channel: usize) -> f64 {
    1e-3 * sites.shares[channel]
}

/// The sum of each channel: cells within the band, the slopes of the rest, and how far these hold.
fn gather(
    sites: &Sites,
    shapes: &[f32],
    at: &Amplitudes,
    limits: &Limits,
    band: f64,
    done: [bool; 3],
) -> [Sum; 3] {
    let floor: [f64; 3] = std::array::from_fn(|channel| floor(sites, channel));
    // So that |Δa + Δb·x| ≤ band · (a + b·x + 2 floor), for x is in [0, 1].
    let reach = |channel: usize, k: usize| match k {
        _ if band.is_infinite() => f64::INFINITY,
        0 => band * (at.diffuse[channel] + floor[channel]),
        _ => band * (at.specular[channel] + floor[channel]),
    };
    let bounds = |channel: usize| {
        std::array::from_fn(|k| {
            let (low, high) = limits.of(channel)[k];
            let at = [at.diffuse[channel], at.specular[channel]][k];
            (
                low.max(at - reach(channel, k)),
                high.min(at + reach(channel, k)),
            )
        })
    };
    let empty = || -> [Sum; 3] {
        std::array::from_fn(|channel| Sum {
            cells: Vec::new(),
            linear: [0.0; 2],
            bounds: bounds(channel),
        })
    };
    let parts: Vec<[Sum; 3]> = sites
        .slabs
        .par_iter()
        .map(|slab| {
            let mut sums = empty();
            for row in &sites.rows[slab.clone()] {
                for_each_cell(sites, row, shapes, |channel, cell, _| {
                    if done[channel] {
                        return;
                    }
                    let model = at.diffuse[channel] + at.specular[channel] * cell.x;
                    let r = model - cell.f;
                    if band.is_infinite() || r.abs() <= band * (model + 2.0 * floor[channel]) {
                        sums[channel].cells.push(cell);
                    } else {
                        let slope = cell.w * r.signum();
                        sums[channel].linear[0] += slope;
                        sums[channel].linear[1] += slope * cell.x;
                    }
                });
            }
            sums
        })
        .collect();
    let mut sums = empty();
    for part in parts {
        for (sum, part) in sums.iter_mut().zip(part) {
            sum.cells.extend(part.cells);
            (0..2).for_each(|k| sum.linear[k] += part.linear[k]);
        }
    }
    sums
}
