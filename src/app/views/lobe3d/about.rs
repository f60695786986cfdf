//! The row of the view "3D lobe" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::lobe3d::settings::Lobe3dSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Lobe3d,
    key: "lobe3d",
    name: "3D lobe",
    help: [
        "f_r over all view directions for one angle of incidence: data as a solid, models as wire.",
        "Drag to turn it, wheel to zoom, double click puts the view back.",
        "The light is that of the probe. Point at the lobe to read values, click to pin.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<Lobe3dSettings>()),
};
