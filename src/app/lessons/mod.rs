//! Guided lessons: each a text of a few steps that sets the scene and says what to look at.
//!
//! Lessons are data ([`LESSONS`]). A step is performed on top of the steps before it, so that going back shows what was
//! there whatever the learner has dragged since. All of it are ordinary edits: undo takes them back too.

mod rows;

pub use rows::LESSONS;

use super::fitting::Settings;
use super::state::{Origin, Show, State};
use super::tiles::Pane;
use super::update::{Msg, Task, apply, edit, edit_brdf, load};
use crate::brdf::{Fresnel, Model, ParamId};
use crate::figure::RadialScale;
use crate::geom::sphere::LIGHT_PRESETS;
use crate::measured::samples::SAMPLES;

/// A lesson.
#[derive(Debug)]
pub struct Lesson {
    /// Name in the menu.
    pub title: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// From three to six.
    pub steps: &'static [Step],
}

/// A step of a lesson.
#[derive(Debug)]
pub struct Step {
    /// A few sentences, in the markup of [`crate::figure::text`].
    pub text: &'static str,
    /// What is set when it begins.
    pub set: &'static [Set],
    /// What is framed.
    pub look_at: LookAt,
}

/// A thing that a step sets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Set {
    /// Show this synthetic material, by its key; the first thing a lesson does.
    Sample(&'static str),
    /// Use this model, by its key.
    Model(&'static str),
    /// Use this Fresnel factor.
    Fresnel(Fresnel),
    /// Give all channels of a parameter this value.
    Param(ParamId, f64),
    /// Draw lobes at these angles of incidence in degrees; the one at the position is active.
    Angles(&'static [f64], usize),
    /// Scale of the lobes.
    Scale(RadialScale),
    /// A set of lights, by position.
    Lights(usize),
    /// What the sphere shows.
    Sphere(Show),
    /// Bring a tile to the front.
    Tile(Pane),
    /// Which stages the next fit runs, and whether it begins at the sliders.
    Stages([bool; 4], bool),
}

/// What a step frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LookAt {
    /// A tile.
    Tile(Pane),
    /// The slider of a parameter.
    Param(ParamId),
    /// The models and the formula.
    Model,
    /// The panel of the fit.
    Fit,
}

/// Where a learner is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LessonAt {
    /// Position in [`LESSONS`].
    pub lesson: usize,
    /// Position in its steps.
    pub step: usize,
    /// Whether the step's scene is still to be set, as its material is being made.
    pub waits: bool,
}

impl LessonAt {
    /// The step.
    pub fn step(self) -> Option<&'static Step> {
        LESSONS.get(self.lesson)?.steps.get(self.step)
    }
}

impl State {
    /// Whether the lesson frames this.
    pub fn looks_at(&self, what: LookAt) -> bool {
        let step = self.lesson.and_then(LessonAt::step);
        step.is_some_and(|step| step.look_at == what)
    }
}

/// Goes to a step of a lesson, or ends the lesson where there is no such step.
pub(super) fn go(state: &mut State, lesson: usize, step: usize) -> Vec<Task> {
    let at = LessonAt {
        lesson,
        step,
        waits: true,
    };
    state.lesson = at.step().map(|_| at);
    perform(state)
}

/// Sets the scene of the step that waits for it, if its material is there; asks for the material if it is not.
pub(super) fn perform(state: &mut State) -> Vec<Task> {
    let Some(at) = state.lesson.filter(|at| at.waits) else {
        return Vec::new();
    };
    let steps = LESSONS[at.lesson].steps.iter().take(at.step + 1);
    let all: Vec<Set> = steps.flat_map(|step| step.set).copied().collect();
    if let Some(Set::Sample(key)) = all.first() {
        match show_sample(state, key) {
            Shown::Yes => {}
            Shown::Soon => return Vec::new(),
            Shown::After(task) => return vec![*task],
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

enum Shown {
    Yes,
    Soon,
    After(Box<Task>),
}

fn show_sample(state: &mut State, key: &str) -> Shown {
    let Some(index) = SAMPLES.iter().position(|sample| sample.key == key) else {
        return Shown::Yes;
    };
    let origin = Origin::Sample(index);
    let open = state.scene.opened.iter().position(|opened| {
        let material = state.materials.get(&opened.id);
        material.is_some_and(|material| material.origin == origin)
    });
    match open {
        Some(position) => {
            edit(state, |scene| scene.selected = position);
            Shown::Yes
        }
        None if state
            .jobs
            .iter()
            .any(|job| job.label == SAMPLES[index].name) =>
        {
            Shown::Soon
        }
        None => Shown::After(Box::new(load(state, origin))),
    }
}

fn perform_one(state: &mut State, set: Set) -> Vec<Task> {
    match set {
        // Done before the others.
        Set::Sample(_) => {}
        Set::Model(key) => {
            if let Some(model) = Model::by_key(key) {
                edit_brdf(state, |brdf| brdf.model = model);
            }
        }
        Set::Fresnel(fresnel) => edit_brdf(state, |brdf| brdf.fresnel = fresnel),
        Set::Param(id, value) => {
            let channel = None;
            return apply(state, Msg::SetParam { id, channel, value });
        }
        Set::Angles(degrees, active) => edit(state, |scene| {
            scene.lobes.theta_i = degrees.iter().map(|theta| theta.to_radians()).collect();
            scene.lobes.active = active;
        }),
        Set::Scale(scale) => edit(state, |scene| scene.lobes.scale = scale),
        Set::Lights(index) => edit(state, |scene| {
            if let Some(preset) = LIGHT_PRESETS.get(index) {
                scene.sphere.view.lights = (preset.lights)();
            }
        }),
        Set::Sphere(show) => edit(state, |scene| scene.sphere.show = show),
        Set::Tile(pane) => state.tiles.show(pane),
        Set::Stages(stages, from_sliders) => {
            state.fit.settings = Settings {
                stages,
                from_sliders,
                ..Settings::default()
            };
        }
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lessons_are_short_and_name_what_there_is() {
        assert!(LESSONS.len() >= 4);
        for lesson in &LESSONS {
            assert!((3..=6).contains(&lesson.steps.len()), "{}", lesson.title);
            let first = lesson.steps[0].set.first();
            assert!(matches!(first, Some(Set::Sample(_))), "{}", lesson.title);
            for step in lesson.steps {
                assert!(step.text.len() < 420, "{}", step.text);
                for set in step.set {
                    match set {
                        Set::Sample(key) => assert!(SAMPLES.iter().any(|s| s.key == *key)),
                        Set::Model(key) => assert!(Model::by_key(key).is_some()),
                        Set::Lights(index) => assert!(*index < LIGHT_PRESETS.len()),
                        Set::Angles(angles, active) => assert!(*active < angles.len()),
                        _ => {}
                    }
                }
            }
        }
    }
}
