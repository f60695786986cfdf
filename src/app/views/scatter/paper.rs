//! The materials in a figure.

use crate::app::views::on_paper::{PaperView, panel};
use crate::app::views::scatter::combined_fits;
use crate::app::views::scatter::settings::ScatterSettings;
use crate::figure::ViewSpec;
use crate::figure::palette::Role;

/// The view in a figure: every material with a combined fit, in the colours of the tile as far as paper has them.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let state = subjects.state;
        let fits = combined_fits(state).into_iter();
        let dots = fits.map(|(name, brdf, role)| {
            let series = match role {
                Role::Series(series) => series,
                _ => 0,
            };
            subjects.add_model(name, series, brdf)
        });
        let dots = dots.collect();
        let settings = *state.scene.views.get::<ScatterSettings>();
        vec![panel(ViewSpec::Scatter(settings), dots)]
    },
    name: |_| vec!["materials_scatter".into()],
};
