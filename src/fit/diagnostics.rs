//! Concerns about a fit: what limits how far its parameters can be trusted.

use super::options::FitOptions;
use super::outcome::Concern;
use crate::brdf::params::AtBound;
use crate::brdf::{Brdf, Param, ParamId};
use crate::geom::Rgb;
use crate::measured::Grid;
use crate::measured::grid::THETA_H_BINS;

/// η − 1 below which η is near 1: R_F(0) < 1e-4.
const NEAR_ONE: f64 = 0.02;
/// Fewest bins of θ_h above half the highlight's height with which it can be told from a narrower one.
const FEWEST_BINS: usize = 4;

/// Concerns about a fitted model, the gravest first. `albedo` is its directional albedo.
pub fn diagnose(brdf: &Brdf, options: &FitOptions, albedo: &[Rgb]) -> Vec<Concern> {
    let mut found = Vec::new();
    let free = |id: ParamId| brdf.uses(id) && !options.held.has(id);
    if brdf.params.k_s.iter().all(|k_s| *k_s <= 0.0) {
        // Nothing else means anything then.
        return vec![Concern::NoHighlight];
    }
    if let Some(row) = brdf.model.params.first()
        && free(row.id)
        && bins_above_half(brdf) < FEWEST_BINS
    {
        found.push(Concern::TooGlossy {
            id: row.id,
            is_lower_limit: narrows(brdf, row),
        });
    }
    if free(ParamId::ETA) && brdf.params.eta < 1.0 + NEAR_ONE {
        found.push(Concern::EtaNearOne);
    }
    for row in brdf.model.rows().filter(|row| free(row.id)) {
        let (low, high) = options.bounds_of(row);
        let near = |value: f64, bound: f64| (value - bound).abs() <= 1e-6 * bound.abs().max(1e-6);
        let ends = [(low, row.bounds.0), (high, row.bounds.1)];
        for value in brdf.get(row.id) {
            let ends = ends.iter().zip(row.at_bounds);
            for ((bound, default), meaning) in ends.filter(|((bound, _), _)| near(*value, *bound)) {
                match meaning {
                    // The meaning is that of the row's own bound.
                    AtBound::Fine if bound == default => {}
                    AtBound::Means(what) if bound == default => found.push(Concern::AtEnd(what)),
                    _ => found.push(Concern::AtBound(row.id, *bound)),
                }
            }
        }
    }
    found.dedup();
    if albedo.iter().flatten().any(|albedo| *albedo > 1.0) {
        found.push(Concern::AlbedoAboveOne);
    }
    found
}

/// Whether a larger value of the first parameter makes the highlight narrower.
fn narrows(brdf: &Brdf, row: &Param) -> bool {
    let share_off_peak = |value: f64| {
        let mut other = *brdf;
        other.params.lobe[0] = value;
        lobe_at(&other, 2) / lobe_at(&other, 0)
    };
    share_off_peak(row.range.1) <= share_off_peak(row.range.0)
}

/// The lobe in a bin of θ_h, for θ_d = 0.
fn lobe_at(brdf: &Brdf, theta_h: usize) -> f64 {
    brdf.lobe(&Grid::FOLDED.center(theta_h, 0, 0).cosines())
}

/// Number of θ_h bins in which the lobe is above half of what it is in the first, for θ_d = 0.
fn bins_above_half(brdf: &Brdf) -> usize {
    let half = 0.5 * lobe_at(brdf, 0);
    (0..THETA_H_BINS)
        .take_while(|h| lobe_at(brdf, *h) > half)
        .count()
}
