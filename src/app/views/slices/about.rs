//! The row of the view "Slices" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::slices::settings::SliceSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Slices,
    key: "slices",
    name: "Slices",
    help: [
        "f_r over one angle with the others fixed, and what is between model and measurement below.",
        "The wheel zooms the angle, over the numbers at the left or with Ctrl the values; drag to pan, double click resets.",
        "Point to read values, click to pin. \"Follow\" takes the fixed angles from the other views.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<SliceSettings>()),
};
