//! The sphere in a figure: two panels where it shows two spheres.

use crate::app::views::on_paper::PaperView;
use crate::app::views::sphere::settings::{Show, SphereSettings};
use crate::figure::ViewSpec;
use crate::figure::sphere_image::{SphereShow, SphereSpec};

/// The view in a figure.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let settings = subjects.state.scene.views.get::<SphereSettings>();
        let shows = match settings.show {
            Show::Measured => vec![SphereShow::Measured],
            Show::Model => vec![SphereShow::Model],
            Show::Split => vec![SphereShow::Split],
            Show::SideBySide => vec![SphereShow::Measured, SphereShow::Model],
            Show::Error(error) => vec![SphereShow::Split, SphereShow::Error(error)],
        };
        let sphere = |show| {
            subjects.picture(ViewSpec::Sphere(SphereSpec {
                view: settings.view.clone(),
                show,
                split: settings.split,
                sight: settings.sight,
            }))
        };
        shows.into_iter().map(sphere).collect()
    },
    name: |naming| naming.words(&[]),
};
