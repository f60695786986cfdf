//! The row of the view "Polar lobes" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::lobes::settings::LobeSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Lobes,
    key: "lobes",
    name: "Polar lobes",
    help: [
        "f_r over the view angle in the plane of incidence: a curve per angle of incidence.",
        "Light comes from the left. Drag a handle on the rim to move it, the wheel zooms; double click puts all back.",
        "Point to read values, click to pin. A click on a name hides it, a double click shows it alone.",
    ],
    home: Home::Lower,
    on_paper: OnPaper::Always,
    settings: Some(SettingsKind::of::<LobeSettings>()),
};
