//! Reducer of fits: how the state changes when one starts, reports, stops and ends.

use crate::app::msg::Task;
use crate::app::msg::fit::{FitMsg, FitTask, RefitAmplitudes, Timed};
use crate::app::reduce::{edit, edit_brdf, notify, opening_fit};
use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::run::{FitRun, Part};
use crate::app::state::job::CancelFlag;
use crate::app::state::material::{Material, MaterialId, Opened};
use crate::app::state::notice::Severity;
use crate::app::state::views::ViewId;
use crate::brdf::Brdf;
use crate::fit::{ProblemError, Variant};

/// Changes the state.
pub(crate) fn apply(state: &mut State, msg: FitMsg) -> Vec<Task> {
    match msg {
        FitMsg::Settings(settings) => {
            let other_problem = settings.weight != state.fit.settings.weight
                || settings.limit != state.fit.settings.limit;
            state.fit.settings = settings;
            if other_problem {
                return refit_as_step(state);
            }
        }
        FitMsg::Updates(updates) => {
            if let Some(run) = state.fit.run.as_mut().filter(|run| run.job == updates.job) {
                run.take_in(updates);
            }
        }
        FitMsg::Done { job, result } => {
            let Some(run) = state.fit.run.take_if(|run| run.job == job) else {
                return Vec::new();
            };
            match result {
                Ok(outcomes) => end(state, run, outcomes),
                // Nobody has asked for it: the panel says that there is none.
                Err(_) if run.on_opening.is_some() => {}
                Err(reason) => notify(state, Severity::Error, reason),
            }
        }
        FitMsg::Show(variant) => {
            let kept = state.current().and_then(|(material, opened)| {
                Some((opened.id, material.fit(variant)?.outcome.brdf))
            });
            if let Some((id, brdf)) = kept {
                release_model(state);
                set_model(state, id, brdf);
            }
        }
        FitMsg::Overlay(variant, on) => {
            let id = state.current().map(|(_, opened)| opened.id);
            let material = id.and_then(|id| state.materials.get_mut(&id));
            if let Some(kept) = material.and_then(|material| material.fit_mut(variant)) {
                kept.overlaid = on;
            }
        }
        FitMsg::SortBy(column) => state.fit.table.sort_by(column),
        FitMsg::ShowColumn(column, shown) => state.fit.table.show(column, shown),
        FitMsg::AmplitudesRefit {
            number,
            material,
            as_step,
            result,
        } if number >= state.fit.refit_from && state.fit.keep_optimal
            || number == state.fit.refit_taken && is_still(state, material, &result) =>
        {
            match result {
                Ok(best) => take_amplitudes(state, material, &best, as_step),
                Err(reason) => {
                    state.fit.keep_optimal = false;
                    notify(state, Severity::Error, reason.to_string());
                }
            }
        }
        FitMsg::AmplitudesRefit { .. } => {}
    }
    Vec::new()
}

/// Starts to fit the shown model; what runs is stopped.
pub(crate) fn start(state: &mut State) -> Vec<Task> {
    match state.current() {
        Some((_, opened)) if state.fit_blocked().is_none() => {
            let variant = Variant::from(&opened.brdf);
            start_run(state, vec![variant], false)
        }
        _ => Vec::new(),
    }
}

/// Starts to fit the models to compare, and shows their table; what runs is stopped.
pub(crate) fn compare(state: &mut State) -> Vec<Task> {
    if state.comparison_blocked().is_some() {
        return Vec::new();
    }
    state.tiles.show(ViewId::Fits);
    start_run(state, state.prefs.comparison.variants(), true)
}

fn start_run(state: &mut State, variants: Vec<Variant>, compares: bool) -> Vec<Task> {
    stop(state);
    state.fit.refit_from = state.fresh_id();
    let job = state.fresh_id();
    let Some((material, opened)) = state.current() else {
        return Vec::new();
    };
    let (run, task) = run_of(state, job, (material, opened), variants);
    state.fit.run = Some(FitRun { compares, ..run });
    vec![task]
}

/// Starts to fit a material that was just opened, shown or not, unless there is nothing to fit.
pub(crate) fn start_on_opening(state: &mut State, id: MaterialId) -> Vec<Task> {
    let job = state.fresh_id();
    let opened = state.scene.opened.iter().find(|opened| opened.id == id);
    let Some((material, opened)) = state.materials.get(&id).zip(opened) else {
        return Vec::new();
    };
    let guess = opened.brdf;
    if state.fit.settings.blocked(&guess).is_some() {
        return Vec::new();
    }
    let (run, task) = run_of(state, job, (material, opened), vec![Variant::from(&guess)]);
    state.fit.run = Some(FitRun {
        on_opening: Some(guess),
        ..run
    });
    vec![task]
}

/// A fit of a material with the settings of the panel, and the task that does it.
fn run_of(
    state: &State,
    job: u64,
    (material, opened): (&Material, &Opened),
    variants: Vec<Variant>,
) -> (FitRun, Task) {
    let part = |variant: &Variant| Part {
        variant: *variant,
        updates: Vec::new(),
    };
    let run = FitRun {
        job,
        material: opened.id,
        parts: variants.iter().map(part).collect(),
        compares: false,
        at: 0,
        setup: state.fit.settings.setup(&opened.brdf),
        cancel: CancelFlag::default(),
        stopping: false,
        live: None,
        on_opening: None,
        left: None,
    };
    let task = Task::Fit(FitTask {
        job,
        material: opened.id,
        table: material.table.clone(),
        variants,
        setup: run.setup.clone(),
        cancel: run.cancel.clone(),
    });
    (run, task)
}

/// Stops the run. The best so far is the model from now on, though the thread may need a moment to end.
pub(crate) fn stop(state: &mut State) {
    let Some(run) = state.fit.run.as_mut().filter(|run| !run.stopping) else {
        return;
    };
    run.cancel.set();
    run.stopping = true;
    run.left = run.live.take();
    if let Some(best) = run.left {
        let guess = run.on_opening;
        come_to(state, best.id, best.brdf, guess);
    }
}

/// Gives a material the model that a fit has come to: as a step, or as part of its opening.
fn come_to(state: &mut State, material: MaterialId, best: Brdf, guess: Option<Brdf>) {
    match guess {
        Some(guess) => opening_fit::put(state, material, guess, best),
        None => set_model(state, material, best),
    }
}

/// Stops the run if it moves the shown model: a person takes over.
pub(crate) fn release_model(state: &mut State) {
    if state.current_run().is_some_and(FitRun::drives_model) {
        stop(state);
    }
}

/// Stops the run if it moves the model of this material, shown or not: another model is laid over it.
pub(crate) fn release_model_of(state: &mut State, material: MaterialId) {
    let drives = |run: &FitRun| run.material == material && run.drives_model();
    if state.fit.run.as_ref().is_some_and(drives) {
        stop(state);
    }
}

/// Stops the run of a material that is closed, and forgets it.
pub(crate) fn forget(state: &mut State, material: MaterialId) {
    if let Some(run) = state.fit.run.take_if(|run| run.material == material) {
        run.cancel.set();
    }
}

/// Asks for the best ρ_d and k_s of the shown model, if they are to follow the other parameters. The answer belongs to
/// the edit before this.
pub(crate) fn refit(state: &mut State) -> Vec<Task> {
    ask_for_amplitudes(state, false)
}

/// Asks for the best ρ_d and k_s of the shown model as [`refit`] does, as a step of its own where there was no edit.
pub(crate) fn refit_as_step(state: &mut State) -> Vec<Task> {
    ask_for_amplitudes(state, true)
}

fn ask_for_amplitudes(state: &mut State, as_step: bool) -> Vec<Task> {
    // A fit under way finds them itself.
    if !state.fit.keep_optimal || state.current_run().is_some_and(FitRun::drives_model) {
        return Vec::new();
    }
    refit_now(state, as_step)
}

fn refit_now(state: &mut State, as_step: bool) -> Vec<Task> {
    let number = state.fresh_id();
    let Some((material, opened)) = state
        .current()
        .filter(|(material, _)| !material.is_loading())
    else {
        return Vec::new();
    };
    vec![Task::RefitAmplitudes(RefitAmplitudes {
        number,
        material: opened.id,
        table: material.table.clone(),
        setup: state.fit.settings.setup(&opened.brdf),
        brdf: opened.brdf,
        as_step,
    })]
}

/// Lays a model over the shown material, and asks once for its best ρ_d and k_s, whether they follow the sliders or
/// not. The answer belongs to that edit.
pub(crate) fn take(state: &mut State, taken: Brdf) -> Vec<Task> {
    edit_brdf(state, |brdf| *brdf = taken);
    let tasks = refit_now(state, false);
    if let Some(Task::RefitAmplitudes(resolve)) = tasks.first() {
        state.fit.refit_taken = resolve.number;
    }
    tasks
}

/// Answers that are on their way no longer count.
pub(crate) fn forget_refits(state: &mut State) {
    state.fit.refit_from = state.fresh_id();
    state.fit.refit_taken = 0;
}

fn end(state: &mut State, run: FitRun, outcomes: Vec<Timed>) {
    let drives = run.drives_model();
    let FitRun {
        material,
        parts,
        setup,
        stopping,
        on_opening,
        left,
        ..
    } = run;
    // Stopped before it said anything: what it brings is only where it began.
    let said_something = |part: &Part| !stopping || !part.updates.is_empty();
    for (timed, part) in outcomes.into_iter().zip(parts) {
        let brdf = timed.outcome.brdf;
        if drives {
            come_to(state, material, brdf, on_opening);
        } else if let Some(left) = left {
            // The outcome may be a little past the last word that was heard.
            let scene = &mut state.scene;
            let untouched = |opened: &&mut _| **opened == left;
            if let Some(opened) = scene.opened.iter_mut().find(untouched) {
                opened.brdf = brdf;
            }
        }
        if said_something(&part) {
            let fit = KeptFit {
                outcome: timed.outcome,
                setup: setup.clone(),
                seconds: Some(timed.seconds),
                trace: part.updates,
                on_opening: on_opening.is_some(),
                overlaid: false,
            };
            keep_fit(state, material, fit);
        }
    }
}

/// Keeps a fit of a material in place of the one of the same variant.
///
/// One that was cancelled does not replace one that was made with the same setup and ran to its end.
/// Of a file, it is kept with the path too: the file may be opened again.
pub(crate) fn keep_fit(state: &mut State, material: MaterialId, mut fit: KeptFit) {
    let Some(material) = state.materials.get_mut(&material) else {
        return;
    };
    let variant = fit.variant();
    match material
        .fits
        .iter_mut()
        .find(|kept| kept.variant() == fit.variant())
    {
        Some(kept)
            if fit.is_cancelled()
                && !kept.is_cancelled()
                && kept.setup.asks_the_same(&fit.setup) => {}
        Some(kept) => {
            fit.overlaid = kept.overlaid;
            *kept = fit;
        }
        None => material.fits.push(fit),
    }
    if let (Some(path), Some(kept)) = (material.file(), material.fit(variant)) {
        let record = kept.record(material.own_name.clone(), material.source.clone());
        state.library.keep_fit(&path, record);
    }
}

/// Gives a material a model, as one step.
fn set_model(state: &mut State, material: MaterialId, brdf: Brdf) {
    // Another gesture may be under way.
    state.history.settle(&state.scene);
    edit(state, |scene| {
        if let Some(opened) = scene.opened.iter_mut().find(|other| other.id == material) {
            opened.brdf = brdf;
        }
    });
    state.history.settle(&state.scene);
}

/// Whether a material still has the shape that the best ρ_d and k_s were found for.
fn is_still(state: &State, material: MaterialId, found: &Result<Brdf, ProblemError>) -> bool {
    let shape = |brdf: &Brdf| (brdf.model, brdf.params.lobe, brdf.params.eta);
    let same = |best: &Brdf| {
        let mut opened = state.scene.opened.iter();
        opened.any(|opened| opened.id == material && shape(&opened.brdf) == shape(best))
    };
    found.as_ref().map_or(true, same)
}

/// Sets ρ_d and k_s, if the material still has that model.
fn take_amplitudes(state: &mut State, material: MaterialId, best: &Brdf, as_step: bool) {
    let same = |opened: &&mut Opened| {
        opened.id == material && Variant::from(&opened.brdf) == Variant::from(best)
    };
    let Some(opened) = state.scene.opened.iter_mut().find(same) else {
        return;
    };
    let mut brdf = opened.brdf;
    brdf.params.rho_d = best.params.rho_d;
    brdf.params.k_s = best.params.k_s;
    if as_step {
        set_model(state, material, brdf);
    } else {
        opened.brdf = brdf;
    }
}
