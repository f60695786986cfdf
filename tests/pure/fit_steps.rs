//! What a fit does to the state, message by message, without a window or an engine.

use grazing::app::command::Command;
use grazing::app::msg::fit::{FitMsg, Timed};
use grazing::app::msg::{Loaded, Msg, Task};
use grazing::app::reduce::apply;
use grazing::app::state::State;
use grazing::app::state::fitting::run::FitUpdates;
use grazing::app::state::fitting::settings::FitSettings;
use grazing::app::state::material::{MaterialId, Origin};
use grazing::app::views::lobes::settings::LobeSettings;
use grazing::brdf::{Brdf, Fresnel, ParamId};
use grazing::brdf::{MODELS, PHONG_FAMILY};
use grazing::figure::lobes::LobeScale;
use grazing::fit::{
    EndReason, Errors, FitProgress, Outcome, ProblemError, Stage, StageSet, Variant, Weight,
};
use grazing::measured::{Grid, Table};

/// A state with `count` grey materials, the last of them shown.
pub(crate) fn state(count: usize) -> State {
    let mut state = State::default();
    state.prefs.fit_on_opening.0 = false;
    for k in 0..count {
        let table = Table::new(Grid::FOLDED, vec![[0.1; 3]; Grid::FOLDED.len()]);
        let result = Ok(Loaded::new(format!("grey {k}"), None, table));
        let origin = Origin::Sample(k);
        apply(&mut state, loaded(origin, result));
    }
    state
}

pub(crate) fn loaded(origin: Origin, result: Result<Loaded, Option<String>>) -> Msg {
    Msg::Loaded {
        job: 0,
        origin,
        result,
    }
}

pub(crate) fn run(state: &mut State, command: Command) -> Vec<Task> {
    apply(state, Msg::Run(command))
}

pub(crate) fn shown(state: &State) -> Brdf {
    state.current().expect("a material").1.brdf
}

pub(crate) fn shown_id(state: &State) -> MaterialId {
    state.current().expect("a material").1.id
}

pub(crate) fn with_s(state: &State, s: f64) -> Brdf {
    let mut brdf = shown(state);
    brdf.params.lobe[0] = s;
    brdf
}

/// The number of the fit that the tasks start.
pub(crate) fn job(tasks: &[Task]) -> u64 {
    let fit = tasks.iter().find_map(|task| match task {
        Task::Fit(task) => Some(task.job),
        _ => None,
    });
    fit.expect("a fit is started")
}

pub(crate) fn say(state: &mut State, job: u64, position: usize, brdf: Brdf) {
    let progress = FitProgress {
        stage: Stage::Joint,
        brdf,
        error: 0.2,
        all_cells: true,
        evaluations: 10,
        share: 0.5,
    };
    let updates = vec![(position, progress)];
    apply(
        state,
        Msg::Fit(FitMsg::Updates(FitUpdates { job, updates })),
    );
}

pub(crate) fn outcome(brdf: Brdf, error: f64, ended: EndReason) -> Timed {
    Timed {
        outcome: Outcome {
            brdf,
            errors: Errors {
                total: error,
                grazing: Some(error),
                channels: [error; 3],
            },
            stages: Vec::new(),
            evaluations: 10,
            ended,
            albedo: [[0.5; 3]; 3],
            concerns: Vec::new(),
        },
        seconds: 1.0,
    }
}

pub(crate) fn done(state: &mut State, job: u64, outcomes: Vec<Timed>) {
    let result = Ok(outcomes);
    let msg = FitMsg::Done { job, result };
    apply(state, Msg::Fit(msg));
}

pub(crate) fn set(state: &mut State, id: ParamId, value: f64) -> Vec<Task> {
    let channel = None;
    apply(state, Msg::SetParam { id, channel, value })
}

fn fits(state: &State) -> usize {
    state.current().expect("a material").0.fits.len()
}

#[test]
fn a_fit_is_one_step_whatever_is_edited_meanwhile() {
    let mut state = state(1);
    let before = shown(&state);
    let job = job(&run(&mut state, Command::Fit));
    for s in [7.0, 8.0] {
        let brdf = with_s(&state, s);
        say(&mut state, job, 0, brdf);
        assert_eq!(shown(&state).params.lobe[0], s, "the model follows");
    }
    run(&mut state, Command::UseScale(LobeScale::Log));
    apply(&mut state, Msg::Settle);
    let best = with_s(&state, 9.0);
    done(
        &mut state,
        job,
        vec![outcome(best, 0.1, EndReason::Converged)],
    );
    assert!(state.fit.run.is_none());
    assert_eq!((shown(&state), fits(&state)), (best, 1));
    run(&mut state, Command::Undo);
    // The scale that was chosen meanwhile is a step of its own.
    assert_eq!(shown(&state), before);
    assert_eq!(
        state.scene.views.get::<LobeSettings>().scale,
        LobeScale::Log
    );
    run(&mut state, Command::Undo);
    assert_eq!(
        state.scene.views.get::<LobeSettings>().scale,
        LobeScale::Auto
    );
    assert!(!state.history.can_undo());
    assert_eq!(fits(&state), 1, "a fit is kept whatever the sliders show");
    run(&mut state, Command::Redo);
    run(&mut state, Command::Redo);
    assert_eq!(shown(&state), best);
}

#[test]
fn what_a_replaced_fit_says_is_not_heard() {
    let mut state = state(1);
    let first = job(&run(&mut state, Command::Fit));
    let of_first = with_s(&state, 3.0);
    say(&mut state, first, 0, of_first);
    let tasks = run(&mut state, Command::Fit);
    let second = job(&tasks);
    assert_eq!(shown(&state), of_first, "the best so far stays");
    let late = with_s(&state, 4.0);
    say(&mut state, first, 0, late);
    done(
        &mut state,
        first,
        vec![outcome(late, 0.1, EndReason::Cancelled)],
    );
    assert_eq!((shown(&state), fits(&state)), (of_first, 0));
    let best = with_s(&state, 5.0);
    done(
        &mut state,
        second,
        vec![outcome(best, 0.1, EndReason::Converged)],
    );
    assert_eq!((shown(&state), fits(&state)), (best, 1));
}

#[test]
fn cancelling_keeps_the_best_at_once_and_undo_takes_it_back() {
    let mut state = state(1);
    let before = shown(&state);
    let job = job(&run(&mut state, Command::Fit));
    let best = with_s(&state, 7.0);
    say(&mut state, job, 0, best);
    run(&mut state, Command::CancelFit);
    let stopping = state.fit.run.as_ref().expect("its outcome is to come");
    assert!(stopping.stopping && stopping.cancel.is_set());
    assert!(!Command::CancelFit.is_enabled(&state));
    assert_eq!(state.scene.opened[0].brdf, best);
    // The outcome may know a little more.
    let last = with_s(&state, 7.01);
    done(
        &mut state,
        job,
        vec![outcome(last, 0.1, EndReason::Cancelled)],
    );
    assert_eq!((shown(&state), fits(&state)), (last, 1));
    run(&mut state, Command::Undo);
    assert_eq!(shown(&state), before);
    assert!(!state.history.can_undo());
}

#[test]
fn a_fit_that_is_stopped_before_its_first_word_leaves_nothing() {
    let mut state = state(1);
    let before = shown(&state);
    let job = job(&run(&mut state, Command::Fit));
    run(&mut state, Command::CancelFit);
    let guess = with_s(&state, 7.0);
    done(
        &mut state,
        job,
        vec![outcome(guess, 0.5, EndReason::Cancelled)],
    );
    assert_eq!((shown(&state), fits(&state)), (before, 0));
    assert!(!state.history.can_undo());
}

#[test]
fn a_slider_takes_over_from_the_fit() {
    let mut state = state(1);
    let job = job(&run(&mut state, Command::Fit));
    let mut best = with_s(&state, 7.0);
    best.params.lobe[1] = 0.25;
    say(&mut state, job, 0, best);
    set(&mut state, ParamId("s"), 20.0);
    apply(&mut state, Msg::Settle);
    assert!(
        state
            .fit
            .run
            .as_ref()
            .is_some_and(|run| run.cancel.is_set())
    );
    assert_eq!(
        (shown(&state).params.lobe[0], shown(&state).params.lobe[1]),
        (20.0, 0.25)
    );
    done(
        &mut state,
        job,
        vec![outcome(best, 0.1, EndReason::Cancelled)],
    );
    assert_eq!(
        shown(&state).params.lobe[0],
        20.0,
        "the slider has the last word"
    );
    run(&mut state, Command::Undo);
    assert_eq!(shown(&state), best);
}

#[test]
fn a_fit_goes_on_for_its_own_material() {
    let mut state = state(2);
    let (own, other) = (shown_id(&state), shown(&state));
    let job = job(&run(&mut state, Command::Fit));
    apply(&mut state, Msg::Select(0));
    let best = with_s(&state, 7.0);
    say(&mut state, job, 0, best);
    assert_eq!(shown(&state), other, "another material is shown");
    set(&mut state, ParamId("s"), 99.0);
    assert!(state.fit.run.as_ref().is_some_and(|run| !run.stopping));
    done(
        &mut state,
        job,
        vec![outcome(best, 0.1, EndReason::Converged)],
    );
    assert_eq!(shown(&state).params.lobe[0], 99.0);
    assert_eq!(state.materials[&own].fits.len(), 1);
    assert_eq!(state.scene.opened[1].brdf, best);
}

#[test]
fn closing_the_material_ends_its_fit() {
    let mut state = state(2);
    let before = shown(&state);
    let started = run(&mut state, Command::Fit);
    let number = job(&started);
    let best = with_s(&state, 7.0);
    say(&mut state, number, 0, best);
    apply(&mut state, Msg::Close(1));
    let Task::Fit(task) = &started[0] else {
        panic!("{started:?}")
    };
    assert!(task.cancel.is_set() && state.fit.run.is_none());
    done(
        &mut state,
        number,
        vec![outcome(best, 0.1, EndReason::Cancelled)],
    );
    apply(&mut state, Msg::Settle);
    run(&mut state, Command::Undo);
    assert_eq!((shown(&state), fits(&state)), (before, 0));
}

#[test]
fn several_variants_leave_the_model_alone() {
    let mut state = state(1);
    let before = shown(&state);
    let tasks = run(&mut state, Command::Compare);
    let variants = Variant::of(PHONG_FAMILY, before.fresnel);
    let Task::Fit(task) = &tasks[0] else {
        panic!("{tasks:?}")
    };
    assert_eq!(task.variants, variants);
    let number = job(&tasks);
    let brdfs: Vec<Brdf> = variants
        .iter()
        .map(|variant| variant.with(before.params))
        .collect();
    say(&mut state, number, 1, brdfs[1]);
    assert_eq!(shown(&state), before);
    // Moving a slider does not concern it.
    set(&mut state, ParamId("s"), 20.0);
    assert!(state.fit.run.as_ref().is_some_and(|run| !run.stopping));
    let outcomes = brdfs
        .iter()
        .map(|brdf| outcome(*brdf, 0.1, EndReason::Converged));
    done(&mut state, number, outcomes.collect());
    assert_eq!((shown(&state).params.lobe[0], fits(&state)), (20.0, 6));
    apply(&mut state, Msg::Settle);
    apply(&mut state, Msg::Fit(FitMsg::Show(variants[1])));
    assert_eq!(shown(&state), brdfs[1]);
    run(&mut state, Command::Undo);
    assert_eq!(shown(&state).params.lobe[0], 20.0);
}

#[test]
fn what_is_compared_is_what_was_ticked() {
    let mut state = state(1);
    let asked = |state: &mut State| match run(state, Command::Compare).as_slice() {
        [Task::Fit(task)] => task.variants.clone(),
        _ => Vec::new(),
    };
    run(&mut state, Command::UseFresnel(Fresnel::None));
    assert_eq!(
        asked(&mut state),
        Variant::of(PHONG_FAMILY, Fresnel::Exact),
        "the shown model does not matter"
    );
    run(&mut state, Command::CompareEvery);
    assert_eq!(asked(&mut state), Variant::of(MODELS, Fresnel::Exact));
    run(&mut state, Command::ToggleComparedFresnel(Fresnel::None));
    run(&mut state, Command::CompareFamily);
    run(&mut state, Command::ToggleCompared(0));
    run(&mut state, Command::ToggleCompared(3));
    let fresnel = Fresnel::Exact;
    let models = [MODELS[1], MODELS[2], MODELS[3]];
    let wanted = models.map(|model| Variant { model, fresnel });
    assert_eq!(asked(&mut state), wanted);
    // None is asked for, and what runs goes on.
    run(&mut state, Command::ToggleComparedFresnel(Fresnel::Exact));
    assert!(!Command::Compare.is_enabled(&state) && asked(&mut state).is_empty());
    assert!(state.fit.run.as_ref().is_some_and(|run| !run.stopping));
}

#[test]
fn one_model_to_compare_leaves_the_shown_one_alone() {
    let mut state = state(1);
    let before = shown(&state);
    run(&mut state, Command::CompareEvery);
    for index in 1..MODELS.len() {
        run(&mut state, Command::ToggleCompared(index));
    }
    run(&mut state, Command::ToggleComparedFresnel(Fresnel::Exact));
    let number = job(&run(&mut state, Command::Compare));
    let brdf = Brdf::new(MODELS[0], Fresnel::None);
    say(&mut state, number, 0, brdf);
    assert_eq!(shown(&state), before);
    done(
        &mut state,
        number,
        vec![outcome(brdf, 0.1, EndReason::Converged)],
    );
    assert_eq!((shown(&state), fits(&state)), (before, 1));
}

#[test]
fn a_cancelled_fit_does_not_replace_one_that_was_asked_the_same() {
    let mut state = state(1);
    let fit = |state: &mut State, error: f64, ended: EndReason| {
        let number = job(&run(state, Command::Fit));
        let brdf = with_s(state, 7.0);
        say(state, number, 0, brdf);
        if ended == EndReason::Cancelled {
            run(state, Command::CancelFit);
        }
        done(state, number, vec![outcome(brdf, error, ended)]);
        state.current_fit().expect("a fit").outcome.errors.total
    };
    assert_eq!(fit(&mut state, 0.1, EndReason::Converged), 0.1);
    assert_eq!(fit(&mut state, 0.3, EndReason::Cancelled), 0.1);
    assert!(!state.is_stale(state.current_fit().expect("a fit")));
    run(&mut state, Command::UseWeight(Weight::Cells));
    assert!(state.is_stale(state.current_fit().expect("a fit")));
    assert_eq!(fit(&mut state, 0.3, EndReason::Cancelled), 0.3);
    assert!(!state.is_stale(state.current_fit().expect("a fit")));
}

/// The newest question for ρ_d and k_s, answered with this k_s.
fn answer(state: &mut State, tasks: &[Task], k_s: f64) {
    let Some(Task::RefitAmplitudes(asked)) = tasks.last() else {
        panic!("{tasks:?}")
    };
    let mut best = asked.brdf;
    best.params.k_s = [k_s; 3];
    let msg = FitMsg::AmplitudesRefit {
        number: asked.number,
        material: asked.material,
        as_step: asked.as_step,
        result: Ok(best),
    };
    apply(state, Msg::Fit(msg));
}

#[test]
fn a_drag_with_its_best_amplitudes_is_one_step() {
    let mut state = state(1);
    assert!(
        set(&mut state, ParamId("s"), 10.0).is_empty(),
        "nothing is asked unless wanted"
    );
    apply(&mut state, Msg::Settle);
    let tasks = run(&mut state, Command::ToggleKeepOptimal);
    answer(&mut state, &tasks, 3.0);
    let before = shown(&state);
    assert_eq!(before.params.k_s, [3.0; 3]);
    let first = set(&mut state, ParamId("s"), 11.0);
    let second = set(&mut state, ParamId("s"), 12.0);
    answer(&mut state, &first, 4.0);
    assert_eq!(
        (shown(&state).params.lobe[0], shown(&state).params.k_s[0]),
        (12.0, 4.0)
    );
    apply(&mut state, Msg::Settle);
    // The last one may come after the button was let go.
    answer(&mut state, &second, 5.0);
    assert_eq!(shown(&state).params.k_s, [5.0; 3]);
    run(&mut state, Command::Undo);
    assert_eq!(shown(&state), before);
    // What was asked before an undo does not count after it.
    answer(&mut state, &second, 6.0);
    assert_eq!(shown(&state), before);
    // Switching it on was a step of its own.
    run(&mut state, Command::Undo);
    assert_ne!(shown(&state).params.k_s, before.params.k_s);
    assert_eq!(shown(&state).params.lobe[0], 10.0);
}

#[test]
fn best_amplitudes_follow_the_model_and_what_cannot_be_had_says_so() {
    let mut state = state(1);
    run(&mut state, Command::ToggleKeepOptimal);
    for command in [
        Command::UseModel(0),
        Command::UseFresnel(Fresnel::None),
        Command::ResetParams,
        Command::GuessParams,
    ] {
        let tasks = run(&mut state, command);
        let Some(Task::RefitAmplitudes(asked)) = tasks.last() else {
            panic!("{command:?}: {tasks:?}")
        };
        assert_eq!(asked.brdf, shown(&state));
    }
    let tasks = set(&mut state, ParamId("s"), 4.0);
    let Some(Task::RefitAmplitudes(asked)) = tasks.last() else {
        panic!("{tasks:?}")
    };
    let msg = FitMsg::AmplitudesRefit {
        number: asked.number,
        material: asked.material,
        as_step: false,
        result: Err(ProblemError::NoCells),
    };
    apply(&mut state, Msg::Fit(msg));
    assert!(!state.fit.keep_optimal);
    assert!(state.notices[0].text.contains("raise the limit"));
}

#[test]
fn an_unfinished_setup_cannot_be_fitted() {
    let mut state = state(1);
    let stages = StageSet::NONE;
    let settings = FitSettings {
        stages,
        ..FitSettings::default()
    };
    apply(&mut state, Msg::Fit(FitMsg::Settings(settings)));
    assert!(!Command::Fit.is_enabled(&state));
    assert!(run(&mut state, Command::Fit).is_empty() && state.fit.run.is_none());
    assert!(State::default().fit_blocked().is_some());
}
