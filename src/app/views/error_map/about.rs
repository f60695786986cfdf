//! The row of the view "Error map" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::error_map::settings::ErrorMapSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::ErrorMap,
    key: "error-map",
    name: "Error map",
    help: [
        "Where the E of the model comes from: its share in each direction, with the weight and limit of the fit.",
        "The shares add up to all of E. Swapped light and view are the same, so each counts half.",
        "Point to read shares, click to pin. Drag moves, the wheel zooms, double click shows all.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::WithData,
    settings: Some(SettingsKind::of::<ErrorMapSettings>()),
};
