//! The staged fit [Nielsen14] and the joint stage after it.

mod descents;

use super::amplitudes::AmplitudeBounds;
use super::diagnostics;
use super::exact_l1;
use super::kernels;
use super::lobes::LobeShape;
use super::multistart::{self, StartGrid};
use super::objective::{AmplitudeRule, Candidate, SearchSpace};
use super::options::{FitOptions, Variant};
use super::outcome::{ALBEDO_ANGLES, EndReason, Errors, FitProgress, Outcome, StageReport, Watch};
use super::problem::Problem;
use super::regression::{self, Effort};
use super::stages::Stage;
use super::threads::Threads;
use crate::brdf::{Brdf, albedo};
use descents::Refinement;
use std::ops::ControlFlow;

/// A candidate with its parameters as they are reported and its E over all cells.
#[derive(Clone, Copy, Debug)]
struct Best {
    candidate: Candidate,
    /// Reported parameters; those of `candidate` differ from them by rounding.
    brdf: Brdf,
    /// E of `brdf` over all cells.
    errors: Errors,
}

/// State of a running fit.
pub(super) struct StagedFit<'a, 'w> {
    problem: &'a Problem,
    options: &'a FitOptions,
    space: SearchSpace,
    watch: Watch<'w>,
    /// Last progress report.
    last_report: Option<FitProgress>,
    cancelled: bool,
    exhausted: bool,
    /// Starts that the data suggest, once they are asked for.
    starts: Option<Vec<Candidate>>,
    /// Grid that the starts are chosen from, shared with other fits.
    grid: &'w mut StartGrid,
    /// Contained fits as candidates, with the model that equals each of them.
    contained_fits: Vec<(Candidate, Brdf)>,
    stages: Vec<StageReport>,
    stage: Stage,
    evaluations: usize,
}

/// Fits the contained variants, asking at intervals whether to go on; returns each with its errors.
type Contained<'c> = &'c mut dyn FnMut(
    &mut StartGrid,
    &mut (dyn FnMut() -> ControlFlow<()> + Send),
) -> Vec<(Brdf, Errors)>;

impl<'a, 'w> StagedFit<'a, 'w> {
    pub fn new(
        problem: &'a Problem,
        variant: Variant,
        options: &'a FitOptions,
        grid: &'w mut StartGrid,
        watch: Watch<'w>,
    ) -> Self {
        Self {
            problem,
            options,
            space: SearchSpace::new(variant, options, problem.units()),
            watch,
            last_report: None,
            cancelled: false,
            exhausted: false,
            starts: None,
            grid,
            contained_fits: Vec::new(),
            stages: Vec::new(),
            stage: Stage::Amplitudes,
            evaluations: 0,
        }
    }

    /// Runs the stages that the options choose. `contained` fits the variants that this one contains, as starts of
    /// stage 4.
    pub fn run(mut self, contained: Contained) -> Outcome {
        let start = self.start();
        let mut best = self.measure(start);
        for stage in self.options.stages.iter() {
            if self.cancelled {
                break;
            }
            self.stage = stage;
            self.evaluations = 0;
            let before = best;
            let _ = self.report_progress(&before.candidate, before.errors.total, true);
            let found = match stage {
                Stage::Amplitudes => self.amplitudes(&before),
                Stage::Shape => self.shape(&before),
                Stage::ShapeAndSpecular => self.shape_and_specular(&before),
                Stage::Joint => self.joint(&before, contained),
            };
            for found in found {
                if found.errors.total < best.errors.total {
                    best = found;
                }
            }
            self.stages.push(StageReport {
                stage,
                start: before.brdf,
                start_error: before.errors.total,
                end: best.brdf,
                error: best.errors.total,
                evaluations: self.evaluations,
            });
            let _ = self.report_progress(&best.candidate, best.errors.total, true);
        }
        self.outcome(best)
    }

    fn outcome(self, best: Best) -> Outcome {
        let brdf = best.brdf;
        let albedo = ALBEDO_ANGLES.map(|degrees| albedo::albedo(&brdf, degrees.to_radians()));
        Outcome {
            brdf,
            errors: best.errors,
            evaluations: self.stages.iter().map(|stage| stage.evaluations).sum(),
            stages: self.stages,
            ended: match (self.cancelled, self.exhausted) {
                (true, _) => EndReason::Cancelled,
                (_, true) => EndReason::Limit,
                _ => EndReason::Converged,
            },
            concerns: diagnostics::diagnose(&brdf, self.options, &albedo),
            albedo,
        }
    }

    /// Start of stage 1: the user's start where it is complete, else the best start of the data.
    fn start(&mut self) -> Candidate {
        let given = &self.options.start;
        let variant = self.space.variant;
        let defaults = Brdf::new(variant.model, variant.fresnel);
        let mut shared = defaults.used().filter(|row| !row.id.is_color());
        let complete = shared.all(|row| given.has(row.id) || self.options.held.has(row.id));
        let from_data = if complete {
            None
        } else {
            self.starts().first().copied()
        };
        let brdf = match from_data {
            Some(start) => self.space.brdf(&start, self.options),
            None => defaults,
        };
        let given = &self.options.start;
        let brdf = self.options.held.over(given.over(brdf));
        let point = self.space.clamp(self.space.point(&brdf));
        let mut objective = self.objective(
            &self.problem.coarse,
            AmplitudeRule::Optimised(self.space.limits),
            None,
        );
        let mut start = objective.error(point);
        // Amplitudes that are given are where the stages begin, unless the first of them solves for its own.
        let amplitudes = self.space.units.amplitudes(&brdf.params);
        if given.rho_d.is_some() {
            start.amplitudes.diffuse = amplitudes.diffuse;
        }
        if given.k_s.is_some() {
            start.amplitudes.specular = amplitudes.specular;
        }
        start.amplitudes = self.space.limits.clamp(start.amplitudes);
        start
    }

    fn starts(&mut self) -> &[Candidate] {
        let (coarse, space) = (&self.problem.coarse, &self.space);
        self.starts
            .get_or_insert_with(|| multistart::best_starts(coarse, space, self.grid))
    }

    /// Stage 1: ρ_d and k_s, exact.
    fn amplitudes(&mut self, before: &Best) -> Vec<Best> {
        self.evaluations += 1;
        vec![self.solve(&before.candidate, &self.space.limits, true)]
    }

    /// Stage 2: s, α, η for fixed ρ_d and k_s.
    fn shape(&mut self, before: &Best) -> Vec<Best> {
        let rule = AmplitudeRule::Fixed(before.candidate.amplitudes);
        let found = self.descend_levels(&before.candidate, rule);
        vec![self.measure(found)]
    }

    /// Stage 3: s, α, η, k_s for fixed ρ_d.
    fn shape_and_specular(&mut self, before: &Best) -> Vec<Best> {
        let mut limits = self.space.limits;
        limits.diffuse = before.candidate.amplitudes.diffuse.map(|a| (a, a));
        let found = self.descend_levels(&before.candidate, AmplitudeRule::Optimised(limits));
        vec![self.solved_end(found, &limits)]
    }

    /// Stage 4: descents from the data's starts on the small sample, from the best of these, from the end of the stages
    /// before and from the contained fits on the larger one, and from the best of all on all cells.
    fn joint(&mut self, before: &Best, contained: Contained) -> Vec<Best> {
        let rule = AmplitudeRule::Optimised(self.space.limits);
        let mut found = Vec::new();
        let mut near: Vec<Candidate> = vec![before.candidate];
        let contained = {
            let shown = before.candidate;
            let error = before.errors.total;
            let mut grid = std::mem::take(self.grid);
            let found = contained(&mut grid, &mut || self.report_progress(&shown, error, true));
            *self.grid = grid;
            found
        };
        for (inner, errors) in contained {
            let brdf = inner.with_model(self.space.variant.model);
            let candidate = Candidate {
                point: self.space.point(&brdf),
                amplitudes: self.space.units.amplitudes(&brdf.params),
                error: errors.total,
            };
            near.push(candidate);
            self.contained_fits.push((candidate, brdf));
            found.push(Best {
                candidate,
                brdf,
                errors,
            });
        }
        if self.cancelled {
            return found;
        }
        let starts = self.starts().to_vec();
        let starts = starts.into_iter().map(|start| (start, None));
        let mut ends = self.descend_side_by_side(starts, &Refinement::coarse(self.problem), rule);
        if self.cancelled {
            found.extend(ends.first().map(|end| self.measure(end.0)));
            return found;
        }
        let limit = ends
            .first()
            .map_or(f64::INFINITY, |best| 1.03 * best.0.error);
        ends.retain(|end| end.0.error <= limit);
        let variant = self.space.variant;
        ends.dedup_by(|a, b| multistart::nearly_equal(variant, a.0.point, b.0.point));
        ends.truncate(2);
        ends.extend(near.into_iter().map(|candidate| (candidate, None)));
        let medium = Refinement::medium(self.problem);
        let ends = self.descend_side_by_side(ends.into_iter(), &medium, rule);
        if let Some((start, curvature)) = ends.first() {
            if self.cancelled {
                found.push(self.measure(*start));
                return found;
            }
            let end = self.descend_all(start, *curvature, rule);
            found.push(self.solved_end(end, &self.space.limits));
        }
        found
    }

    /// End of a descent with its amplitudes solved on all cells, exactly in the last stage; merely measured where the fit
    /// was cancelled.
    fn solved_end(&self, end: Candidate, limits: &AmplitudeBounds) -> Best {
        if self.cancelled {
            self.measure(end)
        } else {
            self.solve(&end, limits, self.is_last())
        }
    }

    /// Whether this is stage 4 or stage 4 is not run, so that no stage that moves everything follows.
    fn is_last(&self) -> bool {
        self.stage == Stage::Joint || !self.options.runs(Stage::Joint)
    }

    /// Candidate with E over all cells.
    fn measure(&self, mut candidate: Candidate) -> Best {
        let brdf = self.brdf(&candidate);
        let errors = self.problem.errors(&brdf);
        candidate.error = errors.total;
        Best {
            candidate,
            brdf,
            errors,
        }
    }

    /// Candidate with its amplitudes solved on all cells and its E: exactly, or near the minimum by regression alone.
    fn solve(&self, near: &Candidate, limits: &AmplitudeBounds, exactly: bool) -> Best {
        let all = &self.problem.all;
        let shape = LobeShape::at(self.space.variant, &near.point);
        let shapes = kernels::shapes(&*shape.kernel(), all);
        let (mut amplitudes, _) = regression::solve(
            all,
            &shapes,
            &near.amplitudes,
            limits,
            Effort::CLOSE.near_error(near.error),
            Threads::Many,
        );
        if exactly {
            amplitudes = exact_l1::solve(all, &shapes, &amplitudes, limits);
        }
        self.measure(Candidate {
            amplitudes,
            ..*near
        })
    }

    fn brdf(&self, candidate: &Candidate) -> Brdf {
        // Through logarithms and back a number may differ in its last digit, and a fit be worse than one it contains.
        let is_this = |known: &&(Candidate, Brdf)| {
            known.0.point == candidate.point && known.0.amplitudes == candidate.amplitudes
        };
        match self.contained_fits.iter().find(is_this) {
            Some((_, brdf)) => *brdf,
            None => self.space.brdf(candidate, self.options),
        }
    }

    fn report_progress(
        &mut self,
        candidate: &Candidate,
        error: f64,
        all_cells: bool,
    ) -> ControlFlow<()> {
        if self.cancelled {
            return ControlFlow::Break(());
        }
        let progress = FitProgress {
            stage: self.stage,
            brdf: self.brdf(candidate),
            error,
            all_cells,
            evaluations: self.evaluations,
            share: self.share(),
        };
        self.last_report = Some(progress);
        let flow = (self.watch)(&progress);
        self.cancelled |= flow.is_break();
        flow
    }

    /// Share of the fit that is done, in [0, 1]: stages are weighted by their cost.
    fn share(&self) -> f32 {
        let cost = |stage: Stage| match stage {
            Stage::Amplitudes => 1.0,
            Stage::Shape => 2.0,
            Stage::ShapeAndSpecular => 4.0,
            Stage::Joint => 6.0,
        };
        let all = || self.options.stages.iter();
        let total: f32 = all().map(cost).sum();
        let done: f32 = all().filter(|stage| *stage < self.stage).map(cost).sum();
        let within = 1.0 - (-0.05 * self.evaluations as f32).exp();
        (done + cost(self.stage) * within) / total.max(1.0)
    }
}
