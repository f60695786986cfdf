//! The settings of a sphere on paper.

use super::SphereSource;
use crate::figure::subject::Source;
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;
use crate::geom::sphere_error::SphereError;
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
