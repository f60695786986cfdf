//! Guided lessons: each a text of a few steps that sets the scene and says what to look at.
//!
//! Lessons are data ([`LESSONS`]). A step is performed on top of the steps before it, so that going back shows what was
//! there whatever the learner has dragged since. All of it are ordinary edits: undo takes them back too.

mod five_models;
pub mod rows;

use crate::app::lessons::rows::LESSONS;
use crate::app::state::State;
use crate::app::state::lesson::LessonAt;
use crate::app::state::view_settings::AnySettings;
use crate::app::state::views::ViewId;
use crate::app::views::sphere::settings::Show;
use crate::brdf::{Fresnel, ParamId};
use crate::figure::RadialScale;
use crate::fit::StageSet;

/// A lesson.
#[derive(Debug)]
pub struct Lesson {
    /// Name in the menu.
    pub title: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// Steps in order, from three to six.
    pub steps: &'static [LessonStep],
}

/// A step of a lesson.
#[derive(Debug)]
pub struct LessonStep {
    /// A few sentences, in the markup of [`crate::figure::text`].
    pub text: &'static str,
    /// Settings made when the step begins.
    pub set: &'static [Set],
    /// Part of the window that is framed.
    pub look_at: LookAt,
}

/// A thing that a step sets.
#[derive(Clone, Copy, Debug)]
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
    /// Content of the sphere.
    Sphere(Show),
    /// Set a view to these settings.
    View(fn() -> AnySettings),
    /// Bring a tile to the front.
    Tile(ViewId),
    /// Models to compare, by their keys, with this Fresnel factor.
    Compare(&'static [&'static str], Fresnel),
    /// Stages of the next fit, and whether it begins at the sliders.
    Stages(StageSet, bool),
}

/// Part of the window that a step frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LookAt {
    /// A tile.
    Tile(ViewId),
    /// The slider of a parameter.
    Param(ParamId),
    /// The models and the formula.
    Model,
    /// The panel of the fit.
    Fit,
}

impl LessonAt {
    /// The step.
    pub fn step(self) -> Option<&'static LessonStep> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::Model;
    use crate::geom::sphere::LIGHT_PRESETS;
    use crate::measured::samples::SAMPLES;

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
                        Set::Compare(keys, _) => {
                            assert!(keys.iter().all(|key| Model::by_key(key).is_some()));
                        }
                        Set::Lights(index) => assert!(*index < LIGHT_PRESETS.len()),
                        Set::Angles(angles, active) => assert!(*active < angles.len()),
                        _ => {}
                    }
                }
            }
        }
    }
}
