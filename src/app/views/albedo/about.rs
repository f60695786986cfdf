//! The row of the view "Albedo" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::albedo::settings::AlbedoSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Albedo,
    key: "albedo",
    name: "Albedo",
    help: [
        "The share of the light from one angle that comes back, over all view directions; more than 1 is marked.",
        "Of a measurement it is the sum over what was measured; the dotted line says which share that is.",
        "Point to read values, click to pin. The wheel zooms, double click resets.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<AlbedoSettings>()),
};
