//! Fits on opening: a material that has just been opened is fitted, so that what is seen first is the fit. The shown one
//! goes first; a fit that a person starts is waited for.

use crate::app::msg::Task;
use crate::app::reduce::fit;
use crate::app::state::State;
use crate::app::state::material::{Material, MaterialId};
use crate::brdf::Brdf;

/// Starts the next one. To be called after every change.
pub(crate) fn next(state: &mut State) -> Vec<Task> {
    let wanted = state.prefs.fit_on_opening.0 && state.lesson.is_none();
    if !wanted {
        // Neither a lesson that ends nor the setting changes a model that is open.
        for material in state.materials.values_mut() {
            material.fit_due = false;
        }
        return Vec::new();
    }
    let shown = state.scene.opened.get(state.scene.selected);
    let shown = shown.map(|opened| opened.id);
    let shown = shown.filter(|id| is_due(state, *id));
    if let Some(run) = &state.fit.run {
        let (under_way, on_opening) = (run.material, run.on_opening.is_some());
        if !on_opening || shown.is_none_or(|shown| shown == under_way) {
            return Vec::new();
        }
        // Another material is shown by now: this one waits.
        fit::forget(state, under_way);
        set_due(state, under_way, true);
    }
    let mut open = state.scene.opened.iter().map(|opened| opened.id);
    let Some(id) = shown.or_else(|| open.find(|id| is_due(state, *id))) else {
        return Vec::new();
    };
    set_due(state, id, false);
    fit::start_on_opening(state, id)
}

fn is_due(state: &State, id: MaterialId) -> bool {
    let due = |material: &Material| material.fit_due && !material.is_loading();
    state.materials.get(&id).is_some_and(due)
}

/// Lets a material wait for its fit, or no longer.
pub(crate) fn set_due(state: &mut State, id: MaterialId, due: bool) {
    if let Some(material) = state.materials.get_mut(&id) {
        material.fit_due = due;
    }
}

/// Gives an opened material the model that its fit has come to: part of the opening, and no step of its own.
pub(crate) fn put(state: &mut State, id: MaterialId, guess: Brdf, best: Brdf) {
    let scenes = state.history.states_mut().chain([&mut state.scene]);
    let opened = scenes.flat_map(|scene| &mut scene.opened);
    for opened in opened.filter(|opened| opened.id == id && opened.brdf == guess) {
        opened.brdf = best;
    }
    if let Some(preview) = &mut state.library.preview
        && (preview.id, preview.brdf) == (id, guess)
    {
        preview.brdf = best;
    }
}
