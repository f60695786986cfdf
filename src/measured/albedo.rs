//! Directional albedo of measured data: the share of the light from one direction that is reflected.
//!
//! The bins of a table lie around the half vector, down to 0.01° wide at the mirror direction, so the sum over view
//! directions goes over half vectors: dωo = 4 (wi·wh) dωh.

use super::lookup::Lookup;
use super::table::Table;
use crate::geom::{Rgb, direction};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};

/// Directional albedo over the measured directions, and their share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflectance {
    /// ∫ f_r cos θo dωo over the directions that have a value, linear RGB.
    pub rgb: Rgb,
    /// Share of ∫ cos θo dωo = π that has a value, in [0, 1].
    pub measured: f64,
}

/// Directional-hemispherical reflectance of a table for light from `theta_i` in [0, π/2) radians, over its valid part.
///
/// Accurate to 1e-3 for f_r as the lookup gives it, holes as they are on the grid.
pub fn albedo(table: &Table, lookup: Lookup, theta_i: f64) -> Reflectance {
    reflectance(theta_i, |wi, wo| table.lookup(wi, wo, lookup))
}

/// Directional-hemispherical reflectance of any f_r whose detail is that of the grid: narrow where wh is near the
/// normal, else no finer than a degree. `theta_i` in radians.
pub fn reflectance(theta_i: f64, f_r: impl Fn(DVec3, DVec3) -> Option<Rgb>) -> Reflectance {
    // Past this nothing is left of the cosine, and the layout would end.
    let theta_i = theta_i.clamp(0.0, FRAC_PI_2 - 1e-4);
    let wi = direction(theta_i, 0.0);
    let mut sum = [0.0; 3];
    let mut measured = 0.0;
    for pair in breaks(theta_i).windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        for (node, weight) in GAUSS {
            let t = middle + half * node;
            // In the square root of θh, as the bins are.
            let theta_h = t * t * FRAC_PI_2;
            let row = 2.0 * t * FRAC_PI_2 * weight * half;
            let max_phi_h = max_phi_h(theta_i, theta_h);
            // As many as there are bins of φd on the way round.
            let nodes = ((max_phi_h.to_degrees() * 2.0 * NODES_PER_DEGREE).ceil() as usize).max(8);
            let step = 2.0 * max_phi_h / nodes as f64;
            for k in 0..nodes {
                let phi = (k as f64 + 0.5) * step - max_phi_h;
                let wh = direction(theta_h, phi);
                let cos_d = wi.dot(wh);
                let wo = 2.0 * cos_d * wh - wi;
                if cos_d <= 0.0 || wo.z <= 0.0 {
                    continue;
                }
                let solid_angle = 4.0 * cos_d * theta_h.sin() * row * step;
                if let Some(rgb) = f_r(wi, wo) {
                    let weight = solid_angle * wo.z;
                    measured += weight;
                    for (sum, value) in sum.iter_mut().zip(rgb) {
                        *sum += weight * value;
                    }
                }
            }
        }
    }
    Reflectance {
        rgb: sum,
        measured: (measured / PI).min(1.0),
    }
}

/// Quadrature nodes per degree of φh.
const NODES_PER_DEGREE: f64 = 1.0;

/// Largest |φh| from the plane of incidence before wo meets the horizon, in radians.
///
/// cos θo = 2 (wi·wh) cos θh − cos θi = 0 where cos φh = −cot θi cot 2θh.
fn max_phi_h(theta_i: f64, theta_h: f64) -> f64 {
    let (sin_2h, cos_2h) = (2.0 * theta_h).sin_cos();
    let (sin_i, cos_i) = theta_i.sin_cos();
    let (above, below) = (-cos_i * cos_2h, sin_i * sin_2h);
    if above <= -below {
        PI
    } else if above >= below {
        0.0
    } else {
        (above / below).acos()
    }
}

/// Panel breaks √(θh / 90°), ascending: edges and centres of the bins of θh, where a lookup bends, and the two θh at
/// which the horizon comes in and closes.
fn breaks(theta_i: f64) -> Vec<f64> {
    const HALF_BINS: usize = 2 * super::grid::THETA_H_BINS;
    let last = (0.5 * (FRAC_PI_2 + theta_i) / FRAC_PI_2).sqrt();
    let first = (0.5 * (FRAC_PI_2 - theta_i) / FRAC_PI_2).sqrt();
    let mut breaks: Vec<f64> = (0..=HALF_BINS)
        .map(|k| k as f64 / HALF_BINS as f64)
        .filter(|t| *t < last)
        .collect();
    breaks.extend([first, last]);
    breaks.sort_by(f64::total_cmp);
    breaks
}

/// Nodes and weights of Gauss-Legendre with two points on [−1, 1].
const GAUSS: [(f64, f64); 2] = [
    (-0.577_350_269_189_625_8, 1.0),
    (0.577_350_269_189_625_8, 1.0),
];

#[cfg(test)]
mod tests;
