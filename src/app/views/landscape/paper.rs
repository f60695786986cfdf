//! The error landscape in a figure, with the weight, the limit and the way of the fit.

use crate::app::views::landscape::settings::LandscapeSettings;
use crate::app::views::landscape::work::path;
use crate::app::views::on_paper::PaperView;
use crate::brdf::Fresnel;
use crate::figure::ViewSpec;
use crate::figure::landscape::LandscapePanel;
use crate::fit::landscape::place;

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let (brdf, state) = (subjects.opened.brdf, subjects.state);
        let (view, fit) = (
            state.scene.views.get::<LandscapeSettings>(),
            &state.fit.settings,
        );
        let solved = view.solve_eta && brdf.fresnel != Fresnel::None;
        vec![subjects.picture(ViewSpec::Landscape(LandscapePanel {
            fresnel: brdf.fresnel,
            eta: (!solved).then_some(brdf.params.eta),
            weight: fit.weight.key().into(),
            limit: fit.limit,
            path: path(state),
            here: Some(place(&brdf)),
            view: view.view,
        }))]
    },
    name: |naming| naming.words(&[]),
};
