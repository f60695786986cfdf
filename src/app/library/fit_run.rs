//! Fitting all files of the folder: what is asked for, how far it is, and what is kept of it.

use super::fit_work::FolderFit;
use super::{Hold, LibraryTask};
use crate::app::fitting::{KeptFit, Setup};
use crate::app::open_fits;
use crate::app::state::{CancelFlag, Level, State};
use crate::app::update::{Task, notify};
use crate::brdf::{Brdf, Fresnel, MODELS, Params};
use crate::files::fits::FitRecord;
use crate::fit::{Ended, Variant};
use std::path::{Path, PathBuf};

/// A fit of the folder that is under way. It ends with this.
#[derive(Debug)]
pub struct FolderRun {
    /// Tells it from older ones.
    pub number: u64,
    /// How many files it fits.
    pub total: usize,
    /// How many are done.
    pub done: usize,
    /// How far the present one is, in [0, 1].
    pub share: f32,
    /// Its name.
    pub name: String,
    /// Why files could not be fitted.
    pub failed: Vec<String>,
    /// Makes it wait.
    pub hold: Hold,
    cancel: CancelFlag,
}

impl Drop for FolderRun {
    fn drop(&mut self) {
        self.cancel.set();
    }
}

impl FolderRun {
    /// How far all of it is, in [0, 1].
    pub fn progress(&self) -> f32 {
        (self.done as f32 + self.share.clamp(0.0, 1.0)) / self.total.max(1) as f32
    }
}

/// What a fit of the folder says.
#[derive(Debug)]
pub enum Said {
    /// It begins with the next file.
    File(String),
    /// How far the present file is.
    Share(f32),
    /// A file is done.
    Done {
        path: PathBuf,
        result: Result<Vec<FitRecord>, String>,
    },
    /// All are done.
    End,
}

/// Fits the files of the folder as the panel says: the shown model, or all six. Files that have such a fit are left
/// out, unless all have one.
pub(in crate::app) fn start(state: &mut State, six: bool) -> Vec<Task> {
    if blocked(state).is_some() {
        return Vec::new();
    }
    let brdf = model(state);
    let variants = if six {
        Variant::all(match brdf.fresnel {
            Fresnel::None => Fresnel::Exact,
            fresnel => fresnel,
        })
    } else {
        vec![Variant::from(&brdf)]
    };
    let setup = state.fit.settings.setup(&brdf);
    let all = measured(state);
    let lacking = |path: &&PathBuf| !has_fits(state, path, &variants, &setup);
    let mut files: Vec<PathBuf> = all.iter().filter(lacking).cloned().collect();
    if files.is_empty() {
        files = all;
    }
    let run = FolderRun {
        number: state.fresh_id(),
        total: files.len(),
        done: 0,
        share: 0.0,
        name: String::new(),
        failed: Vec::new(),
        hold: Hold::default(),
        cancel: CancelFlag::default(),
    };
    let task = LibraryTask::Fit(Box::new(FolderFit {
        number: run.number,
        files,
        variants,
        setup,
        cancel: run.cancel.clone(),
        hold: run.hold.clone(),
    }));
    state.library.run = Some(run);
    vec![Task::Library(task)]
}

/// Why the folder cannot be fitted now, in words.
pub(in crate::app) fn blocked(state: &State) -> Option<&'static str> {
    if state.library.folder.is_none() {
        return Some("Open a folder first.");
    }
    if state.library.run.is_some() {
        return Some("The folder is being fitted.");
    }
    if measured(state).is_empty() {
        return Some("No file of the folder is a MERL file.");
    }
    state.fit.settings.blocked(&model(state))
}

/// The model that is fitted.
fn model(state: &State) -> Brdf {
    state.current().map_or(
        Brdf {
            model: MODELS[2],
            fresnel: Fresnel::Exact,
            params: Params::default(),
        },
        |(_, opened)| opened.brdf,
    )
}

fn measured(state: &State) -> Vec<PathBuf> {
    let files = state.library.folder.iter().flat_map(|folder| &folder.files);
    files
        .filter(|file| file.is_measured())
        .map(|file| file.path.clone())
        .collect()
}

fn has_fits(state: &State, path: &Path, variants: &[Variant], setup: &Setup) -> bool {
    let kept = state.library.fits.get(path).map_or(&[][..], Vec::as_slice);
    variants.iter().all(|variant| {
        kept.iter().any(|fit| {
            Variant::from(&fit.brdf) == *variant
                && fit.ended != Ended::Cancelled
                && KeptFit::from(fit).setup.asks_the_same(setup)
        })
    })
}

/// Takes in what the fit says.
pub(super) fn hear(state: &mut State, number: u64, said: Said) {
    let run = state.library.run.as_mut();
    let Some(run) = run.filter(|run| run.number == number) else {
        return;
    };
    match said {
        Said::File(name) => {
            run.name = name;
            run.share = 0.0;
        }
        Said::Share(share) => run.share = share,
        Said::Done { path, result } => {
            run.done += 1;
            run.share = 0.0;
            match result {
                Ok(fits) => fits.into_iter().for_each(|fit| keep(state, &path, fit)),
                Err(reason) => run.failed.push(reason),
            }
        }
        Said::End => {
            let (total, failed) = (run.total, std::mem::take(&mut run.failed));
            state.library.run = None;
            match failed.first() {
                None => notify(state, Level::Info, format!("Fitted {}.", materials(total))),
                Some(first) => {
                    let fitted = materials(total - failed.len());
                    let text = format!(
                        "Fitted {fitted}; {} could not be fitted, the first: {first}",
                        failed.len()
                    );
                    notify(state, Level::Error, text);
                }
            }
        }
    }
}

fn materials(count: usize) -> String {
    match count {
        1 => "1 material".into(),
        count => format!("{count} materials"),
    }
}

/// Keeps a fit with its path, and with its material where that is open.
fn keep(state: &mut State, path: &Path, fit: FitRecord) {
    let index = state.position_of_file(path);
    let opened = index.and_then(|index| state.scene.opened.get(index));
    if let Some(id) = opened.map(|opened| opened.id) {
        let source = state.materials.get(&id).and_then(|m| m.source.as_ref());
        if open_fits::same_data(source, fit.source.as_ref()) != Some(false) {
            state.keep_fit(id, KeptFit::from(&fit));
        }
    }
    state.library.keep_fit(path, fit);
}

#[cfg(test)]
pub(in crate::app) mod tests {
    use super::*;
    use crate::fit::{Errors, Options, Weight};

    /// A fit of the combined model with this s and this E.
    pub(in crate::app) fn record(s: f64, error: f64) -> FitRecord {
        FitRecord {
            material: "made up".into(),
            source: None,
            version: "0".into(),
            weight: Weight::Cosine,
            limit_deg: 90.0,
            options: Options::default(),
            brdf: Brdf {
                model: MODELS[2],
                fresnel: Fresnel::Exact,
                params: Params {
                    s,
                    ..Params::default()
                },
            },
            errors: Errors {
                total: error,
                grazing: None,
                channels: [error; 3],
            },
            stages: Vec::new(),
            albedo: [[0.5; 3]; 3],
            evaluations: 1,
            ended: Ended::Converged,
            concerns: Vec::new(),
        }
    }

    #[test]
    fn a_file_that_has_the_fit_is_left_out() {
        let mut state = State::default();
        let path = Path::new("/a/b.binary");
        let fit = record(3.0, 0.1);
        let variants = [Variant::from(&fit.brdf)];
        let setup = state.fit.settings.setup(&fit.brdf);
        assert!(!has_fits(&state, path, &variants, &setup));
        state.library.keep_fit(path, fit.clone());
        assert!(has_fits(&state, path, &variants, &setup));
        assert!(!has_fits(
            &state,
            path,
            &Variant::all(Fresnel::Exact),
            &setup
        ));
        state.fit.settings.weight = Weight::Cells;
        let other = state.fit.settings.setup(&fit.brdf);
        assert!(!has_fits(&state, path, &variants, &other));
        let cancelled = FitRecord {
            ended: Ended::Cancelled,
            ..fit
        };
        state.library.keep_fit(path, cancelled);
        assert!(!has_fits(&state, path, &variants, &setup));
    }
}
