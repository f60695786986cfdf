//! What a fit file does to the state: its models are laid over the materials that were fitted.

use super::fitting::{KeptFit, steps};
use super::state::{Level, Material, MaterialId, Origin, State};
use super::update::{Loaded, Task, add_material, edit, load_with, notify};
use crate::files::fits::MaterialFits;
use crate::files::{FileError, SourceFile};
use crate::measured::Table;
use std::path::Path;

/// Takes the models of the file `path`: over the material where that is open; else over its measured file, which is
/// then loaded; else alone, with a word about it.
pub(super) fn open(state: &mut State, path: &Path, all: Vec<MaterialFits>) -> Vec<Task> {
    state.prefs.remember(path.to_owned());
    let (mut tasks, mut over, mut without) = (Vec::new(), Vec::new(), Vec::new());
    for fits in all {
        match (find_open(state, &fits), fits.found.clone()) {
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
        notify(state, Level::Info, text);
    }
    for fits in without {
        add_material(state, Origin::File(path.to_owned()), alone(Box::new(fits)));
    }
    tasks
}

/// A material that is a model and nothing else.
pub(super) fn alone(fits: Box<MaterialFits>) -> Loaded {
    Loaded {
        name: fits.name.clone(),
        source: None,
        table: Table::unmeasured(),
        guess: fits.best,
        fits: Some(fits),
    }
}

/// Keeps the fits of a file with a material, new or open before, and says what there is to say: fits of other data
/// are not kept.
pub(super) fn arrived(state: &mut State, id: MaterialId, fits: &MaterialFits) {
    let Some(Material { name, source, .. }) = state.materials.get(&id) else {
        return;
    };
    let (name, source) = (name.clone(), source.clone());
    for record in fits.entries.iter().filter_map(|entry| entry.fit.as_ref()) {
        if same_data(source.as_ref(), record.source.as_ref()) != Some(false) {
            state.keep_fit(id, KeptFit::from(record));
        }
    }
    let best = fits.entries.first().and_then(|best| best.source.as_ref());
    let (Some(now), Some(then)) = (&source, best) else {
        return;
    };
    if then.same_data(now) == Some(false) {
        let what = format!("the data of {name} have changed since the fit");
        let text = FileError::new(Path::new(&now.path), what).to_string();
        notify(state, Level::Info, text);
    }
}

/// Whether both are the same bytes; `None` where that is not known.
pub(super) fn same_data(a: Option<&SourceFile>, b: Option<&SourceFile>) -> Option<bool> {
    a?.same_data(b?)
}

/// The open material that the models belong to: the one from the same path, or with the same bytes, or, where the
/// measured file is not to be found, of the same name.
fn find_open(state: &State, fits: &MaterialFits) -> Option<usize> {
    let find = |belongs: &dyn Fn(&Material) -> bool| {
        state
            .scene
            .opened
            .iter()
            .position(|opened| state.materials.get(&opened.id).is_some_and(belongs))
    };
    let same_path = |material: &Material| {
        let source = material.source.as_ref();
        source.is_some_and(|source| fits.places.iter().any(|at| at == Path::new(&source.path)))
    };
    let same_data = |material: &Material| {
        let (Some(a), Some(b)) = (&material.source, &fits.source) else {
            return false;
        };
        a.same_data(b) == Some(true)
    };
    let same_name = |material: &Material| fits.found.is_none() && material.name == fits.name;
    find(&same_path)
        .or_else(|| find(&same_data))
        .or_else(|| find(&same_name))
}

/// Gives open materials, by position, the best of their models: one step for the whole file.
fn lay_over(state: &mut State, over: &[(usize, MaterialFits)]) {
    let Some((first, _)) = over.first() else {
        return;
    };
    steps::release_model(state);
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
                one.name
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
                one.name
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
