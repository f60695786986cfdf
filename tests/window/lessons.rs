//! The lessons run through, forwards and back.

use crate::common::window::{Window, click, run, set_slider, settle, value, window};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::lessons::rows::LESSONS;
use grazing::app::state::State;
use grazing::brdf::ParamId;

fn is_set(state: &State) -> bool {
    state.lesson.is_some_and(|at| !at.waits)
}

fn step(window: &Window) -> usize {
    window.state().state().lesson.expect("a lesson").step
}

/// Checks that the card lies over no picture and no slider.
#[track_caller]
fn covers_nothing(window: &Window) {
    let ends = ["End lesson", "Done"];
    let end = ends
        .into_iter()
        .find_map(|name| window.query_by_label(name));
    let card = end.expect("the card").rect();
    for role in [Role::Image, Role::Slider] {
        for node in window.query_all_by_role(role) {
            let rect = node.rect();
            let below = card.top() >= rect.bottom() || card.left() >= rect.right();
            let beside = rect.left() >= card.right() || rect.top() >= card.bottom();
            assert!(below || beside, "{card} over {rect}");
        }
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn every_lesson_runs_through() {
    let mut window = window(vec![], vec![]);
    for (index, lesson) in LESSONS.iter().enumerate() {
        run(&mut window, Command::Lesson(index));
        settle(&mut window, is_set);
        for k in 0..lesson.steps.len() {
            assert_eq!(step(&window), k);
            assert!(window.state().state().looks_at(lesson.steps[k].look_at));
            covers_nothing(&window);
            if k + 1 < lesson.steps.len() {
                click(&mut window, "Next");
            }
        }
        assert!(
            window
                .query_by_role_and_label(Role::Button, "Next")
                .is_none()
        );
        click(&mut window, "Done");
        assert_eq!(window.state().state().lesson, None);
        assert_eq!(window.state().state().notices, []);
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_step_back_shows_what_was_there_whatever_was_dragged() {
    let mut window = window(vec![], vec![]);
    run(&mut window, Command::Lesson(0));
    settle(&mut window, is_set);
    let s = |window: &Window| value(window, ParamId("s"));
    let model = |window: &Window| {
        window
            .state()
            .state()
            .current()
            .expect("one")
            .1
            .brdf
            .model
            .key
    };
    assert_eq!((model(&window), s(&window)), ("phong", 30.0));
    click(&mut window, "Next");
    assert_eq!((model(&window), s(&window)), ("blinn-phong", 120.0));
    set_slider(&mut window, "s", 7.0);
    assert!((s(&window) - 7.0).abs() < 0.1);
    click(&mut window, "Again");
    assert_eq!(s(&window), 120.0);
    set_slider(&mut window, "s", 7.0);
    click(&mut window, "Back");
    assert_eq!(
        (step(&window), model(&window), s(&window)),
        (0, "phong", 30.0)
    );
    // It was one step, which undo takes back.
    run(&mut window, Command::Undo);
    assert!((s(&window) - 7.0).abs() < 0.1);
    click(&mut window, "End lesson");
    assert_eq!(window.state().state().lesson, None);
}
