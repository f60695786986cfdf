//! The descents of the stages: side by side on a sample, alone on all cells.

use super::super::Problem;
use super::super::descent::{self, Rules};
use super::super::objective::{Candidate, Follow, Objective};
use super::super::shape::Threads;
use super::super::sites::Sites;
use super::Engine;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// How far a descent goes on some of the cells.
pub(super) struct Level<'a> {
    sites: &'a Sites,
    threads: Threads,
    tolerance: f64,
    evaluations: usize,
}

impl<'a> Level<'a> {
    /// To sort out starts.
    pub(super) fn coarse(problem: &'a Problem) -> Self {
        Self {
            sites: &problem.coarse,
            threads: Threads::One,
            tolerance: 1e-4,
            evaluations: 60,
        }
    }

    /// To come near.
    pub(super) fn medium(problem: &'a Problem) -> Self {
        Self {
            sites: &problem.medium,
            tolerance: 1e-5,
            ..Self::coarse(problem)
        }
    }

    /// The last word.
    fn all(problem: &'a Problem) -> Self {
        Self {
            sites: &problem.all,
            threads: Threads::Many,
            ..Self::medium(problem)
        }
    }
}

impl<'a> Engine<'a, '_> {
    /// Descents on a sample from several points, each on a thread of its own.
    pub(super) fn descend_side_by_side(
        &mut self,
        starts: impl Iterator<Item = (Candidate, Option<DMat3>)>,
        level: &Level,
        follow: Follow,
    ) -> Vec<(Candidate, Option<DMat3>)> {
        let starts: Vec<_> = starts.collect();
        let fresnel = self.space.variant.fresnel;
        let rules = self.rules(level);
        let ends: Vec<_> = starts
            .par_iter()
            .map(|(start, curvature)| {
                let mut objective =
                    Objective::new(level.sites, fresnel, follow, Some(start), level.threads);
                let mut evaluate = |p: DVec3| Some(objective.value(p.to_array()));
                let end = descent::descend(
                    DVec3::from_array(start.point),
                    *curvature,
                    &rules,
                    &mut evaluate,
                );
                let curvature = end.and_then(|end| end.curvature);
                (
                    objective.best.unwrap_or(*start),
                    curvature,
                    objective.evaluations,
                )
            })
            .collect();
        self.evaluations += ends.iter().map(|end| end.2).sum::<usize>();
        ends.into_iter()
            .map(|(end, curvature, _)| (end, curvature))
            .collect()
    }

    /// A descent on the larger sample and then on all cells.
    pub(super) fn descend_levels(&mut self, start: &Candidate, follow: Follow) -> Candidate {
        let near = std::iter::once((*start, None));
        let ends = self.descend_side_by_side(near, &Level::medium(self.problem), follow);
        self.show_best(&ends);
        match ends.first() {
            Some((end, curvature)) if !self.cancelled => self.descend_all(end, *curvature, follow),
            _ => *start,
        }
    }

    /// A descent on all cells, watched at every step.
    pub(super) fn descend_all(
        &mut self,
        start: &Candidate,
        curvature: Option<DMat3>,
        follow: Follow,
    ) -> Candidate {
        let level = Level::all(self.problem);
        let rules = self.rules(&level);
        let mut objective = self.objective(level.sites, follow, Some(start));
        let mut evaluate = |p: DVec3| {
            let value = objective.value(p.to_array());
            self.evaluations += 1;
            let best = objective.best?;
            self.report_progress(&best, best.error, true)
                .is_continue()
                .then_some(value)
        };
        let end = descent::descend(
            DVec3::from_array(start.point),
            curvature,
            &rules,
            &mut evaluate,
        );
        if end.is_some_and(|end| !end.converged) {
            self.exhausted = true;
        }
        objective.best.unwrap_or(*start)
    }

    fn rules(&self, level: &Level) -> Rules {
        Rules {
            bounds: self.space.bounds,
            tolerance: level.tolerance,
            evaluations: level.evaluations,
            first_step: 0.15,
        }
    }

    pub(super) fn objective(
        &self,
        sites: &'a Sites,
        follow: Follow,
        near: Option<&Candidate>,
    ) -> Objective<'a> {
        Objective::new(
            sites,
            self.space.variant.fresnel,
            follow,
            near,
            Threads::Many,
        )
    }
}
