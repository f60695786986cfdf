//! Fits of the files of a folder, one after the other.

use crate::app::jobs::Jobs;
use crate::app::msg::Msg;
use crate::app::msg::library::{FolderFit, FolderFitUpdate, LibraryMsg};
use crate::app::msg::work::{SendMsg, Work};
use crate::app::state::fitting::settings::Setup;
use crate::files::FileError;
use crate::files::fits::FitRecord;
use crate::fit::{FitProgress, Problem};
use crate::{files, fit};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Least time between two moves of the bar: each message redraws the window.
const BETWEEN_UPDATES: Duration = Duration::from_millis(80);

/// Fits all files, a job each. The one under way when it is cancelled is thrown away.
pub fn start(folder_fit: FolderFit, jobs: &Jobs) {
    let folder_fit = Arc::new(folder_fit);
    for path in folder_fit.files.clone() {
        jobs.start(fit_file(Arc::clone(&folder_fit), path));
    }
    let number = folder_fit.number;
    let end = move |send: &SendMsg| send(update(number, FolderFitUpdate::End));
    jobs.start(Work::new("ending the fit of the folder", end).in_turn(LANE));
}

const LANE: &str = "folder fit";

fn update(number: u64, update: FolderFitUpdate) -> Msg {
    Msg::Library(LibraryMsg::Fit { number, update })
}

fn fit_file(folder_fit: Arc<FolderFit>, path: PathBuf) -> Work {
    let name = files::folder::shown_name(&path);
    let number = folder_fit.number;
    let failed_path = path.clone();
    Work::new(format!("fitting {name}"), move |send| {
        folder_fit.hold.wait(&folder_fit.cancel);
        if folder_fit.cancel.is_set() {
            return;
        }
        send(update(number, FolderFitUpdate::File(name)));
        let result = folder_fit.fit(&path, send);
        if !folder_fit.cancel.is_set() {
            send(update(number, FolderFitUpdate::Done { path, result }));
        }
    })
    .in_turn(LANE)
    .or_tell(move |text| {
        let path = failed_path;
        let result = Err(FileError::new(&path, text).to_string());
        update(number, FolderFitUpdate::Done { path, result })
    })
}

impl FolderFit {
    fn go_on(&self) -> ControlFlow<()> {
        self.hold.wait(&self.cancel);
        if self.cancel.is_set() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn fit(&self, file: &Path, send: &SendMsg) -> Result<Vec<FitRecord>, String> {
        let read = files::open_measured(file, &mut |_| self.go_on());
        let (table, source) = read.map_err(|error| error.to_string())?;
        let Setup {
            weight,
            limit,
            options,
        } = &self.setup;
        let mut told = Instant::now();
        let mut watch = |position: usize, progress: &FitProgress| {
            if told.elapsed() >= BETWEEN_UPDATES {
                told = Instant::now();
                let share = (position as f32 + progress.share) / self.variants.len().max(1) as f32;
                send(update(self.number, FolderFitUpdate::Share(share)));
            }
            self.go_on()
        };
        let problem = Problem::new(&table, *weight, *limit)
            .map_err(|error| FileError::new(file, error.to_string()).to_string())?;
        // The problem is all that the fit needs.
        drop(table);
        let outcomes = fit::fit_all(&problem, &self.variants, options, &mut watch);
        let name = files::material_name(file);
        let record = |outcome| {
            let asked = (*weight, limit.to_degrees());
            FitRecord::new(name.clone(), Some(source.clone()), asked, options, outcome)
        };
        Ok(outcomes.iter().map(record).collect())
    }
}
