//! Showing files and materials: what is asked for is loaded first, and the newest pending wins.

use crate::app::msg::{Loaded, Task};
use crate::app::reduce::opening::{add_material, add_material_at, load, load_with};
use crate::app::reduce::{edit, fit_files, memory, notify, open_session};
use crate::app::state::State;
use crate::app::state::fitting::run::FitRun;
use crate::app::state::job::Purpose;
use crate::app::state::library::{FileKind, Pending, PendingTarget, Preview};
use crate::app::state::material::{MaterialId, Origin, Presence};
use crate::app::state::notice::Severity;
use crate::files::FileError;
use crate::quote::shown;
use std::path::PathBuf;

/// Shows an open material; from now on, arrows step through the open ones.
pub(crate) fn select(state: &mut State, index: usize) -> Vec<Task> {
    state.library.cursor = None;
    show_material(state, index)
}

fn show_material(state: &mut State, index: usize) -> Vec<Task> {
    let opened = state.scene.opened.get(index);
    let Some((id, material)) =
        opened.and_then(|opened| Some((opened.id, state.materials.get(&opened.id)?)))
    else {
        return Vec::new();
    };
    let (presence, name) = (material.presence, material.name.clone());
    let target = PendingTarget::Material(id);
    if state
        .library
        .pending
        .as_ref()
        .is_some_and(|pending| pending.target == target)
    {
        return Vec::new();
    }
    memory::cancel_pending(state);
    let (job, task) = match presence {
        Presence::Loaded | Presence::Missing => {
            edit(state, |scene| scene.selected = index);
            return Vec::new();
        }
        Presence::Loading(job) => (job, None),
        Presence::Evicted => match memory::reload(state, id) {
            Some((job, task)) => (job, Some(task)),
            None => return Vec::new(),
        },
    };
    state.library.pending = Some(Pending { job, name, target });
    task.into_iter().collect()
}

/// Shows a file of the folder: the material where it is open, else as a preview; left open where `keep` says so.
pub(crate) fn show_file(state: &mut State, path: PathBuf, keep: bool) -> Vec<Task> {
    match state.library.kind_of(&path) {
        Some(FileKind::Other(_)) => return Vec::new(),
        Some(FileKind::Models(_)) => {
            state.library.cursor = Some(path.clone());
            return vec![load(state, Origin::File(path))];
        }
        _ => {}
    }
    state.library.cursor = Some(path.clone());
    if let Some(index) = state.position_of_file(&path) {
        if keep {
            leave_open(state, state.scene.opened[index].id);
        }
        return show_material(state, index);
    }
    if let Some(Pending { target, .. }) = &mut state.library.pending
        && let PendingTarget::File {
            path: asked_for,
            keep: kept,
        } = target
        && *asked_for == path
    {
        *kept |= keep;
        return Vec::new();
    }
    memory::cancel_pending(state);
    let fits = state.library.fits_for(&path);
    let task = load_with(state, Origin::File(path.clone()), fits);
    if let Some(job) = state.jobs.last_mut() {
        job.purpose = Purpose::Preview;
        state.library.pending = Some(Pending {
            job: job.id,
            name: job.label.clone(),
            target: PendingTarget::File { path, keep },
        });
    }
    vec![task]
}

/// The next material does not take the place of this one.
fn leave_open(state: &mut State, id: MaterialId) {
    state.library.preview.take_if(|preview| preview.id == id);
}

/// Leaves what is shown, or about to be, open.
pub(crate) fn keep_open(state: &mut State) {
    if let Some(Pending {
        target: PendingTarget::File { keep, .. },
        ..
    }) = &mut state.library.pending
    {
        *keep = true;
    } else {
        state.library.preview = None;
    }
}

/// Goes on by so many files of the folder as they are listed, or through the open materials.
pub(crate) fn step(state: &mut State, by: isize) -> Vec<Task> {
    let files = state.library.steps();
    let count = state.scene.opened.len();
    let Some(cursor) = &state.library.cursor else {
        return match (count, files.first()) {
            (0 | 1, Some(first)) => step_to(state, first.clone()),
            (0, None) => Vec::new(),
            _ => {
                let by = by.rem_euclid(count as isize) as usize;
                select(state, (state.scene.selected + by) % count)
            }
        };
    };
    let at = files.iter().position(|file| file == cursor);
    let last = files.len().saturating_sub(1);
    let next = at.map_or(0, |at| at.saturating_add_signed(by).min(last));
    match files.get(next) {
        Some(file) if Some(next) != at => step_to(state, file.clone()),
        _ => Vec::new(),
    }
}

fn step_to(state: &mut State, file: PathBuf) -> Vec<Task> {
    state.library.reveal += 1;
    show_file(state, file, false)
}

/// A job has brought a material, or says why not.
pub(crate) fn loaded(
    state: &mut State,
    job: u64,
    origin: Origin,
    result: Result<Loaded, Option<String>>,
) -> Vec<Task> {
    let at = state.jobs.iter().position(|other| other.id == job);
    let purpose = at.map_or(Purpose::Open, |at| state.jobs.remove(at).purpose);
    let pending = state.library.pending.take_if(|pending| pending.job == job);
    match (purpose, result, pending) {
        (Purpose::Reload(id), result, pending) => {
            take_back(state, id, job, result);
            let index = state.scene.opened.iter().position(|opened| opened.id == id);
            if let (Some(index), Some(_)) = (index, pending) {
                edit(state, |scene| scene.selected = index);
            }
        }
        (Purpose::Preview, Ok(loaded), Some(pending)) => preview(state, origin, loaded, &pending),
        (Purpose::Preview, Err(Some(reason)), Some(_)) => notify(state, Severity::Error, reason),
        // Something else is asked_for by now.
        (Purpose::Preview, ..) => {}
        (Purpose::Open, Ok(loaded), _) => {
            memory::cancel_pending(state);
            add_material(state, origin, loaded);
        }
        (Purpose::Open, Err(Some(reason)), _) => {
            return open_session::not_read(state, &origin, reason);
        }
        (Purpose::Open, Err(None), _) => {}
    }
    Vec::new()
}

/// Opens a file in the place of the preview before it, if that is as it was.
fn preview(state: &mut State, origin: Origin, loaded: Loaded, pending: &Pending) {
    let PendingTarget::File { path, keep } = &pending.target else {
        return;
    };
    if let (Some(now), Some(fits)) = (&loaded.source, state.library.fits.get_mut(path)) {
        let same = |then: &crate::files::SourceFile| now.same_data(then) != Some(false);
        fits.retain(|fit| fit.source.as_ref().is_none_or(same));
    }
    let replaced = replaceable(state);
    let id = add_material_at(state, origin, loaded, replaced);
    let opened = state.scene.opened.get(state.scene.selected);
    state.library.preview = opened
        .filter(|opened| opened.id == id && !keep)
        .map(|opened| Preview {
            id,
            brdf: opened.brdf,
        });
}

/// The preview, unless a person has done something with it.
fn replaceable(state: &State) -> Option<MaterialId> {
    let preview = state.library.preview?;
    let by_a_person = |run: &&FitRun| run.material == preview.id && run.on_opening.is_none();
    let fitted = state.fit.run.as_ref().filter(by_a_person).is_some();
    let untouched = state
        .scene
        .opened
        .iter()
        .any(|opened| opened.id == preview.id && opened.brdf == preview.brdf && !opened.beside);
    (untouched && !fitted).then_some(preview.id)
}

/// Puts a table that was let go back in its place.
fn take_back(state: &mut State, id: MaterialId, job: u64, result: Result<Loaded, Option<String>>) {
    let Some(material) = state.materials.get_mut(&id) else {
        return;
    };
    if material.presence != Presence::Loading(job) {
        return;
    }
    match result {
        Ok(loaded) => {
            let since = if state.session.unread.remove(&id) {
                "the session was saved"
            } else {
                "it was opened"
            };
            let same = fit_files::data_agree(loaded.source.as_ref(), material.source.as_ref());
            material.table = loaded.table;
            material.presence = Presence::Loaded;
            if same == Some(false) {
                material.source = loaded.source;
                material.guess = loaded.guess;
                material.fits.clear();
                let path = material.file().unwrap_or_default();
                let what = format!(
                    "the data of {} have changed since {since}; its fits are gone",
                    shown(&material.name)
                );
                state.library.fits.remove(&path);
                notify(
                    state,
                    Severity::Info,
                    FileError::new(&path, what).to_string(),
                );
            }
        }
        Err(Some(reason)) => {
            material.presence = Presence::Missing;
            let name = shown(&material.name);
            let text = format!("{name} is shown without its data: {reason}");
            notify(state, Severity::Error, text);
        }
        Err(None) => material.presence = Presence::Evicted,
    }
}
