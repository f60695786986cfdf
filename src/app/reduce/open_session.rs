//! Opening of a session: its scene in place of the present one, as one step.

use crate::app::msg::Task;
use crate::app::msg::session::SessionTask;
use crate::app::reduce::opening::{forget_unreachable, load};
use crate::app::reduce::{edit, fit, memory, notify};
use crate::app::session::file::{SavedFitting, SavedKey, SavedMaterial, SavedWhat, SessionFile};
use crate::app::session::places::{FilePlace, FoundSession};
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::state::fitting::table::{Column, FitTable};
use crate::app::state::material::{Material, MaterialId, Opened, Origin, Presence};
use crate::app::state::notice::Severity;
use crate::app::state::probe::Probe;
use crate::app::state::session::{Crashed, DAMAGED, Missing};
use crate::app::state::session_mark::SessionMark;
use crate::app::state::subject_key::{SubjectKey, What};
use crate::app::state::{Scene, State};
use crate::brdf::{Fresnel, Model, param_by_key};
use crate::files;
use crate::fit::{STAGES, Variant};
use crate::measured::Table;
use crate::measured::samples::SAMPLES;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Number of remarks on a file that are shown one by one.
const REMARKS: usize = 3;

/// Puts a session in place of what is open, as one step. Tiles, settings of the fit and the pinned probe are no part of
/// the history, here as elsewhere.
pub(crate) fn open(state: &mut State, job: u64, path: &Path, found: FoundSession) -> Vec<Task> {
    state.jobs.retain(|other| other.id != job);
    // What a fit has found so far belongs to what is left, and comes back with it.
    fit::stop(state);
    fit::forget_refits(state);
    memory::cancel_pending(state);
    state.library.preview = None;
    state.library.cursor = None;
    state.lesson = None;

    let FoundSession {
        session,
        remarks,
        places,
    } = found;
    let number = state.fresh_id();
    let mut ids = Vec::new();
    for (saved, place) in session.materials.iter().zip(places) {
        ids.push(add(state, path, saved, place));
    }
    let scene = scene_of(&session, &ids, number);
    put(state, scene);
    take_the_rest(state, &session);
    name(state, number, path, session.saved_as);
    remark(state, path, remarks);
    forget_unreachable(state);
    let tasks = load_all(state, &ids);
    if state
        .session
        .files
        .get(&number)
        .is_some_and(|file| *file == files::absolute(path))
    {
        let mark = SessionMark::of(state);
        state.session.saved.insert(number, mark);
    }
    tasks
}

/// The scene of a session, and nothing where there was one before.
fn scene_of(session: &SessionFile, ids: &[MaterialId], number: u64) -> Scene {
    let opened = session.materials.iter().zip(ids);
    Scene {
        session: number,
        opened: opened
            .map(|(saved, id)| Opened {
                id: *id,
                brdf: saved.model.0,
                beside: saved.beside,
            })
            .collect(),
        selected: session.shown,
        hidden: session
            .hidden
            .iter()
            .filter_map(|key| subject_key(key, ids))
            .collect(),
        lookup: session.lookup,
        views: session.views.clone(),
    }
}

fn put(state: &mut State, scene: Scene) {
    if state.scene.opened.is_empty() && !state.history.can_undo() {
        // Where the story begins, not a step of it.
        state.scene = scene;
        return;
    }
    // A drag may be under way.
    state.history.settle(&state.scene);
    edit(state, |present| *present = scene);
    state.history.settle(&state.scene);
}

fn add(state: &mut State, path: &Path, saved: &SavedMaterial, place: FilePlace) -> MaterialId {
    let id = MaterialId(state.fresh_id());
    let key = saved.sample.as_deref();
    let sample = key.and_then(|key| SAMPLES.iter().position(|sample| sample.key == key));
    let mut source = saved.source.as_ref().map(|source| source.file());
    let (origin, presence) = match (&saved.source, sample, place.found) {
        (Some(_), _, Some(file)) => {
            if let Some(source) = &mut source {
                source.path.clone_from(&file);
            }
            state.session.unread.insert(id);
            (Origin::File(file), Presence::Evicted)
        }
        (Some(source), _, None) => {
            state.session.missing.push(Missing {
                id,
                source: source.clone(),
                tried: place.tried,
                skipped: false,
            });
            (Origin::File(source.path.clone()), Presence::Missing)
        }
        (None, Some(index), _) => (Origin::Sample(index), Presence::Evicted),
        // A model and nothing else.
        (None, None, _) => (Origin::File(path.to_owned()), Presence::Loaded),
    };
    let material = Material {
        fit_due: false,
        name: saved.name.clone(),
        own_name: saved.name.clone(),
        origin,
        source,
        table: Table::unmeasured(),
        presence,
        last_shown: 0,
        guess: saved.guess.0,
        fits: Vec::new(),
    };
    state.materials.insert(id, material);
    for fit in &saved.fits {
        fit::keep_fit(
            state,
            id,
            KeptFit {
                seconds: fit.seconds,
                overlaid: fit.overlaid,
                ..KeptFit::from(&fit.record)
            },
        );
    }
    id
}

fn subject_key(key: &SavedKey, ids: &[MaterialId]) -> Option<SubjectKey> {
    Some(SubjectKey {
        material: *ids.get(key.material)?,
        what: match &key.what {
            SavedWhat::Measured => What::Measured,
            SavedWhat::Model => What::Model,
            SavedWhat::Fit { model, fresnel } => What::Fit(Variant {
                model: Model::by_key(model)?,
                fresnel: Fresnel::by_key(fresnel)?,
            }),
        },
    })
}

fn take_the_rest(state: &mut State, session: &SessionFile) {
    state.fit.settings = settings(&session.fit);
    state.fit.keep_optimal = session.fit.keep_optimal;
    state.fit.table = table(&session.fit);
    state.pinned = session.probe.map(|probe| Probe {
        wi: probe.wi,
        wo: probe.wo,
    });
    if let Some(tiles) = &session.layout {
        state.tiles = tiles.clone();
    }
}

fn table(saved: &SavedFitting) -> FitTable {
    let mut table = FitTable {
        sort: saved.sort,
        descending: saved.descending,
        hidden: BTreeSet::new(),
    };
    // Columns of a newer program are left out.
    let hidden = saved.hidden_columns.iter();
    for column in hidden.filter_map(|key| Column::by_key(key)) {
        table.show(column, false);
    }
    table
}

fn settings(saved: &SavedFitting) -> FitSettings {
    let stages = STAGES.into_iter();
    let stages = stages.filter(|stage| saved.stages.contains(&stage.number()));
    FitSettings {
        weight: saved.weight,
        limit: saved.limit,
        stages: stages.collect(),
        held: saved
            .held
            .iter()
            .filter_map(|key| param_by_key(key))
            .collect(),
        bounds: saved
            .bounds
            .iter()
            .filter_map(|(key, bounds)| Some((param_by_key(key)?, *bounds)))
            .collect(),
        from_sliders: saved.from_sliders,
    }
}

/// The name of the session; what is restored has the one that it had.
fn name(state: &mut State, number: u64, path: &Path, saved_as: Option<PathBuf>) {
    let restored = state.session.restoring.take_if(|other| other.file == path);
    match (restored, saved_as) {
        (Some(restored), saved_as) => {
            state.session.restored.push(restored.file);
            if let Some(file) = saved_as {
                state.session.files.insert(number, file);
            }
        }
        (None, _) => {
            let path = files::absolute(path);
            state.prefs.remember(path.clone());
            state.session.files.insert(number, path);
        }
    }
}

fn remark(state: &mut State, path: &Path, remarks: Vec<String>) {
    let more = remarks.len().saturating_sub(REMARKS);
    for text in remarks.into_iter().take(REMARKS) {
        notify(state, Severity::Info, text);
    }
    if more > 0 {
        let what = format!("{more} more remarks on this session are not shown");
        let text = files::FileError::new(path, what).to_string();
        notify(state, Severity::Info, text);
    }
}

/// Asks for the data of all materials, the shown one first.
fn load_all(state: &mut State, ids: &[MaterialId]) -> Vec<Task> {
    let shown = ids.get(state.scene.selected);
    let others = ids.iter().filter(|id| Some(*id) != shown);
    let mut tasks = Vec::new();
    for id in shown.into_iter().chain(others) {
        let material = state.materials.get(id);
        if material.is_some_and(|material| material.presence == Presence::Evicted) {
            tasks.extend(memory::reload(state, *id).map(|(_, task)| task));
        }
    }
    tasks
}

/// Files of materials were found.
pub(crate) fn located(state: &mut State, found: Vec<(MaterialId, PathBuf)>) -> Vec<Task> {
    let mut ids = Vec::new();
    for (id, path) in found {
        let Some(material) = state.materials.get_mut(&id) else {
            continue;
        };
        if material.presence != Presence::Missing {
            continue;
        }
        let path = files::absolute(&path);
        if let Some(source) = &mut material.source {
            source.path.clone_from(&path);
        }
        material.origin = Origin::File(path);
        material.presence = Presence::Evicted;
        state.session.missing.retain(|missing| missing.id != id);
        state.session.unread.insert(id);
        ids.push(id);
    }
    load_all(state, &ids)
}

/// A file could not be read. What the last run has left is not offered a second time then, and not thrown away either.
pub(crate) fn not_read(state: &mut State, origin: &Origin, reason: String) -> Vec<Task> {
    let left = |crashed: &mut Crashed| *origin == Origin::File(crashed.file.clone());
    let Some(crashed) = state.session.restoring.take_if(left) else {
        notify(state, Severity::Error, reason);
        return Vec::new();
    };
    let text = format!(
        "What was open cannot be restored and is kept beside it with the ending .{DAMAGED}: {reason}"
    );
    notify(state, Severity::Error, text);
    vec![Task::Session(SessionTask::SetAside(crashed))]
}

/// Opens what the last run has left.
pub(crate) fn restore(state: &mut State) -> Vec<Task> {
    // The others are offered at the next start.
    let Some(crashed) = std::mem::take(&mut state.session.crashed)
        .into_iter()
        .next()
    else {
        return Vec::new();
    };
    if crashed.by_system {
        let text = "What was open when the system closed Grazing is open again.";
        notify(state, Severity::Info, text.into());
    }
    let task = load(state, Origin::File(crashed.file.clone()));
    state.session.restoring = Some(crashed);
    if let Some(job) = state.jobs.last_mut() {
        job.label = "what was open".into();
    }
    vec![task]
}
