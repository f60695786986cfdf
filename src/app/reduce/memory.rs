//! Reducer of memory: the tables least recently shown go where all take more than the limit.

use crate::app::msg::Task;
use crate::app::reduce::opening::start_load;
use crate::app::state::State;
use crate::app::state::job::Purpose;
use crate::app::state::library::Pending;
use crate::app::state::material::{MaterialId, Presence};
use crate::app::state::memory::{Held, bytes, cell_bytes, texture_bytes, to_evict};
use crate::measured::{Grid, Table};

/// The materials whose tables must stay: the shown one, those beside it, and the one that is fitted.
fn shown(state: &State) -> Vec<MaterialId> {
    let scene = &state.scene;
    let in_plots = scene
        .opened
        .iter()
        .enumerate()
        .filter(|(index, opened)| *index == scene.selected || opened.beside)
        .map(|(_, opened)| opened.id);
    in_plots
        .chain(state.fit.run.as_ref().map(|run| run.material))
        .collect()
}

/// Lets tables go that are over the limit, and asks for those that are shown and are not there.
pub(crate) fn keep(state: &mut State) -> Vec<Task> {
    state.library.clock += 1;
    let (clock, shown) = (state.library.clock, shown(state));
    let mut missing = Vec::new();
    for id in &shown {
        if let Some(material) = state.materials.get_mut(id) {
            material.last_shown = clock;
            if material.presence == Presence::Evicted {
                missing.push(*id);
            }
        }
    }
    let mut tasks = Vec::new();
    for id in missing {
        tasks.extend(reload(state, id).map(|(_, task)| task));
    }
    // Every load under way brings a table, and the sphere has its own on the GPU.
    let on_gpu = state
        .current()
        .map(|(material, _)| texture_bytes(&material.table));
    let coming = state.jobs.len() as u64 * cell_bytes(Grid::FOLDED) + on_gpu.unwrap_or(0);
    let held: Vec<Held> = state
        .materials
        .iter()
        .filter(|(_, material)| material.presence == Presence::Loaded)
        .map(|(id, material)| Held {
            id: *id,
            bytes: bytes(&material.table),
            shown: shown.contains(id),
            last_shown: material.last_shown,
        })
        .filter(|held| held.bytes > 0)
        .collect();
    for id in to_evict(&held, coming, state.prefs.memory.bytes()) {
        if let Some(material) = state.materials.get_mut(&id) {
            material.table = Table::unmeasured();
            material.presence = Presence::Evicted;
        }
    }
    state.library.hold.set(!state.jobs.is_empty());
    if let Some(run) = &state.library.run {
        run.hold
            .set(!state.jobs.is_empty() || state.fit.run.is_some());
    }
    tasks
}

/// Reads the table of a material again; the number of the job, and the task.
pub(crate) fn reload(state: &mut State, id: MaterialId) -> Option<(u64, Task)> {
    let material = state.materials.get(&id)?;
    let (label, origin) = (material.name.clone(), material.origin.clone());
    let (job, task) = start_load(state, label, origin, None, Purpose::Reload(id));
    state.materials.get_mut(&id)?.presence = Presence::Loading(job);
    Some((job, task))
}

/// Cancels the load of what is no longer asked for.
pub(crate) fn cancel_pending(state: &mut State) {
    let Some(Pending { job, .. }) = state.library.pending.take() else {
        return;
    };
    // A material that is in a plot is loaded all the same.
    let shown = shown(state);
    let needed = state
        .materials
        .iter()
        .any(|(id, material)| material.presence == Presence::Loading(job) && shown.contains(id));
    if let Some(job) = state.jobs.iter().find(|other| other.id == job)
        && !needed
    {
        job.cancel.set();
        if let Purpose::Reload(id) = job.purpose
            && let Some(material) = state.materials.get_mut(&id)
        {
            material.presence = Presence::Evicted;
        }
    }
}
