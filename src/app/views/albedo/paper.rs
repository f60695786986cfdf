//! The albedo plot in a figure.

use crate::app::views::albedo::settings::AlbedoSettings;
use crate::app::views::on_paper::PaperView;
use crate::figure::ViewSpec;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let settings = subjects.state.scene.views.get::<AlbedoSettings>();
        vec![subjects.plot(ViewSpec::Albedo(settings.spec.clone()))]
    },
    name: |naming| naming.words(&[]),
};
