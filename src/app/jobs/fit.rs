//! Fits of the shown material in the background, and fits of ρ_d and k_s alone.

use crate::app::msg::Msg;
use crate::app::msg::fit::{FitMsg, FitTask, RefitAmplitudes, Timed};
use crate::app::msg::work::{SendMsg, Work};
use crate::app::state::fitting::run::FitUpdates;
use crate::app::state::fitting::settings::Setup;
use crate::fit;
use crate::fit::{FitProgress, Problem, ProblemError, Weight};
use crate::measured::Table;
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::{Duration, Instant};

/// Least time between two reports of a fit to the window: about a frame.
const BETWEEN_UPDATES: Duration = Duration::from_millis(12);

/// The last fit problem, kept because the next fit and the refits of amplitudes mostly ask for the same one.
#[derive(Default)]
pub struct Problems(Mutex<Option<(ProblemKey, Arc<Problem>)>>);

/// The table is known by its place in memory, which the weak reference keeps from being used again.
struct ProblemKey(Weak<Table>, Weight, u64);

impl PartialEq for ProblemKey {
    fn eq(&self, other: &Self) -> bool {
        self.0.ptr_eq(&other.0) && (self.1, self.2) == (other.1, other.2)
    }
}

impl Problems {
    /// The problem from the last time, or a new one. Made under the lock: whoever asks for the same one waits for it.
    fn get(&self, table: &Arc<Table>, setup: &Setup) -> Result<Arc<Problem>, ProblemError> {
        let key = ProblemKey(Arc::downgrade(table), setup.weight, setup.limit.to_bits());
        // What a panic left behind is still whole: each write is a single one.
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, problem)) = kept.as_ref().filter(|(other, _)| *other == key) {
            return Ok(Arc::clone(problem));
        }
        // Two need not be in memory at once.
        *kept = None;
        let problem = Arc::new(Problem::new(table, setup.weight, setup.limit)?);
        *kept = Some((key, Arc::clone(&problem)));
        Ok(problem)
    }
}

/// Fits one variant or several. The fit before it is to be told to stop by its flag.
pub fn fit(task: FitTask, problems: Arc<Problems>) -> Work {
    let job = task.job;
    let done = move |result| Msg::Fit(FitMsg::Done { job, result });
    Work::new("fitting", move |send| {
        send(done(run(&task, &problems, send)));
    })
    .or_tell(move |text| done(Err(text)))
}

fn run(task: &FitTask, problems: &Problems, send: &SendMsg) -> Result<Vec<Timed>, String> {
    let problem = problems.get(&task.table, &task.setup);
    let problem = problem.map_err(|error| error.to_string())?;
    let mut clock = Clock::start(task.variants.len());
    let mut reporter = Reporter::new(task.job, send);
    let mut watch = |position: usize, progress: &FitProgress| {
        clock.tick(position);
        if task.cancel.is_set() {
            return ControlFlow::Break(());
        }
        reporter.report(position, progress);
        ControlFlow::Continue(())
    };
    let options = &task.setup.options;
    let outcomes = match task.variants[..] {
        _ if task.cancel.is_set() => Vec::new(),
        [variant] => vec![fit::fit(&problem, variant, options, &mut |progress| {
            watch(0, progress)
        })],
        _ => fit::fit_all(&problem, &task.variants, options, &mut watch),
    };
    reporter.flush();
    let timed = outcomes.into_iter().zip(clock.stop());
    Ok(timed
        .map(|(outcome, seconds)| Timed { outcome, seconds })
        .collect())
}

/// Tells the window how a fit goes, about once a frame.
struct Reporter<'a> {
    send: &'a SendMsg<'a>,
    last: Instant,
    updates: FitUpdates,
}

impl<'a> Reporter<'a> {
    fn new(job: u64, send: &'a SendMsg<'a>) -> Self {
        let updates = Vec::new();
        Self {
            send,
            last: Instant::now(),
            updates: FitUpdates { job, updates },
        }
    }

    fn report(&mut self, position: usize, progress: &FitProgress) {
        self.updates.updates.push((position, *progress));
        if self.last.elapsed() >= BETWEEN_UPDATES {
            self.flush();
        }
    }

    fn flush(&mut self) {
        self.last = Instant::now();
        if !self.updates.updates.is_empty() {
            let job = self.updates.job;
            let updates = std::mem::take(&mut self.updates.updates);
            (self.send)(Msg::Fit(FitMsg::Updates(FitUpdates { job, updates })));
        }
    }
}

/// Finds the best ρ_d and k_s of a model; of several that are asked for, the newest.
pub fn refit_amplitudes(task: RefitAmplitudes, problems: Arc<Problems>) -> Work {
    let run = move |send: &SendMsg| {
        let problem = problems.get(&task.table, &task.setup);
        send(Msg::Fit(FitMsg::AmplitudesRefit {
            number: task.number,
            material: task.material,
            as_step: task.as_step,
            result: problem.map(|problem| problem.with_best_amplitudes(&task.brdf)),
        }));
    };
    Work::new("finding the best ρd and ks", run).newest("amplitudes")
}

/// Seconds per variant: the time up to each update is its variant's.
struct Clock {
    last: Instant,
    at: usize,
    seconds: Vec<f64>,
}

impl Clock {
    fn start(variants: usize) -> Self {
        Self {
            last: Instant::now(),
            at: 0,
            seconds: vec![0.0; variants],
        }
    }

    fn tick(&mut self, position: usize) {
        let now = Instant::now();
        if let Some(seconds) = self.seconds.get_mut(position) {
            *seconds += (now - self.last).as_secs_f64();
            self.at = position;
        }
        self.last = now;
    }

    fn stop(mut self) -> Vec<f64> {
        self.tick(self.at);
        self.seconds
    }
}
