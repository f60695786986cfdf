//! Error landscape: E of the combined model over (s, α), with ρ_d and k_s solved at each point.
//!
//! α = 0 is Phong with exponent s and α = 1 Blinn-Phong with 4 s, so that the edges are these models' own. E is
//! estimated on a sample of the cells, coarse to fine; the best point is refined and measured on all of them.

use super::objective::{AmplitudeRule, Candidate, Objective, SearchSpace};
use super::options::{FitOptions, Variant};
use super::problem::Problem;
use super::stages::{Stage, StageSet};
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;
use super::variables::{ETA_VARIABLE, SearchPoint};
use super::variants::fit;
use crate::brdf::params::{ETA, lobe_values};
use crate::brdf::{Brdf, COMBINED, Fresnel, Model, ParamId};
use rayon::prelude::*;
use std::ops::ControlFlow;

/// Grid sizes along ln s and along α, from coarse to fine; each grid holds the one before, and the first a point at
/// every decade of s.
pub const GRIDS: [(usize, usize); 3] = [(8, 5), (15, 9), (29, 17)];

/// Number of nodes between two calls of `follow`.
const BATCH: usize = 16;

/// η of the points of a landscape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Eta {
    /// Fixed η at all points.
    Fixed(f64),
    /// η that minimises E, at each point.
    Optimised,
}

/// A point of a landscape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The combined model with the best ρ_d and k_s there, and the best η where it is solved.
    pub brdf: Brdf,
    /// E of `brdf` on a sample of the cells.
    pub error: f64,
}

/// E over a grid of (s, α).
#[derive(Clone, Debug, PartialEq)]
pub struct Landscape {
    /// Exponents of the combined model, evenly in the logarithm, ascending.
    pub s: Vec<f64>,
    /// Blends α from 0 to 1, evenly, ascending.
    pub alpha: Vec<f64>,
    /// Nodes: that of the exponent i and the blend j is at i + `s.len()` · j.
    pub nodes: Vec<Node>,
    /// The best model, at a node or between nodes, and its E on all cells; `None` while finer grids are to come.
    pub best: Option<(Brdf, f64)>,
}

/// Progress report of a landscape.
#[derive(Debug)]
pub enum LandscapeUpdate {
    /// Share of all grids that is done, in [0, 1].
    Progress(f32),
    /// Landscape on a finished grid, finer ones are to come.
    Grid(Landscape),
}

/// Combined model, which contains Phong and Blinn-Phong; its parameters are the axes.
pub fn model() -> &'static Model {
    &COMBINED
}

/// Place of a model on the axes of a landscape: (s, α) of the combined model that it is or looks most like.
pub fn place(brdf: &Brdf) -> [f64; 2] {
    let [s, alpha, ..] = brdf.with_model(model()).params.lobe;
    [s, alpha]
}

/// Landscape of a problem; `None` where `follow` breaks. It does not depend on the number of threads.
pub fn landscape(
    problem: &Problem,
    fresnel: Fresnel,
    eta: Eta,
    follow: &mut dyn FnMut(LandscapeUpdate) -> ControlFlow<()>,
) -> Option<Landscape> {
    let variant = Variant {
        model: model(),
        fresnel,
    };
    let survey = Survey {
        // E as a function of η is smooth and asks for many more points; the small sample tells enough.
        cells: match eta {
            Eta::Fixed(_) => &problem.medium,
            Eta::Optimised => &problem.coarse,
        },
        space: SearchSpace::new(variant, &FitOptions::default(), problem.units()),
        eta: match fresnel {
            Fresnel::None => Eta::Fixed(ETA.default),
            _ => eta,
        },
    };
    let all: usize = GRIDS.last().map_or(0, |(columns, rows)| columns * rows);
    let mut before: Option<Landscape> = None;
    for (step, (columns, rows)) in GRIDS.into_iter().enumerate() {
        let mut grid = survey.grid(columns, rows);
        let known = |index: usize| {
            let before = before.as_ref()?;
            let (i, j) = (index % columns, index / columns);
            let there = i.is_multiple_of(2) && j.is_multiple_of(2);
            there.then(|| before.nodes[i / 2 + before.s.len() * (j / 2)])
        };
        let mut nodes: Vec<Option<Node>> = (0..columns * rows).map(known).collect();
        let missing: Vec<usize> = (0..nodes.len()).filter(|k| nodes[*k].is_none()).collect();
        let mut done = nodes.len() - missing.len();
        for batch in missing.chunks(BATCH) {
            let made: Vec<Node> = batch
                .par_iter()
                .map(|k| survey.node(grid.s[k % columns], grid.alpha[k / columns]))
                .collect();
            for (k, node) in batch.iter().zip(made) {
                nodes[*k] = Some(node);
            }
            done += batch.len();
            if follow(LandscapeUpdate::Progress(done as f32 / all as f32)).is_break() {
                return None;
            }
        }
        grid.nodes = nodes.into_iter().flatten().collect();
        if step + 1 < GRIDS.len() && follow(LandscapeUpdate::Grid(grid.clone())).is_break() {
            return None;
        }
        before = Some(grid);
    }
    let mut finest = before?;
    let lowest = finest.lowest()?.brdf;
    let candidates = [
        problem.with_best_amplitudes(&lowest),
        survey.refined(problem, &lowest),
    ];
    finest.best = candidates
        .map(|brdf| (brdf, problem.errors(&brdf).total))
        .into_iter()
        .min_by(|a, b| a.1.total_cmp(&b.1));
    Some(finest)
}

/// Cells, search space and η with which nodes are evaluated.
struct Survey<'a> {
    cells: &'a SymmetricCells,
    space: SearchSpace,
    eta: Eta,
}

impl Survey<'_> {
    /// Landscape without nodes, with the coordinates of a grid.
    fn grid(&self, columns: usize, rows: usize) -> Landscape {
        let (low, high) = model().params[0].range;
        let share = |k: usize, count: usize| k as f64 / (count - 1) as f64;
        Landscape {
            s: (0..columns)
                .map(|k| low * (high / low).powf(share(k, columns)))
                .collect(),
            alpha: (0..rows).map(|k| share(k, rows)).collect(),
            nodes: Vec::new(),
            best: None,
        }
    }

    /// The best model between the nodes, by a fit on all cells that begins at the lowest one: nodes are four a decade of s,
    /// and E there is an estimate.
    fn refined(&self, problem: &Problem, lowest: &Brdf) -> Brdf {
        let mut options = FitOptions {
            stages: StageSet::from_iter([Stage::Joint]),
            ..FitOptions::default()
        };
        for row in model().params {
            options.start.set(row.id, lowest);
        }
        match self.eta {
            Eta::Fixed(_) => options.held.set(ParamId::ETA, lowest),
            Eta::Optimised => options.start.set(ParamId::ETA, lowest),
        }
        fit(problem, self.space.variant, &options, &mut |_| {
            ControlFlow::Continue(())
        })
        .brdf
    }

    fn node(&self, s: f64, alpha: f64) -> Node {
        let variant = self.space.variant;
        let at = |eta: f64| {
            let mut brdf = Brdf::new(variant.model, variant.fresnel);
            brdf.params.lobe = lobe_values([s, alpha]);
            brdf.params.eta = eta;
            self.space.point(&brdf)
        };
        let limits = AmplitudeRule::Optimised(self.space.limits);
        let mut objective = Objective::new(self.cells, variant, limits, None, Threads::One);
        let candidate = match self.eta {
            Eta::Fixed(eta) => objective.error(at(eta)),
            Eta::Optimised => best_eta(&mut objective, at(ETA.default)),
        };
        let mut brdf = self.space.brdf(&candidate, &FitOptions::default());
        brdf.params.lobe = lobe_values([s, alpha]);
        if let Eta::Fixed(eta) = self.eta {
            brdf.params.eta = eta;
        }
        Node {
            brdf,
            error: candidate.error,
        }
    }
}

/// Candidates for η − 1: from a steep rise towards grazing to hardly any.
const ETAS_LESS_1: [f64; 6] = [0.02, 0.1, 0.35, 0.8, 2.0, 9.0];
/// Number of golden-section steps between the candidates.
const ETA_STEPS: usize = 6;

/// Candidate with the best η: the best of a few, then golden-section search between its neighbours in ln(η − 1).
fn best_eta(objective: &mut Objective, point: SearchPoint) -> Candidate {
    let mut error = |ln_eta: f64| {
        let mut at = point;
        at[ETA_VARIABLE] = ln_eta;
        objective.error(at)
    };
    let tried: Vec<Candidate> = ETAS_LESS_1.iter().map(|x| error(x.ln())).collect();
    let lowest = (0..tried.len())
        .min_by(|a, b| tried[*a].error.total_cmp(&tried[*b].error))
        .unwrap_or(0);
    let end = |k: usize| tried[k.min(tried.len() - 1)].point[ETA_VARIABLE];
    let (mut low, mut high) = (end(lowest.saturating_sub(1)), end(lowest + 1));
    let mut best = tried[lowest];
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut inner = [high - golden * (high - low), low + golden * (high - low)];
    let mut errors = inner.map(&mut error);
    for _ in 0..ETA_STEPS {
        for candidate in errors {
            if candidate.error < best.error {
                best = candidate;
            }
        }
        if errors[0].error < errors[1].error {
            high = inner[1];
            (inner[1], errors[1]) = (inner[0], errors[0]);
            inner[0] = high - golden * (high - low);
            errors[0] = error(inner[0]);
        } else {
            low = inner[0];
            (inner[0], errors[0]) = (inner[1], errors[1]);
            inner[1] = low + golden * (high - low);
            errors[1] = error(inner[1]);
        }
    }
    best
}

impl Landscape {
    /// Node with the smallest E; `None` without nodes.
    pub fn lowest(&self) -> Option<&Node> {
        self.nodes.iter().min_by(|a, b| a.error.total_cmp(&b.error))
    }

    /// E interpolated linearly in ln s and α; clamped to the edges. `None` without nodes.
    pub fn error_at(&self, s: f64, alpha: f64) -> Option<f64> {
        let [(i, u), (j, v)] = self.place(s, alpha)?;
        let at = |i: usize, j: usize| Some(self.nodes.get(i + self.s.len() * j)?.error);
        let along = |j: usize| Some((1.0 - u) * at(i, j)? + u * at(i + 1, j)?);
        Some((1.0 - v) * along(j)? + v * along(j + 1)?)
    }

    /// Model of the nearest node with s and α replaced: its ρ_d, k_s and η are near the best ones there. `None` without
    /// nodes.
    pub fn model_at(&self, s: f64, alpha: f64) -> Option<Brdf> {
        let [(i, u), (j, v)] = self.place(s, alpha)?;
        let (i, j) = (i + u.round() as usize, j + v.round() as usize);
        let mut brdf = self.nodes.get(i + self.s.len() * j)?.brdf;
        let values = brdf.params.lobe.iter_mut().zip([s, alpha]);
        for ((to, value), row) in values.zip(brdf.model.params) {
            *to = row.clamp(value);
        }
        Some(brdf)
    }

    /// Column and row below (s, α), each with the share of the way to the next; `None` without nodes.
    fn place(&self, s: f64, alpha: f64) -> Option<[(usize, f64); 2]> {
        let (first, last) = (self.s.first()?, self.s.last()?);
        let split = |share: f64, count: usize| {
            let most = count.checked_sub(2)?;
            let x = share.clamp(0.0, 1.0) * (count - 1) as f64;
            let below = (x as usize).min(most);
            Some((below, x - below as f64))
        };
        Some([
            split((s / first).ln() / (last / first).ln(), self.s.len())?,
            split(alpha, self.alpha.len())?,
        ])
    }
}

#[cfg(test)]
mod tests;
