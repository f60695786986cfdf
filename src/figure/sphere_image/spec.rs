//! The settings of a sphere on paper.

use super::SphereSource;
use crate::figure::faults::{Faults, list};
use crate::figure::subject::Source;
use crate::geom::directions::unit;
use crate::geom::sight::{MAX_ZOOM, Sight};
use crate::geom::sphere::{Light, MAX_LIGHTS, SphereView};
use crate::geom::sphere_error::SphereError;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A sphere on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SphereSpec {
    /// Lights and exposure.
    pub view: SphereView,
    /// Content of the sphere.
    pub show: SphereShow,
    /// Place of the line between data and model: −1 at the left rim, 1 at the right.
    pub split: f64,
    /// The part in sight.
    #[serde(skip_serializing_if = "is_all")]
    pub sight: Sight,
}

impl Default for SphereSpec {
    fn default() -> Self {
        Self {
            view: SphereView::default(),
            show: SphereShow::Measured,
            split: 0.0,
            sight: Sight::default(),
        }
    }
}

fn is_all(sight: &Sight) -> bool {
    *sight == Sight::default()
}

/// Content of a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SphereShow {
    /// The data.
    Measured,
    /// The model.
    Model,
    /// Data left of a line, model right of it.
    Split,
    /// Error of the model against the data, as colours.
    Error(SphereError),
}

/// The brightest light.
const STRONGEST: f64 = 1e3;
/// Largest exposure in stops, of either sign: 2 to this power is a number.
const MAX_STOPS: f64 = 1000.0;

/// Brings the settings of a sphere to the nearest that can be drawn. The length of a light's direction means nothing.
pub fn sanitize(view: &mut SphereView, split: &mut f64, sight: &mut Sight, faults: &mut Faults) {
    faults.inside("view", |faults| {
        let lights = &mut view.lights;
        if !(1..=MAX_LIGHTS).contains(&lights.len()) {
            let expected = format!("1 to {MAX_LIGHTS} of them");
            faults.inside("lights", |f| f.add("length", lights.len(), expected));
        }
        lights.truncate(MAX_LIGHTS);
        if lights.is_empty() {
            *lights = SphereView::default().lights;
        }
        faults.inside("lights", |faults| {
            for (position, light) in lights.iter_mut().enumerate() {
                faults.inside(position.to_string(), |faults| sanitize_light(light, faults));
            }
        });
        let stops = &mut view.exposure_stops;
        faults.number("exposure_stops", stops, [-MAX_STOPS, MAX_STOPS]);
    });
    faults.number("split", split, [-1.0, 1.0]);
    faults.inside("sight", |faults| {
        faults.number("zoom", &mut sight.zoom, [1.0, MAX_ZOOM]);
        faults.inside("center", |faults| {
            for (key, at) in ["0", "1"].into_iter().zip(&mut sight.center) {
                faults.number(key, at, [-1.0, 1.0]);
            }
        });
    });
}

fn sanitize_light(light: &mut Light, faults: &mut Faults) {
    light.direction = unit(light.direction).unwrap_or_else(|| {
        let expected = "a vector of a length from 1e-6 to 1e6";
        faults.add("direction", list(&light.direction.to_array()), expected);
        DVec3::Z
    });
    faults.inside("strength", |faults| {
        for (key, channel) in ["0", "1", "2"].into_iter().zip(&mut light.strength) {
            faults.number(key, channel, [0.0, STRONGEST]);
        }
    });
}

impl SphereSpec {
    /// The picture's source. `of` has the measured subject (`true`) and the model (`false`); `None` where one that is
    /// shown is not there.
    pub fn source(&self, of: impl Fn(bool) -> Option<Source>) -> Option<SphereSource> {
        Some(match self.show {
            SphereShow::Measured => SphereSource::One(of(true)?),
            SphereShow::Model => SphereSource::One(of(false)?),
            SphereShow::Split => SphereSource::Split {
                left: of(true)?,
                right: of(false)?,
                at: self.split,
            },
            SphereShow::Error(error) => SphereSource::Compared {
                measured: of(true)?,
                model: of(false)?,
                error,
            },
        })
    }
}
