//! The error map in a figure, with the weight and the limit of the fit.

use crate::app::views::error_map::settings::ErrorMapSettings;
use crate::app::views::on_paper::PaperView;
use crate::figure::ViewSpec;
use crate::figure::error_map::ErrorMapSpec;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let view = subjects.state.scene.views.get::<ErrorMapSettings>();
        let fit = &subjects.state.fit.settings;
        vec![subjects.picture(ViewSpec::ErrorMap(ErrorMapSpec {
            plane: view.plane,
            scale: view.scale,
            view: view.view,
            weight: fit.weight.key().into(),
            limit: fit.limit,
        }))]
    },
    name: |naming| naming.words(&[]),
};
