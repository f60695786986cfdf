//! Opening: a job that loads, and a place in the scene for what it brings.

use crate::app::msg::{Loaded, Task};
use crate::app::reduce::{edit, fit, fit_files};
use crate::app::state::job::{CancelFlag, Job, Purpose};
use crate::app::state::material::{Material, MaterialId, Opened, Origin, Presence};
use crate::app::state::{Scene, State};
use crate::files::fits::MaterialFits;
use crate::files::folder::shown_name;
use crate::measured::samples::SAMPLES;

/// Loads a material that a person opens.
pub(crate) fn load(state: &mut State, origin: Origin) -> Task {
    load_with(state, origin, None)
}

/// Loads a material that a fit file has models for.
pub(crate) fn load_with(
    state: &mut State,
    origin: Origin,
    fits: Option<Box<MaterialFits>>,
) -> Task {
    let label = match &origin {
        Origin::File(path) => shown_name(path),
        Origin::Sample(index) => SAMPLES[*index].name.to_string(),
    };
    start_load(state, label, origin, fits, Purpose::Open).1
}

/// Adds a job that loads; its number, and the task.
pub(crate) fn start_load(
    state: &mut State,
    label: String,
    origin: Origin,
    fits: Option<Box<MaterialFits>>,
    purpose: Purpose,
) -> (u64, Task) {
    let job = state.fresh_id();
    let cancel = CancelFlag::default();
    state.jobs.push(Job {
        id: job,
        label,
        progress: 0.0,
        cancel: cancel.clone(),
        purpose,
    });
    let task = Task::Load {
        job,
        origin,
        fits,
        cancel,
    };
    (job, task)
}

pub(crate) fn add_material(state: &mut State, origin: Origin, loaded: Loaded) {
    // What comes with a fit file is found again through that.
    if let (Origin::File(path), None) = (&origin, &loaded.fits) {
        state.prefs.remember(path.clone());
    }
    add_material_at(state, origin, loaded, None);
}

/// Opens a material, in the place of another one where `replaced` names it. Returns which it is.
pub(crate) fn add_material_at(
    state: &mut State,
    origin: Origin,
    loaded: Loaded,
    replaced: Option<MaterialId>,
) -> MaterialId {
    let opened = take_in(state, origin, loaded);
    put(state, |scene| {
        let place = |other: &Opened| Some(other.id) == replaced;
        scene.selected = match scene.opened.iter().position(place) {
            Some(index) => {
                scene.opened[index] = opened;
                index
            }
            None => {
                scene.opened.push(opened);
                scene.opened.len() - 1
            }
        };
    });
    opened.id
}

/// Adds all that a file has brought, in one step.
pub(crate) fn add_materials(state: &mut State, origin: &Origin, all: Vec<Loaded>) {
    if all.is_empty() {
        return;
    }
    let all: Vec<Opened> = all
        .into_iter()
        .map(|loaded| take_in(state, origin.clone(), loaded))
        .collect();
    put(state, |scene| {
        scene.opened.extend(all);
        scene.selected = scene.opened.len() - 1;
    });
}

/// Keeps what is loaded as a material; the place that it takes in a scene.
fn take_in(state: &mut State, origin: Origin, loaded: Loaded) -> Opened {
    let brdf = loaded.brdf();
    let measured = loaded.table.valid_count() > 0;
    let id = MaterialId(state.fresh_id());
    state.materials.insert(
        id,
        Material {
            name: loaded.name.clone(),
            own_name: loaded.name,
            origin,
            source: loaded.source,
            table: loaded.table,
            presence: Presence::Loaded,
            last_shown: 0,
            guess: loaded.guess,
            fit_due: loaded.fits.is_none() && measured,
            fits: Vec::new(),
        },
    );
    if let Some(fits) = &loaded.fits {
        fit_files::arrived(state, id, fits);
    }
    Opened {
        id,
        brdf,
        beside: false,
    }
}

/// Changes the scene by what was opened, as a step of its own.
fn put(state: &mut State, add: impl FnOnce(&mut Scene)) {
    if state.scene.opened.is_empty() && !state.history.can_undo() {
        // The first material is where the story begins, not a step of it.
        add(&mut state.scene);
        return;
    }
    // A drag may be under way.
    state.history.settle(&state.scene);
    edit(state, add);
    state.history.settle(&state.scene);
    forget_unreachable(state);
}

/// Closes an open material, by position; a fit of it is stopped and forgotten.
pub(crate) fn close(state: &mut State, index: usize) {
    if let Some(opened) = state.scene.opened.get(index) {
        fit::forget(state, opened.id);
    }
    edit(state, |scene| {
        if index < scene.opened.len() {
            scene.opened.remove(index);
            if scene.selected > index || scene.selected == scene.opened.len() {
                scene.selected = scene.selected.saturating_sub(1);
            }
        }
    });
    forget_unreachable(state);
}

/// Drops the data that neither the scene nor any step of its history shows.
pub(crate) fn forget_unreachable(state: &mut State) {
    let State {
        materials,
        history,
        scene,
        ..
    } = state;
    let reachable: std::collections::BTreeSet<MaterialId> = history
        .states()
        .chain([&*scene])
        .flat_map(|scene| scene.opened.iter().map(|opened| opened.id))
        .collect();
    materials.retain(|id, _| reachable.contains(id));
}
