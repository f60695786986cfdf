//! Starts of a fit: the best points of a grid over (s, α, η), on the small sample.

use super::amplitudes::AmplitudeBounds;
use super::lobe_kernel::SearchPoint;
use super::objective::{AmplitudeRule, Candidate, Objective, SearchSpace};
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use crate::brdf::Fresnel;
use rayon::prelude::*;

/// Number of grid points per decade of s.
const PER_DECADE: f64 = 2.5;
const ALPHAS: [f64; 3] = [0.0, 0.5, 1.0];
/// Candidates for η − 1: a steep rise towards grazing, glass, hardly any rise.
const ETAS_LESS_1: [f64; 3] = [0.12, 0.5, 3.0];
/// Largest number of starts that are followed.
const STARTS: usize = 5;

/// Evaluated points of the grid of starts, shared by all fits of one problem under the same options: points of Phong
/// and Blinn-Phong are points of the combined model as well.
#[derive(Debug, Default)]
pub struct StartGrid(Vec<Chain>);

/// Candidates for all s at one α and η.
#[derive(Clone, Debug)]
struct Chain {
    fresnel: Fresnel,
    limits: AmplitudeBounds,
    alpha: f64,
    eta: f64,
    candidates: Vec<Candidate>,
}

impl Chain {
    fn is_of(&self, space: &SearchSpace, exponents: &[f64], (alpha, eta): (f64, f64)) -> bool {
        self.fresnel == space.variant.fresnel
            && self.limits == space.limits
            && (self.alpha, self.eta) == (alpha, eta)
            && self
                .candidates
                .iter()
                .map(|point| &point.point[0])
                .eq(exponents)
    }
}

/// Most promising starts, the best first: local minima of the grid.
pub fn best_starts(
    coarse: &SymmetricCells,
    space: &SearchSpace,
    grid: &mut StartGrid,
) -> Vec<Candidate> {
    let exponents = evenly_spaced(space.bounds[0]);
    let alphas = choices(space.bounds[1], &ALPHAS);
    let etas = choices(space.bounds[2], &ETAS_LESS_1.map(f64::ln));
    let chains: Vec<(f64, f64)> = etas
        .iter()
        .flat_map(|eta| alphas.iter().map(|alpha| (*alpha, *eta)))
        .collect();
    let known = |at: &(f64, f64)| {
        grid.0
            .iter()
            .find(|chain| chain.is_of(space, &exponents, *at))
    };
    let fresnel = space.variant.fresnel;
    let found: Vec<Chain> = chains
        .par_iter()
        .map(|at| {
            let (alpha, eta) = *at;
            known(at).cloned().unwrap_or_else(|| {
                let rule = AmplitudeRule::Optimised(space.limits);
                let mut objective = Objective::new(coarse, fresnel, rule, None, Threads::One);
                let points = exponents.iter().map(|ln_s| [*ln_s, alpha, eta]);
                Chain {
                    fresnel,
                    limits: space.limits,
                    alpha,
                    eta,
                    candidates: points.map(|point| objective.error(point)).collect(),
                }
            })
        })
        .collect();
    let starts = best_minima(&found);
    for chain in found {
        let at = (chain.alpha, chain.eta);
        if !grid
            .0
            .iter()
            .any(|known| known.is_of(space, &exponents, at))
        {
            grid.0.push(chain);
        }
    }
    starts
}

/// Values of ln s, evenly spaced between the bounds; a single one where it is held.
fn evenly_spaced((low, high): (f64, f64)) -> Vec<f64> {
    let steps = ((high - low) / std::f64::consts::LN_10 * PER_DECADE)
        .ceil()
        .max(0.0);
    let at = |k: usize| low + (high - low) * k as f64 / steps.max(1.0);
    (0..=steps as usize).map(at).collect()
}

/// Choices within the bounds, or the middle of the bounds where there is none.
fn choices((low, high): (f64, f64), all: &[f64]) -> Vec<f64> {
    let within: Vec<f64> = all
        .iter()
        .copied()
        .filter(|x| (low..=high).contains(x))
        .collect();
    if within.is_empty() || low == high {
        vec![0.5 * (low + high)]
    } else {
        within
    }
}

/// Local minima of every chain over s; of these the best that are not near one another.
fn best_minima(grid: &[Chain]) -> Vec<Candidate> {
    let mut minima: Vec<Candidate> = Vec::new();
    for Chain {
        candidates: chain, ..
    } in grid
    {
        for (k, candidate) in chain.iter().enumerate() {
            let lower = |other: Option<&Candidate>| {
                other.is_none_or(|other| candidate.error <= other.error)
            };
            if lower(k.checked_sub(1).map(|k| &chain[k])) && lower(chain.get(k + 1)) {
                minima.push(*candidate);
            }
        }
    }
    minima.sort_by(|a, b| a.error.total_cmp(&b.error));
    let mut starts: Vec<Candidate> = Vec::new();
    for candidate in minima {
        let near = |other: &Candidate| {
            (candidate.point[0] - other.point[0]).abs() < 1.2
                && (candidate.point[1] - other.point[1]).abs() < 0.6
                && (candidate.point[2] - other.point[2]).abs() < 1.0
        };
        if starts.len() < STARTS && !starts.iter().any(near) {
            starts.push(candidate);
        }
    }
    starts
}

/// Whether two points are closer than a fit can tell apart.
pub fn nearly_equal(a: SearchPoint, b: SearchPoint) -> bool {
    (a[0] - b[0]).abs() < 0.02 && (a[1] - b[1]).abs() < 0.005 && (a[2] - b[2]).abs() < 0.02
}
