//! Fitting all files of the folder: what is asked for, how far it is, and what is kept of it.

use crate::app::msg::Task;
use crate::app::msg::library::{FolderFit, FolderFitUpdate, LibraryTask};
use crate::app::reduce::fit::keep_fit;
use crate::app::reduce::{fit_files, notify};
use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::settings::Setup;
use crate::app::state::folder_fit::{blocked, measured, model};
use crate::app::state::job::{CancelFlag, Hold};
use crate::app::state::library::folder_run::FolderRun;
use crate::app::state::notice::Severity;
use crate::app::state::views::ViewId;
use crate::files::fits::FitRecord;
use crate::fit::{EndReason, Variant};
use std::path::{Path, PathBuf};

/// Fits the files of the folder as the panel says: the shown model, or the models to compare. Files that have such
/// fits are left out, unless all have them.
pub(crate) fn start(state: &mut State, compare: bool) -> Vec<Task> {
    if blocked(state).is_some() || compare && state.prefs.comparison.blocked().is_some() {
        return Vec::new();
    }
    let brdf = model(state);
    let variants = if compare {
        state.prefs.comparison.variants()
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
    if compare {
        state.tiles.show(ViewId::Ranking);
    }
    vec![Task::Library(task)]
}

fn has_fits(state: &State, path: &Path, variants: &[Variant], setup: &Setup) -> bool {
    let kept = state.library.fits.get(path).map_or(&[][..], Vec::as_slice);
    variants.iter().all(|variant| {
        kept.iter().any(|fit| {
            Variant::from(&fit.brdf) == *variant
                && fit.ended != EndReason::Cancelled
                && KeptFit::from(fit).setup.asks_the_same(setup)
        })
    })
}

/// Takes in a report of the fit.
pub(crate) fn update(state: &mut State, number: u64, update: FolderFitUpdate) {
    let run = state.library.run.as_mut();
    let Some(run) = run.filter(|run| run.number == number) else {
        return;
    };
    match update {
        FolderFitUpdate::File(name) => {
            run.name = name;
            run.share = 0.0;
        }
        FolderFitUpdate::Share(share) => run.share = share,
        FolderFitUpdate::Done { path, result } => {
            run.done += 1;
            run.share = 0.0;
            match result {
                Ok(fits) => fits.into_iter().for_each(|fit| keep(state, &path, fit)),
                Err(reason) => run.failed.push(reason),
            }
        }
        FolderFitUpdate::End => {
            let (total, failed) = (run.total, std::mem::take(&mut run.failed));
            state.library.run = None;
            match failed.first() {
                None => notify(
                    state,
                    Severity::Info,
                    format!("Fitted {}.", materials(total)),
                ),
                Some(first) => {
                    let fitted = materials(total - failed.len());
                    let text = format!(
                        "Fitted {fitted}; {} could not be fitted, the first: {first}",
                        failed.len()
                    );
                    notify(state, Severity::Error, text);
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
        if fit_files::data_agree(source, fit.source.as_ref()) != Some(false) {
            keep_fit(state, id, KeptFit::from(&fit));
        }
    }
    state.library.keep_fit(path, fit);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::library::fixtures::record;
    use crate::brdf::{Fresnel, PHONG_FAMILY};
    use crate::fit::Weight;

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
            &Variant::of(PHONG_FAMILY, Fresnel::Exact),
            &setup
        ));
        state.fit.settings.weight = Weight::Cells;
        let other = state.fit.settings.setup(&fit.brdf);
        assert!(!has_fits(&state, path, &variants, &other));
        let cancelled = FitRecord {
            ended: EndReason::Cancelled,
            ..fit
        };
        state.library.keep_fit(path, cancelled);
        assert!(!has_fits(&state, path, &variants, &setup));
    }
}
