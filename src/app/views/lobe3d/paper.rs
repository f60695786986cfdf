//! The 3D lobe in a figure.

use crate::app::views::lobe3d::settings::Lobe3dSettings;
use crate::app::views::on_paper::{PaperView, theta_i_word};
use crate::figure::ViewSpec;
use crate::figure::lobe3d::Lobe3dSpec;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let view = subjects.state.scene.views.get::<Lobe3dSettings>();
        let probe = subjects.state.probe();
        let spec = Lobe3dSpec {
            theta_i: probe.map_or(view.theta_i, |probe| probe.theta_i()),
            ..*view
        };
        vec![subjects.plot(ViewSpec::Lobe3d(spec))]
    },
    name: |naming| {
        let settings = naming.state.scene.views.get::<Lobe3dSettings>();
        let mut words = naming.words(&[theta_i_word(&[settings.theta_i])]);
        words.push(settings.scale.key().into());
        words
    },
};
