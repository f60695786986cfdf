//! The row of the view "Image slice" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::image::settings::ImageSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Image,
    key: "image",
    name: "Image slice",
    help: [
        "f_r over half and difference angle at one φd, cell by cell: data, model, residual or ratio.",
        "Hatched was not measured, blank is below the horizon; past the dashed line light or view is beyond 80°.",
        "Point to read values, click to pin. Drag moves, the wheel zooms, double click shows all.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<ImageSettings>()),
};
