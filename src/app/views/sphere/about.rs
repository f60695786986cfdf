//! The row of the view "Sphere" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::sphere::settings::SphereSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Sphere,
    key: "sphere",
    name: "Sphere",
    help: [
        "The material on a sphere, lit from far away: data, model, or both.",
        "Drag a highlight to move its light, or the line to compare; the wheel zooms. Double click puts all back.",
        "Point at it to read angles and values in the status bar; a click pins them.",
    ],
    home: Home::Upper,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<SphereSettings>()),
};
