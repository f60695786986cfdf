//! Descents of the stages: side by side on a sample, alone on all cells.

use super::super::descent::{self, Rules};
use super::super::linear::{Matrix, Vector};
use super::super::objective::{AmplitudeRule, Candidate, Objective};
use super::super::outcome::{FitProgress, Watch};
use super::super::problem::Problem;
use super::super::symmetric_cells::SymmetricCells;
use super::super::threads::Threads;
use super::StagedFit;
use crate::brdf::Brdf;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Cells and stopping rules of a descent.
pub(super) struct Refinement<'a> {
    cells: &'a SymmetricCells,
    threads: Threads,
    tolerance: f64,
    evaluations: usize,
}

impl<'a> Refinement<'a> {
    /// Descents on the small sample, which sort out starts.
    pub(super) fn coarse(problem: &'a Problem) -> Self {
        Self {
            cells: &problem.coarse,
            threads: Threads::One,
            tolerance: 1e-4,
            evaluations: 60,
        }
    }

    /// Descents on the larger sample.
    pub(super) fn medium(problem: &'a Problem) -> Self {
        Self {
            cells: &problem.medium,
            tolerance: 1e-5,
            ..Self::coarse(problem)
        }
    }

    /// Descent on all cells, before another stage that goes on.
    fn all(problem: &'a Problem) -> Self {
        Self {
            cells: &problem.all,
            threads: Threads::Many,
            ..Self::coarse(problem)
        }
    }

    /// Final descent on all cells.
    fn last(problem: &'a Problem) -> Self {
        Self {
            tolerance: 1e-5,
            ..Self::all(problem)
        }
    }
}

/// Observer of a fit, shared by descents side by side.
struct SharedWatch<'w> {
    watch: Watch<'w>,
    last_report: Option<FitProgress>,
    stopped: bool,
}

impl SharedWatch<'_> {
    /// Reports an evaluation, with its model where that is better than the last reported. Returns whether to go on.
    fn report(&mut self, error: f64, brdf: impl FnOnce() -> Brdf) -> bool {
        let Some(last_report) = self.last_report.as_mut().filter(|_| !self.stopped) else {
            return !self.stopped;
        };
        last_report.evaluations += 1;
        if error < last_report.error {
            (last_report.brdf, last_report.error, last_report.all_cells) = (brdf(), error, false);
        }
        self.stopped = (self.watch)(last_report).is_break();
        !self.stopped
    }
}

impl<'a> StagedFit<'a, '_> {
    /// Runs descents on a sample from several points, each on a thread of its own; the best end first. Starts and ends
    /// are candidates with the approximate Hessian, if known.
    pub(super) fn descend_side_by_side(
        &mut self,
        starts: impl Iterator<Item = (Candidate, Option<Matrix>)>,
        refinement: &Refinement,
        rule: AmplitudeRule,
    ) -> Vec<(Candidate, Option<Matrix>)> {
        let starts: Vec<_> = starts.collect();
        let rules = self.rules(refinement);
        let (space, options) = (&self.space, self.options);
        let watched = Mutex::new(SharedWatch {
            watch: &mut *self.watch,
            last_report: self.last_report,
            stopped: self.cancelled,
        });
        let mut ends: Vec<_> = starts
            .par_iter()
            .map(|(start, curvature)| {
                let mut objective = Objective::new(
                    refinement.cells,
                    space.variant,
                    rule,
                    Some(start),
                    refinement.threads,
                );
                let mut evaluate = |p: Vector| {
                    let value = objective.value(p);
                    let best = objective.best?;
                    let brdf = || space.brdf(&best, options);
                    // What another thread left is whole: a watcher that panics ends them all.
                    let mut watched = watched.lock().unwrap_or_else(PoisonError::into_inner);
                    watched.report(best.error, brdf).then_some(value)
                };
                let end = descent::descend(start.point, *curvature, &rules, &mut evaluate);
                let curvature = end.and_then(|end| end.curvature);
                let best = objective.best.unwrap_or(*start);
                (best, curvature, objective.evaluations)
            })
            .collect();
        let watched = watched.into_inner().unwrap_or_else(PoisonError::into_inner);
        (self.last_report, self.cancelled) = (watched.last_report, watched.stopped);
        self.evaluations += ends.iter().map(|end| end.2).sum::<usize>();
        ends.sort_by(|a, b| a.0.error.total_cmp(&b.0.error));
        ends.into_iter()
            .map(|(end, curvature, _)| (end, curvature))
            .collect()
    }

    /// Runs a descent on the larger sample and then one on all cells.
    pub(super) fn descend_levels(&mut self, start: &Candidate, rule: AmplitudeRule) -> Candidate {
        let near = std::iter::once((*start, None));
        let alone = Refinement {
            threads: Threads::Many,
            ..Refinement::medium(self.problem)
        };
        let ends = self.descend_side_by_side(near, &alone, rule);
        match ends.first() {
            Some((end, curvature)) if !self.cancelled => self.descend_all(end, *curvature, rule),
            Some((end, _)) => *end,
            None => *start,
        }
    }

    /// Runs a descent on all cells, reported at every step.
    pub(super) fn descend_all(
        &mut self,
        start: &Candidate,
        curvature: Option<Matrix>,
        rule: AmplitudeRule,
    ) -> Candidate {
        let refinement = if self.is_last() {
            Refinement::last(self.problem)
        } else {
            Refinement::all(self.problem)
        };
        let rules = self.rules(&refinement);
        let mut objective = self.objective(refinement.cells, rule, Some(start));
        let mut evaluate = |p: Vector| {
            let value = objective.value(p);
            self.evaluations += 1;
            let best = objective.best?;
            self.report_progress(&best, best.error, true)
                .is_continue()
                .then_some(value)
        };
        let end = descent::descend(start.point, curvature, &rules, &mut evaluate);
        if end.is_some_and(|end| !end.converged) {
            self.exhausted = true;
        }
        objective.best.unwrap_or(*start)
    }

    fn rules(&self, refinement: &Refinement) -> Rules {
        Rules {
            bounds: self.space.bounds,
            tolerance: refinement.tolerance,
            evaluations: refinement.evaluations,
            first_step: 0.15,
        }
    }

    pub(super) fn objective(
        &self,
        cells: &'a SymmetricCells,
        rule: AmplitudeRule,
        near: Option<&Candidate>,
    ) -> Objective<'a> {
        Objective::new(cells, self.space.variant, rule, near, Threads::Many)
    }
}
