//! The row of the view "Fits" in the table of views.

use crate::app::state::about::{About, Home, OnPaper};
use crate::app::state::view_id::ViewId;

/// Identity, words, place and settings of the view.
pub const ABOUT: About = About {
    id: ViewId::Fits,
    key: "fits",
    name: "Fits",
    help: [
        "Every fit of this material, the best first; E is the share of misplaced reflection.",
        "A click on a row shows that model.",
        "A tick draws it beside the model in the plots.",
    ],
    home: Home::Upper,
    on_paper: OnPaper::Never,
    settings: None,
};
