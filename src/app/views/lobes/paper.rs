//! The polar lobes in a figure.

use crate::app::views::lobes::settings::{LobeSettings, drawable};
use crate::app::views::on_paper::{PaperView, theta_i_word};
use crate::figure::ViewSpec;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let spec = drawable(subjects.state.scene.views.get(), None);
        vec![subjects.plot(ViewSpec::Lobes(spec))]
    },
    name: |naming| {
        let settings = naming.state.scene.views.get::<LobeSettings>();
        let mut words = naming.words(&[theta_i_word(&settings.theta_i)]);
        words.push(settings.scale.key().into());
        words
    },
};
