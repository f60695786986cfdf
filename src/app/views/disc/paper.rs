//! The disc in a figure.

use crate::app::views::disc::settings::DiscSettings;
use crate::app::views::on_paper::{PaperView, theta_i_word};
use crate::figure::ViewSpec;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let settings = subjects.state.scene.views.get::<DiscSettings>();
        vec![subjects.picture(ViewSpec::Disc(settings.clone()))]
    },
    name: |naming| {
        let settings = naming.state.scene.views.get::<DiscSettings>();
        let mut words = naming.words(&[
            theta_i_word(&[settings.theta_i]),
            settings.shown.key().into(),
        ]);
        words.push(settings.scale.key().into());
        words
    },
};
