//! The row of the view "Disc" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::disc::settings::DiscSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Disc,
    key: "disc",
    name: "Disc",
    help: [
        "f_r over all view directions under one light, seen from above: the normal in the middle, the horizon at the rim.",
        "Drag to move the light, the wheel zooms the values; double click puts all back. Hatched was not measured.",
        "Point to read values, click to pin. Past the dashed ring θo is beyond 80°.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<DiscSettings>()),
};
