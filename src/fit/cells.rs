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
    let values =
        &sites.values[row.site_block * LANES * 3 * sites.copies..][..3 * sites.copies * count];
    for (plane, values) in values.chunks_exact(count).enumerate() {
        for (site, f) in values.iter().enumerate() {
            if *f >= 0.0 {
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
const BAND: f64 = 3e-4;
/// Rounds at most; the band grows fourfold with each.
const ROUNDS: usize = 6;
/// With more cells than this in the band the model meets the data nearly exactly, and nothing is left to gain.
const MOST_CELLS: usize = 300_000;

/// The exact minimum of stage 1 from amplitudes that are near.
///
/// Cells far from the model keep the sign of their residual and enter as two slopes; only those within a narrow band
/// are looked at one by one [Portnoy97]. The result holds if it is so near that none of the others changes its sign;
/// else the band is laid anew, and wider.
pub fn exact(sites: &Sites, shapes: &[f32], near: &Amplitudes, limits: &Limits) -> Amplitudes {
    let mut at = limits.clamp(*near);
    let mut band = BAND;
    for _ in 0..ROUNDS {
        let sums = gather(sites, shapes, &at, limits, band);
        if sums.iter().any(|sum| sum.cells.len() > MOST_CELLS) {
            break;
        }
        let found: Vec<[f64; 2]> = (0..3)
            .into_par_iter()
            .map(|k| sums[k].minimise([at.diffuse[k], at.specular[k]]))
            .collect();
        let mut holds = true;
        for k in 0..3 {
            let [a, b] = found[k];
            holds &= (a - at.diffuse[k]).abs() <= band * (at.diffuse[k] + floor(sites, k));
            holds &= (b - at.specular[k]).abs() <= band * at.specular[k];
            at.diffuse[k] = a;
            at.specular[k] = b;
        }
        if holds {
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

/// The sum of each channel: cells within the band, and the slopes of the rest.
fn gather(sites: &Sites, shapes: &[f32], at: &Amplitudes, limits: &Limits, band: f64) -> [Sum; 3] {
    let empty = || -> [Sum; 3] {
        std::array::from_fn(|channel| Sum {
            cells: Vec::new(),
            linear: [0.0; 2],
            bounds: limits.of(channel),
        })
    };
    let floor: [f64; 3] = std::array::from_fn(|channel| floor(sites, channel));
    let parts: Vec<[Sum; 3]> = sites
        .slabs
        .par_iter()
        .map(|slab| {
            let mut sums = empty();
            for row in &sites.rows[slab.clone()] {
                for_each_cell(sites, row, shapes, |channel, cell, _| {
                    let model = at.diffuse[channel] + at.specular[channel] * cell.x;
                    let r = model - cell.f;
                    if r.abs() <= band * (model + floor[channel]) {
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
