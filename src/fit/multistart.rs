//! Starts of a fit: the best points of a grid that the rows of the parameters span, on the small sample.

use super::amplitudes::AmplitudeBounds;
use super::objective::{AmplitudeRule, Candidate, Objective, SearchSpace, rows};
use super::options::Variant;
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use super::variables::{ETA_VARIABLE, SearchPoint, VARIABLES, variable};
use crate::brdf::params::{Scale, Starts};
use rayon::prelude::*;
use std::f64::consts::LN_10;

/// Largest number of starts that are followed.
const STARTS: usize = 5;

/// Evaluated points of the grid of starts, shared by all fits of one problem under the same options: points of a model
/// are points as well of one that contains it, and the other way round where that one equals the model.
#[derive(Debug, Default)]
pub struct StartGrid(Vec<Chain>);

/// Candidates for all values of the first variable, the others staying.
#[derive(Clone, Debug)]
struct Chain {
    variant: Variant,
    limits: AmplitudeBounds,
    candidates: Vec<Candidate>,
}

/// Most promising starts, the best first: local minima of the grid.
pub fn best_starts(
    coarse: &SymmetricCells,
    space: &SearchSpace,
    grid: &mut StartGrid,
) -> Vec<Candidate> {
    let along: Vec<Vec<f64>> = (0..VARIABLES).map(|k| values(space, k)).collect();
    let mut points: Vec<SearchPoint> = vec![[0.0; VARIABLES]];
    for (k, values) in along.iter().enumerate().skip(1) {
        points = points
            .into_iter()
            .flat_map(|point| {
                values.iter().map(move |value| {
                    let mut point = point;
                    point[k] = *value;
                    point
                })
            })
            .collect();
    }
    let chain = |at: &SearchPoint| {
        let on_chain = along[0].iter().map(|first| {
            let mut point = *at;
            point[0] = *first;
            point
        });
        let points: Vec<SearchPoint> = on_chain.collect();
        grid.known(space, &points).unwrap_or_else(|| {
            let rule = AmplitudeRule::Optimised(space.limits);
            let mut objective = Objective::new(coarse, space.variant, rule, None, Threads::One);
            Chain {
                variant: space.variant,
                limits: space.limits,
                candidates: points
                    .into_iter()
                    .map(|point| objective.error(point))
                    .collect(),
            }
        })
    };
    let found: Vec<Chain> = points.par_iter().map(chain).collect();
    let starts = best_minima(&found, &nearness(space, &along));
    for chain in found {
        let points: Vec<SearchPoint> = chain.candidates.iter().map(|one| one.point).collect();
        if grid.known(space, &points).is_none() {
            grid.0.push(chain);
        }
    }
    starts
}

impl StartGrid {
    /// Chain with these points, of the same variant, of one that it contains, or of one that contains it.
    fn known(&self, space: &SearchSpace, points: &[SearchPoint]) -> Option<Chain> {
        self.0
            .iter()
            .filter(|chain| chain.limits == space.limits)
            .find_map(|chain| {
                if chain.candidates.len() != points.len() {
                    return None;
                }
                let candidates = chain
                    .candidates
                    .iter()
                    .zip(points)
                    .map(|(candidate, point)| {
                        let known = translated(chain.variant, space.variant, &candidate.point)?;
                        // Through logarithms a point may differ in its last digits.
                        let same = (0..VARIABLES).all(|k| (known[k] - point[k]).abs() < 1e-9);
                        same.then_some(Candidate {
                            point: *point,
                            ..*candidate
                        })
                    });
                let candidates = candidates.collect::<Option<_>>()?;
                Some(Chain {
                    variant: space.variant,
                    candidates,
                    ..*chain
                })
            })
    }
}

/// Point of a variant that equals a point of another; `None` where there is none.
fn translated(from: Variant, to: Variant, point: &SearchPoint) -> Option<SearchPoint> {
    if from == to {
        return Some(*point);
    }
    if from.fresnel != to.fresnel {
        return None;
    }
    embedded(from, to, point).or_else(|| extracted(from, to, point))
}

/// Point of `inner` that equals a point of `outer`, which contains it; `None` where that equals none.
fn extracted(outer: Variant, inner: Variant, point: &SearchPoint) -> Option<SearchPoint> {
    let contained = outer.model.containing(inner.model)?;
    let mut to = [0.0; VARIABLES];
    to[ETA_VARIABLE] = point[ETA_VARIABLE];
    for (k, (row, factor)) in inner.model.params.iter().zip(contained.factors).enumerate() {
        to[k] = match row.scale {
            Scale::Log { .. } => point[k] - factor.ln(),
            Scale::Linear => point[k] / factor,
        };
    }
    let again = embedded(inner, outer, &to)?;
    let same = (0..VARIABLES).all(|k| (again[k] - point[k]).abs() < 1e-9);
    same.then_some(to)
}

/// Point of `outer` that equals a point of `inner`; `None` where it does not contain it.
fn embedded(inner: Variant, outer: Variant, point: &SearchPoint) -> Option<SearchPoint> {
    let contained = outer.model.containing(inner.model)?;
    let mut to = [0.0; VARIABLES];
    to[ETA_VARIABLE] = point[ETA_VARIABLE];
    let (scaled, apart) = outer.model.params.split_at(contained.factors.len());
    for (k, (row, factor)) in scaled.iter().zip(contained.factors).enumerate() {
        to[k] = match row.scale {
            Scale::Log { .. } => point[k] + factor.ln(),
            Scale::Linear => point[k] * factor,
        };
    }
    for (k, (row, fixed)) in apart.iter().zip(contained.fixed).enumerate() {
        to[contained.factors.len() + k] = variable(row, *fixed);
    }
    Some(to)
}

/// Values of a variable on the grid: a single one where it is held, and where there is no such variable.
fn values(space: &SearchSpace, k: usize) -> Vec<f64> {
    let (low, high) = space.bounds[k];
    let row = rows(space.variant).find(|(index, _)| *index == k);
    let Some((_, row)) = row.filter(|_| low < high) else {
        return vec![low];
    };
    match row.starts {
        Starts::PerDecade(count) => {
            let (least, most) = (variable(row, row.range.0), variable(row, row.range.1));
            let inside = (low.max(least), high.min(most));
            let (from, to) = if inside.0 < inside.1 {
                inside
            } else {
                (low, high)
            };
            // Beyond the slider's range a model hardly changes: its bounds stand for all that is there.
            let mut values: Vec<f64> = (low < from).then_some(low).into_iter().collect();
            values.extend(evenly_spaced(from, to, count));
            values.extend((high > to).then_some(high));
            values
        }
        Starts::At(starts) => {
            let starts = starts.iter().map(|start| variable(row, *start));
            let within: Vec<f64> = starts.filter(|x| (low..=high).contains(x)).collect();
            if within.is_empty() {
                vec![0.5 * (low + high)]
            } else {
                within
            }
        }
    }
}

/// Values of a logarithm, evenly spaced from `low` to `high`, at least `per_decade` of them.
fn evenly_spaced(low: f64, high: f64, per_decade: f64) -> Vec<f64> {
    let steps = ((high - low) / LN_10 * per_decade).ceil().max(1.0);
    let at = |k: usize| low + (high - low) * k as f64 / steps;
    (0..=steps as usize).map(at).collect()
}

/// Distance per variable within which two minima of the grid are one.
fn nearness(space: &SearchSpace, along: &[Vec<f64>]) -> SearchPoint {
    let mut near = [f64::INFINITY; VARIABLES];
    for (k, row) in rows(space.variant) {
        let gaps = along[k].windows(2).map(|pair| pair[1] - pair[0]);
        let gap = gaps.fold(f64::INFINITY, f64::min);
        near[k] = match row.starts {
            Starts::PerDecade(count) => 1.3 * LN_10 / count,
            // R_F has minima of its own, a step apart.
            Starts::At(_) if k == ETA_VARIABLE => 0.7 * gap,
            Starts::At(_) => 1.2 * gap,
        };
    }
    near
}

/// Local minima of every chain along the first variable; of these the best that are not near one another.
fn best_minima(grid: &[Chain], near: &SearchPoint) -> Vec<Candidate> {
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
        let is_near = |other: &Candidate| {
            (0..VARIABLES).all(|k| (candidate.point[k] - other.point[k]).abs() < near[k])
        };
        if starts.len() < STARTS && !starts.iter().any(is_near) {
            starts.push(candidate);
        }
    }
    starts
}

/// Whether two points of a variant are closer than a fit can tell apart.
pub fn nearly_equal(variant: Variant, a: SearchPoint, b: SearchPoint) -> bool {
    rows(variant).all(|(k, row)| {
        let close = match row.scale {
            Scale::Linear if k != ETA_VARIABLE => 0.005 * (row.range.1 - row.range.0),
            _ => 0.02,
        };
        (a[k] - b[k]).abs() < close
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::{Fresnel, MODELS};

    #[test]
    fn points_of_a_model_are_those_of_one_that_contains_it_and_back() {
        let mut pairs = 0;
        for outer in MODELS {
            for contained in outer.contains {
                let of = |model| Variant {
                    model,
                    fresnel: Fresnel::Exact,
                };
                let (inner, outer) = (of(contained.model), of(*outer));
                let mut point = [0.0; VARIABLES];
                point[ETA_VARIABLE] = -0.5;
                point[..contained.factors.len()].fill(1.25);
                let there = translated(inner, outer, &point).expect("a point");
                let back = translated(outer, inner, &there).expect("the same");
                assert!((0..VARIABLES).all(|k| (back[k] - point[k]).abs() < 1e-12));
                // Off the values at which they are equal there is none.
                let mut off = there;
                off[contained.factors.len()] += 0.1;
                assert_eq!(translated(outer, inner, &off), None);
                let other = Variant {
                    fresnel: Fresnel::None,
                    ..inner
                };
                assert_eq!(translated(other, outer, &point), None);
                pairs += 1;
            }
        }
        assert!(pairs >= 3);
    }
}
