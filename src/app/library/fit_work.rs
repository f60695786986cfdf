//! The thread that fits the files of a folder, one after the other.

use super::fit_run::Said;
use super::{Hold, LibraryMsg};
use crate::app::fitting::Setup;
use crate::app::jobs::Outbox;
use crate::app::state::CancelFlag;
use crate::app::update::Msg;
use crate::files;
use crate::files::fits::FitRecord;
use crate::fit::{self, Problem, Progress, Variant};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

/// How often the bar moves: each message redraws the window.
const BETWEEN: Duration = Duration::from_millis(80);

/// Files to fit.
#[derive(Debug)]
pub struct FolderFit {
    /// The run's.
    pub number: u64,
    /// In this order.
    pub files: Vec<PathBuf>,
    /// What is fitted to each.
    pub variants: Vec<Variant>,
    /// How.
    pub setup: Setup,
    /// Ends it.
    pub cancel: CancelFlag,
    /// Makes it wait, in the middle of a fit too.
    pub hold: Hold,
}

impl FolderFit {
    /// Fits all files. What is under way when it is cancelled is thrown away.
    pub fn run(&self, outbox: &Outbox) {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        // Not the pool of the fits that are watched: while this one waits, its threads are taken.
        let pool = ThreadPoolBuilder::new()
            .num_threads((cores - 1).max(1))
            .thread_name(|k| format!("folder fit {k}"))
            .build()
            .ok();
        for file in &self.files {
            self.hold.wait(&self.cancel);
            self.say(outbox, Said::File(files::folder::shown_name(file)));
            let work = || self.fit(file, pool.as_ref(), outbox);
            let result = catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
                let what = "the fit stopped at an error of the program";
                Err(files::FileError::new(file, what).to_string())
            });
            let path = file.clone();
            self.say(outbox, Said::Done { path, result });
        }
        self.say(outbox, Said::End);
    }

    fn say(&self, outbox: &Outbox, said: Said) {
        if !self.cancel.is_set() {
            let number = self.number;
            outbox.send(Msg::Library(LibraryMsg::Fit { number, said }));
        }
    }

    fn go_on(&self) -> ControlFlow<()> {
        self.hold.wait(&self.cancel);
        if self.cancel.is_set() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn fit(
        &self,
        file: &Path,
        pool: Option<&ThreadPool>,
        outbox: &Outbox,
    ) -> Result<Vec<FitRecord>, String> {
        let read = files::open_measured(file, &mut |_| self.go_on());
        let (table, source) = read.map_err(|error| error.to_string())?;
        let Setup {
            weight,
            limit,
            options,
        } = self.setup;
        let mut told = Instant::now();
        let mut watch = |position: usize, progress: &Progress| {
            if told.elapsed() >= BETWEEN {
                told = Instant::now();
                let share = (position as f32 + progress.share) / self.variants.len().max(1) as f32;
                self.say(outbox, Said::Share(share));
            }
            self.go_on()
        };
        let work = || {
            let problem = Problem::new(&table, weight, limit)?;
            // The problem is all that the fit needs.
            drop(table);
            Ok(fit::fit_all(&problem, &self.variants, &options, &mut watch))
        };
        let outcomes = match pool {
            Some(pool) => pool.install(work),
            None => work(),
        };
        let outcomes = outcomes.map_err(|error: fit::ProblemError| {
            files::FileError::new(file, error.to_string()).to_string()
        })?;
        let name = files::material_name(file);
        let record = |outcome| {
            let asked = (weight, limit.to_degrees());
            FitRecord::new(name.clone(), Some(source.clone()), asked, &options, outcome)
        };
        Ok(outcomes.iter().map(record).collect())
    }
}
