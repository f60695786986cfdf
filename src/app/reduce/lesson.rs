//! Reducer of lessons: how the state changes from step to step.

use crate::app::lessons::Set;
use crate::app::lessons::rows::LESSONS;
use crate::app::msg::Task;
use crate::app::reduce::opening::load;
use crate::app::reduce::{edit, edit_brdf, set_param};
use crate::app::state::State;
use crate::app::state::fitting::comparison::Comparison;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::state::lesson::LessonAt;
use crate::app::state::material::Origin;
use crate::app::views::lobes::settings::LobeSettings;
use crate::app::views::sphere::settings::SphereSettings;
use crate::brdf::Model;
use crate::geom::sphere::LIGHT_PRESETS;
use crate::measured::samples::SAMPLES;

/// Goes to a step of a lesson, or ends the lesson where there is no such step.
pub(crate) fn go(state: &mut State, lesson: usize, step: usize) -> Vec<Task> {
    let at = LessonAt {
        lesson,
        step,
        waits: true,
    };
    state.lesson = at.step().map(|_| at);
    perform(state)
}

/// Sets the scene of the step that waits for it, if its material is there; asks for the material if it is not.
pub(crate) fn perform(state: &mut State) -> Vec<Task> {
    let Some(at) = state.lesson.filter(|at| at.waits) else {
        return Vec::new();
    };
    let steps = LESSONS[at.lesson].steps.iter().take(at.step + 1);
    let all: Vec<Set> = steps.flat_map(|step| step.set).copied().collect();
    if let Some(Set::Sample(key)) = all.first() {
        match show_sample(state, key) {
            SampleShown::Yes => {}
            SampleShown::Soon => return Vec::new(),
            SampleShown::After(task) => return vec![*task],
        }
    }
    if let Some(at) = &mut state.lesson {
        at.waits = false;
    }
    state.history.settle(&state.scene);
    let tasks = all
        .iter()
        .flat_map(|set| perform_one(state, *set))
        .collect();
    state.history.settle(&state.scene);
    tasks
}

enum SampleShown {
    Yes,
    Soon,
    After(Box<Task>),
}

fn show_sample(state: &mut State, key: &str) -> SampleShown {
    let Some(index) = SAMPLES.iter().position(|sample| sample.key == key) else {
        return SampleShown::Yes;
    };
    let origin = Origin::Sample(index);
    let open = state.scene.opened.iter().position(|opened| {
        let material = state.materials.get(&opened.id);
        material.is_some_and(|material| material.origin == origin)
    });
    match open {
        Some(position) => {
            edit(state, |scene| scene.selected = position);
            SampleShown::Yes
        }
        None if state
            .jobs
            .iter()
            .any(|job| job.label == SAMPLES[index].name) =>
        {
            SampleShown::Soon
        }
        None => SampleShown::After(Box::new(load(state, origin))),
    }
}

fn perform_one(state: &mut State, set: Set) -> Vec<Task> {
    match set {
        // Done before the others.
        Set::Sample(_) => {}
        Set::Model(key) => {
            if let Some(model) = Model::by_key(key) {
                edit_brdf(state, |brdf| *brdf = brdf.with_model(model));
            }
        }
        Set::Fresnel(fresnel) => edit_brdf(state, |brdf| brdf.fresnel = fresnel),
        Set::Param(id, value) => return set_param(state, id, None, value),
        Set::Angles(degrees, active) => edit(state, |scene| {
            let lobes = scene.views.get_mut::<LobeSettings>();
            lobes.theta_i = degrees.iter().map(|theta| theta.to_radians()).collect();
            lobes.active = active;
        }),
        Set::Scale(scale) => edit(state, |scene| {
            scene.views.get_mut::<LobeSettings>().scale = scale.into();
        }),
        Set::Lights(index) => edit(state, |scene| {
            if let Some(preset) = LIGHT_PRESETS.get(index) {
                scene.views.get_mut::<SphereSettings>().view.lights = (preset.lights)();
            }
        }),
        Set::Sphere(show) => edit(state, |scene| {
            scene.views.get_mut::<SphereSettings>().show = show;
        }),
        Set::View(settings) => edit(state, |scene| scene.views.set(settings())),
        Set::Tile(pane) => state.tiles.show(pane),
        Set::Compare(models, fresnel) => {
            state.prefs.comparison = Comparison::of(models, fresnel);
        }
        Set::Stages(stages, from_sliders) => {
            state.fit.settings = FitSettings {
                stages,
                from_sliders,
                ..FitSettings::default()
            };
        }
    }
    Vec::new()
}
