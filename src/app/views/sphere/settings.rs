//! Settings of the sphere.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::faults::Faults;
use crate::figure::sphere_image::sanitize;
use crate::geom::limits::MAX_EXPOSURE_STOPS;
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;
use crate::geom::sphere_error::SphereError;
use serde::{Deserialize, Serialize};

/// Content of the sphere.
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

/// Settings of the sphere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SphereSettings {
    /// Lights and exposure.
    pub view: SphereView,
    /// Measured, model or both.
    pub show: Show,
    /// Place of the split line: −1 at the left rim, 1 at the right.
    pub split: f64,
    /// Part of it in sight.
    pub sight: Sight,
}

impl Default for SphereSettings {
    fn default() -> Self {
        Self {
            view: SphereView::default(),
            show: Show::Split,
            split: 0.0,
            sight: Sight::default(),
        }
    }
}

impl Settings for SphereSettings {
    const VIEW: ViewId = ViewId::Sphere;

    fn sanitized(mut self) -> Self {
        let Self {
            view, split, sight, ..
        } = &mut self;
        sanitize(view, split, sight, &mut Faults::default());
        view.exposure_stops = view
            .exposure_stops
            .clamp(-MAX_EXPOSURE_STOPS, MAX_EXPOSURE_STOPS);
        // The whole sphere is in the middle.
        *sight = sight.zoomed(1.0, sight.center);
        self
    }
}
