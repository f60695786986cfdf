//! The slices in a figure.

use crate::app::views::on_paper::{PaperView, theta_i_word};
use crate::app::views::slices::settings::{SliceSettings, through};
use crate::figure::ViewSpec;
use crate::figure::slices::Over;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let view = subjects.state.scene.views.get::<SliceSettings>();
        let probe = subjects.state.probe().filter(|_| view.follow);
        let spec = probe.map_or_else(|| view.spec.clone(), |probe| through(&view.spec, probe));
        vec![subjects.plot(ViewSpec::Slices(spec))]
    },
    name: |naming| {
        let spec = &naming.state.scene.views.get::<SliceSettings>().spec;
        let mut words = naming.words(&[match spec.over {
            Over::ThetaO => theta_i_word(&spec.theta_i),
            over => over.key().into(),
        }]);
        words.push(spec.scale.key().into());
        words
    },
};
