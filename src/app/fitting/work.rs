//! The threads behind fitting: one per fit, one that re-solves, and what they share.

use super::{FitMsg, FitTask, Heard, Resolve, Setup, Timed};
use crate::app::jobs::Outbox;
use crate::app::state::CancelFlag;
use crate::app::update::Msg;
use crate::fit::{self, Problem, ProblemError, Progress, Weight};
use crate::measured::Table;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// How long the end of the program waits for a fit that was told to stop.
const PATIENCE: Duration = Duration::from_millis(300);

/// Runs fits and re-solves.
pub struct Fitter {
    shared: Arc<Shared>,
    resolves: Sender<Resolve>,
    fits: Vec<JoinHandle<()>>,
}

struct Shared {
    outbox: Outbox,
    /// What the newest fit has said since the window looked. Short locks: the window takes it at each frame.
    slot: Mutex<Option<Heard>>,
    /// The last problem; the next fit and the live re-solves mostly ask the same.
    problem: Mutex<Option<(Key, Arc<Problem>)>>,
    /// One core is left to the window. `None` where no pool could be made: then rayon's own is used.
    fit_pool: Option<ThreadPool>,
    /// Apart from the fits', or a re-solve would wait for the end of a fit.
    resolve_pool: Option<ThreadPool>,
}

/// The table is known by its place in memory, which the weak reference keeps from being used again.
struct Key(Weak<Table>, Weight, u64);

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.0.ptr_eq(&other.0) && (self.1, self.2) == (other.1, other.2)
    }
}

impl Fitter {
    /// Starts the thread that re-solves. It ends with the fitter.
    pub fn start(outbox: Outbox) -> std::io::Result<Self> {
        let pool = |name: &'static str| {
            let cores = thread::available_parallelism().map_or(1, usize::from);
            ThreadPoolBuilder::new()
                .num_threads((cores - 1).max(1))
                .thread_name(move |k| format!("{name} {k}"))
                .build()
                .ok()
        };
        let shared = Arc::new(Shared {
            outbox,
            slot: Mutex::new(None),
            problem: Mutex::new(None),
            fit_pool: pool("fit"),
            resolve_pool: pool("re-solve"),
        });
        let (resolves, asked) = channel::<Resolve>();
        let of_thread = Arc::clone(&shared);
        thread::Builder::new()
            .name("re-solve".into())
            .spawn(move || {
                while let Ok(oldest) = asked.recv() {
                    // The newest wins.
                    let newest = asked.try_iter().last().unwrap_or(oldest);
                    of_thread.resolve(&newest);
                }
            })?;
        Ok(Self {
            shared,
            resolves,
            fits: Vec::new(),
        })
    }

    /// What the newest fit has said since this was asked last.
    pub fn heard(&self) -> Option<Heard> {
        lock(&self.shared.slot).take()
    }

    /// Starts a fit. The one before it is to be told to stop by its flag.
    pub fn fit(&mut self, task: FitTask) {
        self.fits.retain(|thread| !thread.is_finished());
        let (shared, job) = (Arc::clone(&self.shared), task.job);
        let started = thread::Builder::new()
            .name("fit".into())
            .spawn(move || shared.fit(&task));
        match started {
            Ok(thread) => self.fits.push(thread),
            Err(error) => self.shared.outbox.send(Msg::Fit(FitMsg::Done {
                job,
                rest: None,
                result: Err(format!("could not start a thread for the fit: {error}")),
            })),
        }
    }

    /// Asks for the best ρ_d and k_s of a model; the newest question is the one that is answered.
    pub fn resolve(&self, resolve: Resolve) {
        // The thread lives as long as the fitter.
        let _ = self.resolves.send(resolve);
    }

    /// Waits a moment for fits that were told to stop, so that the program does not end in the middle of them.
    pub fn finish(&mut self) {
        let start = Instant::now();
        while start.elapsed() < PATIENCE && !self.fits.iter().all(JoinHandle::is_finished) {
            thread::sleep(Duration::from_millis(2));
        }
        for thread in self.fits.drain(..).filter(JoinHandle::is_finished) {
            let _ = thread.join();
        }
    }
}

impl Shared {
    fn fit(&self, task: &FitTask) {
        let result = catch_unwind(AssertUnwindSafe(|| self.run_fit(task))).unwrap_or_else(|_| {
            Err("The fit stopped at an error of the program; the model is as it was left.".into())
        });
        let rest = lock(&self.slot).take_if(|heard| heard.job == task.job);
        self.outbox.send(Msg::Fit(FitMsg::Done {
            job: task.job,
            rest,
            result,
        }));
    }

    fn run_fit(&self, task: &FitTask) -> Result<Vec<Timed>, String> {
        let pool = self.fit_pool.as_ref();
        let problem = self
            .problem(pool, &task.table, &task.setup)
            .map_err(|error| error.to_string())?;
        let mut clock = Clock::start(task.variants.len());
        let mut watch = |position: usize, progress: &Progress| {
            clock.heard(position);
            self.say(task.job, position, progress, &task.cancel)
        };
        let options = &task.setup.options;
        let outcomes = install(pool, || match task.variants[..] {
            _ if task.cancel.is_set() => Vec::new(),
            [variant] => vec![fit::fit(&problem, variant, options, &mut |progress| {
                watch(0, progress)
            })],
            _ => fit::fit_all(&problem, &task.variants, options, &mut watch),
        });
        let seconds = clock.stop();
        let timed = outcomes.into_iter().zip(seconds);
        Ok(timed
            .map(|(outcome, seconds)| Timed { outcome, seconds })
            .collect())
    }

    /// Puts a word into the slot.
    fn say(
        &self,
        job: u64,
        position: usize,
        progress: &Progress,
        cancel: &CancelFlag,
    ) -> ControlFlow<()> {
        if cancel.is_set() {
            return ControlFlow::Break(());
        }
        let mut slot = lock(&self.slot);
        let heard = slot.get_or_insert_default();
        if heard.job < job {
            *heard = Heard {
                job,
                words: Vec::new(),
            };
        }
        // Of a replaced fit otherwise, which nobody hears.
        if heard.job == job {
            heard.words.push((position, *progress));
        }
        drop(slot);
        self.outbox.wake();
        ControlFlow::Continue(())
    }

    fn resolve(&self, resolve: &Resolve) {
        let work = || {
            let pool = self.resolve_pool.as_ref();
            let problem = self.problem(pool, &resolve.table, &resolve.setup)?;
            Ok(install(pool, || {
                problem.with_best_amplitudes(&resolve.brdf)
            }))
        };
        // A panic is said on standard error; the sliders stay as they are.
        if let Ok(result) = catch_unwind(AssertUnwindSafe(work)) {
            self.outbox.send(Msg::Fit(FitMsg::Resolved {
                number: resolve.number,
                material: resolve.material,
                as_step: resolve.as_step,
                result,
            }));
        }
    }

    /// The problem from the last time, or a new one. Made under the lock: whoever wants the same one waits for it.
    /// Not to be called inside a pool: its thread could take up another fit meanwhile, and wait for itself.
    fn problem(
        &self,
        pool: Option<&ThreadPool>,
        table: &Arc<Table>,
        setup: &Setup,
    ) -> Result<Arc<Problem>, ProblemError> {
        let key = Key(Arc::downgrade(table), setup.weight, setup.limit.to_bits());
        let mut kept = lock(&self.problem);
        if let Some((_, problem)) = kept.as_ref().filter(|(other, _)| *other == key) {
            return Ok(Arc::clone(problem));
        }
        // Two need not be in memory at once.
        *kept = None;
        let problem = Arc::new(install(pool, || {
            Problem::new(table, setup.weight, setup.limit)
        })?);
        *kept = Some((key, Arc::clone(&problem)));
        Ok(problem)
    }
}

/// Seconds per variant: the time up to each word is its variant's.
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

    fn heard(&mut self, position: usize) {
        let now = Instant::now();
        if let Some(seconds) = self.seconds.get_mut(position) {
            *seconds += (now - self.last).as_secs_f64();
            self.at = position;
        }
        self.last = now;
    }

    fn stop(mut self) -> Vec<f64> {
        self.heard(self.at);
        self.seconds
    }
}

fn install<R: Send>(pool: Option<&ThreadPool>, work: impl FnOnce() -> R + Send) -> R {
    match pool {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

/// What a panic left behind is still whole: every write under these locks is a single one.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
