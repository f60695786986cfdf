//! The image slice in a figure.

use crate::app::views::image::settings::ImageSettings;
use crate::app::views::on_paper::PaperView;
use crate::figure::ViewSpec;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let settings = subjects.state.scene.views.get::<ImageSettings>();
        vec![subjects.picture(ViewSpec::ImageSlice(settings.clone()))]
    },
    name: |naming| {
        let settings = naming.state.scene.views.get::<ImageSettings>();
        let phi_d = format!("phd{:.0}", settings.phi_d.to_degrees());
        let mut words = naming.words(&[phi_d, settings.shown.key().into()]);
        words.push(settings.scale.key().into());
        words
    },
};
