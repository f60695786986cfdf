//! The row of the view "Error landscape" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::landscape::settings::LandscapeSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Landscape,
    key: "landscape",
    name: "Error landscape",
    help: [
        "The least E that the combined model has at each s and α, with ρd and ks solved there; below is Phong, above Blinn-Phong.",
        "Line: the way of the last fit from its ring. Dot: the sliders. Diamond: the best. E is estimated on some of the cells.",
        "A click takes what is under the pointer. Drag moves, the wheel zooms, double click shows all.",
    ],
    home: Home::Upper,
    on_paper: OnPaper::WithData,
    settings: Some(SettingsKind::of::<LandscapeSettings>()),
};
