//! Concerns about a fit: what limits how far its parameters can be trusted.

use super::options::{FitOptions, SMALLEST_ETA};
use super::outcome::Concern;
use crate::brdf::{Brdf, Fresnel, ParamId};
use crate::geom::Rgb;
use crate::measured::Grid;

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
    if free(ParamId::S) && bins_above_half(brdf) < FEWEST_BINS {
        found.push(Concern::TooGlossy);
    }
    if free(ParamId::Eta) && brdf.params.eta < 1.0 + NEAR_ONE {
        found.push(Concern::EtaNearOne);
    }
    for row in brdf.model.params {
        // α = 0 and α = 1 are models of their own, and amplitudes of 0 are what they seem.
        let at_home = matches!(row.id, ParamId::Alpha | ParamId::RhoD | ParamId::KS);
        if !free(row.id) || at_home && options.bounds_of(row) == super::options::default_bounds(row)
        {
            continue;
        }
        let (low, high) = options.bounds_of(row);
        let near = |value: f64, bound: f64| (value - bound).abs() <= 1e-6 * bound.abs().max(1e-6);
        let eta_said = row.id == ParamId::Eta && low == SMALLEST_ETA;
        for value in brdf.params.get(row.id) {
            if near(*value, low) && !eta_said && !at_home {
                found.push(Concern::AtBound(row.id, low));
            } else if near(*value, high) {
                found.push(Concern::AtBound(row.id, high));
            }
        }
    }
    found.dedup();
    if albedo.iter().flatten().any(|albedo| *albedo > 1.0) {
        found.push(Concern::AlbedoAboveOne);
    }
    found
}

/// Number of θ_h bins in which the lobe is above half its height, for θ_d = 0.
fn bins_above_half(brdf: &Brdf) -> usize {
    let plain = Brdf {
        fresnel: Fresnel::None,
        ..*brdf
    };
    (0..crate::measured::grid::THETA_H_BINS)
        .take_while(|h| plain.specular_shape(&Grid::FOLDED.center(*h, 0, 0).cosines()) > 0.5)
        .count()
}
