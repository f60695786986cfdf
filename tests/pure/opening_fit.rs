//! Fits on opening, message by message: which material is fitted when, and what undo finds.

use crate::fit_steps::{done, job, loaded, outcome, run, say, set, shown, shown_id, with_s};
use grazing::app::command::Command;
use grazing::app::msg::{Loaded, Msg, Task};
use grazing::app::reduce::apply;
use grazing::app::state::State;
use grazing::app::state::material::{MaterialId, Origin};
use grazing::brdf::{Brdf, ParamId};
use grazing::fit::EndReason;
use grazing::measured::{Grid, Table};

/// Opens one more grey material; what follows.
fn open(state: &mut State, k: usize) -> Vec<Task> {
    let table = Table::new(Grid::FOLDED, vec![[0.1; 3]; Grid::FOLDED.len()]);
    let result = Ok(Loaded::new(format!("grey {k}"), None, table));
    apply(state, loaded(Origin::Sample(k), result))
}

/// The fit that is under way on opening.
fn fitted(state: &State) -> Option<MaterialId> {
    let run = state.fit.run.as_ref()?;
    run.on_opening.is_some().then_some(run.material)
}

fn end(state: &mut State, job: u64, brdf: Brdf) {
    done(state, job, vec![outcome(brdf, 0.1, EndReason::Converged)]);
}

#[test]
fn what_is_opened_is_fitted_as_part_of_the_opening() {
    let mut state = State::default();
    let job = job(&open(&mut state, 0));
    let best = with_s(&state, 7.0);
    say(&mut state, job, 0, best);
    assert_eq!(shown(&state), best);
    end(&mut state, job, best);
    assert_eq!(state.scene.opened[0].brdf, best);
    let material = &state.materials[&shown_id(&state)];
    assert!(material.fits[0].on_opening && material.fits[0].outcome.brdf == best);
    assert!(!state.history.can_undo());
    // It is fitted once: nothing that happens later starts it again.
    assert!(apply(&mut state, Msg::Settle).is_empty());
    set(&mut state, ParamId("s"), 90.0);
    assert!(run(&mut state, Command::Undo).is_empty());
    assert_eq!(shown(&state), best);
}

#[test]
fn a_step_made_meanwhile_goes_back_to_the_fit_and_not_to_the_guess() {
    let mut state = State::default();
    let job = job(&open(&mut state, 0));
    let best = with_s(&state, 7.0);
    // Another view, an angle: a step that keeps the scene with the guess.
    run(&mut state, Command::ToggleRaw);
    apply(&mut state, Msg::Settle);
    end(&mut state, job, best);
    run(&mut state, Command::Undo);
    assert_eq!(shown(&state), best);
    run(&mut state, Command::Redo);
    assert_eq!(shown(&state), best);
}

#[test]
fn a_slider_ends_it_and_it_does_not_come_back() {
    let mut state = State::default();
    let job = job(&open(&mut state, 0));
    let so_far = with_s(&state, 7.0);
    say(&mut state, job, 0, so_far);
    set(&mut state, ParamId("alpha"), 0.25);
    apply(&mut state, Msg::Settle);
    let moved = shown(&state);
    assert_eq!((moved.params.lobe[0], moved.params.lobe[1]), (7.0, 0.25));
    let past = with_s(&state, 9.0);
    end(&mut state, job, past);
    assert_eq!(shown(&state), moved);
    run(&mut state, Command::Undo);
    assert_eq!(shown(&state), so_far);
    assert!(state.fit.run.is_none());
}

#[test]
fn of_many_the_shown_one_goes_first_and_the_others_follow() {
    let mut state = State::default();
    open(&mut state, 0);
    let first = shown_id(&state);
    assert_eq!(fitted(&state), Some(first));
    open(&mut state, 1);
    let second = shown_id(&state);
    let tasks = open(&mut state, 2);
    let third = shown_id(&state);
    assert_eq!(fitted(&state), Some(third));
    let mut number = job(&tasks);
    for next in [Some(first), Some(second), None] {
        let best = with_s(&state, 7.0);
        done(
            &mut state,
            number,
            vec![outcome(best, 0.1, EndReason::Converged)],
        );
        assert_eq!(fitted(&state), next);
        number = state.fit.run.as_ref().map_or(0, |run| run.job);
    }
    assert!(state.materials.values().all(|one| one.fits.len() == 1));
}

#[test]
fn a_fit_that_a_person_starts_is_waited_for() {
    let mut state = State::default();
    let opening = job(&open(&mut state, 0));
    let asked = job(&run(&mut state, Command::Compare));
    assert_ne!(opening, asked);
    open(&mut state, 1);
    assert_eq!(state.fit.run.as_ref().map(|run| run.job), Some(asked));
    done(&mut state, asked, Vec::new());
    assert_eq!(fitted(&state), Some(shown_id(&state)));
}

#[test]
fn nothing_is_fitted_where_it_is_not_wanted() {
    // Switched off.
    let mut state = State::default();
    run(&mut state, Command::ToggleFitOnOpening);
    assert!(open(&mut state, 0).is_empty());
    // Switched on later, it is for what is opened from then on.
    assert!(run(&mut state, Command::ToggleFitOnOpening).is_empty());
    assert!(fitted(&state).is_none());

    // In a lesson, and after it.
    let mut state = State::default();
    run(&mut state, Command::Lesson(0));
    open(&mut state, 0);
    assert!(fitted(&state).is_none());
    apply(&mut state, Msg::EndLesson);
    assert!(fitted(&state).is_none());

    // A model without data.
    let mut state = State::default();
    let nothing = Loaded::new("nothing".into(), None, (*Table::unmeasured()).clone());
    assert!(apply(&mut state, loaded(Origin::Sample(0), Ok(nothing))).is_empty());

    // No stage is ticked: there is nothing to run, then or when one is ticked again.
    let mut state = State::default();
    state.fit.settings.stages = grazing::fit::StageSet::NONE;
    open(&mut state, 0);
    state.fit.settings.stages = grazing::fit::StageSet::ALL;
    apply(&mut state, Msg::Settle);
    assert!(fitted(&state).is_none());
}

#[test]
fn closing_ends_it() {
    let mut state = State::default();
    open(&mut state, 0);
    apply(&mut state, Msg::Close(0));
    assert!(state.fit.run.is_none());
    assert!(apply(&mut state, Msg::Settle).is_empty());
}
