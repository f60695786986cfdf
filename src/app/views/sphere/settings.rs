//! Settings of the sphere.

use crate::app::views::sphere::sight::Sight;
use crate::geom::sphere::SphereView;
use crate::geom::sphere_error::SphereError;
use serde::{Deserialize, Serialize};

/// Which parts of the picture the sphere shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Show {
    /// The data.
    Measured,
    /// The model.
    Model,
    /// Data left of a line, model right of it.
    Split,
    /// Two spheres.
    SideBySide,
    /// Data and model split by a line, and beside it how far they are apart.
    Error(SphereError),
}

/// All ways to show the sphere, in the order offered.
pub const SHOWS: [Show; 6] = [
    Show::Measured,
    Show::Model,
    Show::Split,
    Show::SideBySide,
    Show::Error(SphereError::Difference),
    Show::Error(SphereError::Ratio),
];

impl Show {
    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Measured => "Measured",
            Self::Model => "Model",
            Self::Split => "Split",
            Self::SideBySide => "Side by side",
            Self::Error(SphereError::Difference) => "Difference",
            Self::Error(SphereError::Ratio) => "Ratio",
        }
    }
}

/// What the sphere tile shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SphereTile {
    /// Lights and exposure.
    pub view: SphereView,
    /// Measured, model or both.
    pub show: Show,
    /// Where the split line is: −1 at the left rim, 1 at the right.
    pub split: f64,
    /// What of it is in sight.
    #[serde(default)]
    pub sight: Sight,
}
