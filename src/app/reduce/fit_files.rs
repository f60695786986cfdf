//! Opening of a fit file: its models are laid over the materials that were fitted.

use crate::app::msg::{Loaded, Task};
use crate::app::reduce::opening::{add_materials, load_with};
use crate::app::reduce::{edit, fit, notify};
use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::material::{Material, MaterialId, Origin};
use crate::app::state::notice::Severity;
use crate::files::fits::MaterialFits;
use crate::files::{FileError, SourceFile};
use crate::quote::shown;
use std::collections::BTreeSet;
use std::path::Path;

/// Takes the models of the file `path`: over the material where that is open; else over its measured file, which is
/// then loaded; else alone, with a word about it.
pub(crate) fn open(state: &mut State, path: &Path, all: Vec<MaterialFits>) -> Vec<Task> {
    state.prefs.remember(path.to_owned());
    let (mut tasks, mut over, mut without) = (Vec::new(), Vec::new(), Vec::new());
    for (fits, open) in with_open(state, all) {
        match (open, fits.found.clone()) {
            (Some(index), _) => over.push((index, fits)),
            (None, Some(file)) => {
                let fits = Some(Box::new(fits));
                tasks.push(load_with(state, Origin::File(file), fits));
            }
            (None, None) => without.push(fits),
        }
    }
    lay_over(state, &over);
    if let Some(text) = what_is_missing(path, &without) {
        notify(state, Severity::Info, text);
    }
    let without = without.into_iter().map(Box::new).map(Loaded::alone);
    add_materials(state, &Origin::File(path.to_owned()), without.collect());
    tasks
}

/// Keeps the fits of a file with a material, new or open before, and says what there is to say: fits of other data
/// are not kept.
pub(crate) fn arrived(state: &mut State, id: MaterialId, fits: &MaterialFits) {
    let Some(Material { name, source, .. }) = state.materials.get(&id) else {
        return;
    };
    let (name, source) = (shown(name), source.clone());
    for record in fits.entries.iter().filter_map(|entry| entry.fit.as_deref()) {
        if data_agree(source.as_ref(), record.source.as_ref()) != Some(false) {
            fit::keep_fit(state, id, KeptFit::from(record));
        }
    }
    let best = fits.entries.first().and_then(|best| best.source.as_ref());
    let (Some(now), Some(then)) = (&source, best) else {
        return;
    };
    if then.same_data(now) == Some(false) {
        let what = format!("the data of {name} have changed since the fit");
        let text = FileError::new(&now.path, what).to_string();
        notify(state, Severity::Info, text);
    }
}

/// Whether both are the same bytes; `None` where that is not known.
pub(crate) fn data_agree(a: Option<&SourceFile>, b: Option<&SourceFile>) -> Option<bool> {
    a?.same_data(b?)
}

/// Whether models belong to an open material.
type Belongs = fn(&MaterialFits, &Material) -> bool;

/// Models with the position of the open material that they belong to: of the one from the same path; else of one with the
/// same bytes, or of the same name, where the measured file is not to be found. Each open material takes the models of one,
/// as two materials may have the same bytes or the same name.
fn with_open(state: &State, all: Vec<MaterialFits>) -> Vec<(MaterialFits, Option<usize>)> {
    let mut all: Vec<(MaterialFits, Option<usize>)> =
        all.into_iter().map(|fits| (fits, None)).collect();
    let mut taken = BTreeSet::new();
    // By every path first, so that none is taken by a material that only looks like it.
    for belongs in [same_path as Belongs, same_data, same_name] {
        for (fits, place) in all.iter_mut().filter(|(_, place)| place.is_none()) {
            let mut open = state.scene.opened.iter().enumerate();
            let found = open.find(|(index, opened)| {
                let material = state.materials.get(&opened.id);
                !taken.contains(index) && material.is_some_and(|material| belongs(fits, material))
            });
            *place = found.map(|(index, _)| index);
            taken.extend(*place);
        }
    }
    all
}

fn same_path(fits: &MaterialFits, material: &Material) -> bool {
    let source = material.source.as_ref();
    source.is_some_and(|source| fits.places.contains(&source.path))
}

fn same_data(fits: &MaterialFits, material: &Material) -> bool {
    let copy = fits.found.is_none() || material.own_name == fits.name;
    copy && data_agree(material.source.as_ref(), fits.source.as_ref()) == Some(true)
}

fn same_name(fits: &MaterialFits, material: &Material) -> bool {
    fits.found.is_none() && material.own_name == fits.name
}

/// Gives open materials, by position, the best of their models: one step for the whole file.
fn lay_over(state: &mut State, over: &[(usize, MaterialFits)]) {
    let Some((first, _)) = over.first() else {
        return;
    };
    // What is opened last is what stays. The best so far of a fit that moves one of these models is one step back, and
    // the end of that fit changes nothing any more.
    for (index, _) in over {
        fit::release_model_of(state, state.scene.opened[*index].id);
    }
    // A drag may be under way.
    state.history.settle(&state.scene);
    edit(state, |scene| {
        for (index, fits) in over {
            scene.opened[*index].brdf = fits.best;
        }
        scene.selected = *first;
    });
    state.history.settle(&state.scene);
    for (index, fits) in over {
        arrived(state, state.scene.opened[*index].id, fits);
    }
}

/// One line on the materials that are shown without data.
fn what_is_missing(path: &Path, without: &[MaterialFits]) -> Option<String> {
    let missing: Vec<&MaterialFits> = without.iter().filter(|f| f.source.is_some()).collect();
    let say = |path: &Path, what: String| Some(FileError::new(path, what).to_string());
    match (&missing[..], without) {
        ([], []) => None,
        ([], [one]) => say(
            path,
            format!(
                "{} has no measured file; the model is shown alone",
                shown(&one.name)
            ),
        ),
        ([], many) => say(
            path,
            format!(
                "{} models have no measured file and are shown alone",
                many.len()
            ),
        ),
        ([one], _) => say(
            one.places.first().map_or(path, |at| at.as_path()),
            format!(
                "the measured file of {} is missing; its model is shown alone",
                shown(&one.name)
            ),
        ),
        ([first, ..], _) => say(
            first.places.first().map_or(path, |at| at.as_path()),
            format!(
                "{} measured files are missing; their models are shown alone; the first",
                missing.len()
            ),
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::Command;
    use crate::app::msg::Msg;
    use crate::app::msg::fit::FitMsg;
    use crate::app::msg::fit::Timed;
    use crate::app::reduce::apply;
    use crate::app::state::fitting::run::FitUpdates;
    use crate::brdf::Brdf;
    use crate::files::fits::{FitEntry, FitRecord};
    use crate::fit::{EndReason, Errors, FitOptions, FitProgress, Outcome, Stage, Weight};
    use crate::measured::Grid;
    use crate::measured::Table;

    /// Two grey materials, the second of them shown.
    fn two() -> State {
        let mut state = State::default();
        for k in 0..2 {
            let table = Table::new(Grid::FOLDED, vec![[0.1; 3]; Grid::FOLDED.len()]);
            let msg = Msg::Loaded {
                job: 0,
                origin: Origin::Sample(k),
                result: Ok(Loaded::new(format!("grey {k}"), None, table)),
            };
            apply(&mut state, msg);
        }
        state
    }

    fn with_s(mut brdf: Brdf, s: f64) -> Brdf {
        brdf.params.lobe[0] = s;
        brdf
    }

    fn outcome(brdf: Brdf, ended: EndReason) -> Outcome {
        let error = 0.1;
        Outcome {
            brdf,
            errors: Errors {
                total: error,
                grazing: None,
                channels: [error; 3],
            },
            stages: Vec::new(),
            evaluations: 10,
            ended,
            albedo: [[0.5; 3]; 3],
            concerns: Vec::new(),
        }
    }

    /// A fit file with one fit of a material of this name.
    fn file(name: &str, brdf: Brdf) -> Msg {
        let asked = (Weight::default(), 90.0);
        let outcome = outcome(brdf, EndReason::Converged);
        let fit = FitRecord::new(name.into(), None, asked, &FitOptions::default(), &outcome);
        let entry = FitEntry {
            brdf,
            material: Some(name.into()),
            source: None,
            error: Some(outcome.errors.total),
            fit: Some(Box::new(fit)),
        };
        Msg::FitsRead {
            job: 0,
            path: "fits.json".into(),
            fits: vec![MaterialFits {
                name: name.into(),
                source: None,
                places: Vec::new(),
                found: None,
                best: brdf,
                entries: vec![entry],
            }],
        }
    }

    /// Fits the shown material and lets the fit say this; its number.
    fn fit(state: &mut State, best: Brdf) -> u64 {
        apply(state, Msg::Run(Command::Fit));
        let job = state.fit.run.as_ref().expect("a fit").job;
        let progress = FitProgress {
            stage: Stage::Joint,
            brdf: best,
            error: 0.2,
            all_cells: true,
            evaluations: 10,
            share: 0.5,
        };
        let updates = vec![(0, progress)];
        apply(
            state,
            Msg::Fit(FitMsg::Updates(FitUpdates { job, updates })),
        );
        job
    }

    fn done(state: &mut State, job: u64, brdf: Brdf, ended: EndReason) {
        let timed = Timed {
            outcome: outcome(brdf, ended),
            seconds: 1.0,
        };
        let result = Ok(vec![timed]);
        let msg = FitMsg::Done { job, result };
        apply(state, Msg::Fit(msg));
    }

    #[test]
    fn a_file_opened_last_stays_though_its_material_is_fitted_unseen() {
        let mut state = two();
        let first = state.scene.opened[1].brdf;
        let (so_far, of_file, at_end) =
            (with_s(first, 7.0), with_s(first, 8.0), with_s(first, 9.0));
        let job = fit(&mut state, so_far);
        apply(&mut state, Msg::Select(0));
        apply(&mut state, file("grey 1", of_file));
        assert!(state.fit.run.as_ref().is_some_and(|run| run.stopping));
        done(&mut state, job, at_end, EndReason::Cancelled);
        let shown = |state: &State| state.scene.opened[1].brdf;
        assert_eq!((shown(&state), state.scene.selected), (of_file, 1));
        // The file's fit was not overwritten by one that was stopped.
        let id = state.scene.opened[1].id;
        assert_eq!(state.materials[&id].fits.len(), 1);
        assert_eq!(state.materials[&id].fits[0].outcome.brdf, of_file);
        // One step back is what the fit had come to, two what was there before it.
        apply(&mut state, Msg::Run(Command::Undo));
        assert_eq!(shown(&state), so_far);
        apply(&mut state, Msg::Run(Command::Undo));
        assert_eq!(shown(&state), first);
    }

    #[test]
    fn a_file_of_another_material_lets_the_fit_go_on() {
        let mut state = two();
        let first = state.scene.opened[1].brdf;
        let (so_far, at_end) = (with_s(first, 7.0), with_s(first, 9.0));
        let job = fit(&mut state, so_far);
        apply(&mut state, file("grey 0", with_s(first, 8.0)));
        assert!(state.fit.run.as_ref().is_some_and(|run| !run.stopping));
        done(&mut state, job, at_end, EndReason::Converged);
        assert_eq!(state.scene.opened[1].brdf, at_end);
        assert_eq!(state.scene.opened[0].brdf.params.lobe[0], 8.0);
    }

    #[test]
    fn all_models_of_a_file_are_opened_in_one_step() {
        let mut state = two();
        let brdf = state.scene.opened[0].brdf;
        let Msg::FitsRead { job, path, fits } = file("alone 0", brdf) else {
            panic!("a file")
        };
        let others = (1..4).map(|k| MaterialFits {
            name: format!("alone {k}"),
            ..fits[0].clone()
        });
        let fits = fits.iter().cloned().chain(others).collect();
        apply(&mut state, Msg::FitsRead { job, path, fits });
        assert_eq!(state.scene.opened.len(), 2 + 4);
        assert_eq!(state.scene.selected, 5);
        apply(&mut state, Msg::Run(Command::Undo));
        assert_eq!(state.scene.opened.len(), 2);
    }
}
