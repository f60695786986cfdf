//! The row of the view "Ranking" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;
use crate::app::views::ranking::settings::RankingSettings;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Ranking,
    key: "ranking",
    name: "Ranking",
    help: [
        "E of every model over all materials that are open or in the folder, in the order of one model's E.",
        "The legend counts the materials that a model fits best, among those that all shown models are fitted to.",
        "Point at a dot to read it; a click shows that material. Fits with another weight or limit are left out.",
    ],
    home: Home::Upper,
    on_paper: OnPaper::WithFits,
    settings: Some(SettingsKind::of::<RankingSettings>()),
};
