//! The row of the view "Materials" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::scatter::settings::ScatterSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Scatter,
    key: "scatter",
    name: "Materials",
    help: [
        "Every material with a fit of a model, by two of its parameters or E; at first α over s of the combined model.",
        "At α = 0 a material is Phong-like, at α = 1 Blinn-Phong-like. Open ones have a ring.",
        "Point to read a name and its numbers; a click shows that material. The wheel zooms, over an axis that one alone; double click shows all.",
    ],
    home: Home::Upper,
    on_paper: OnPaper::WithMaterials,
    settings: Some(SettingsKind::of::<ScatterSettings>()),
};
