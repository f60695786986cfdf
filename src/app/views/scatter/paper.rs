//! The materials in a figure.

use crate::app::views::on_paper::{PaperView, panel};
use crate::app::views::scatter::rows::rows;
use crate::app::views::scatter::settings::ScatterSettings;
use crate::figure::ViewSpec;
use crate::figure::palette::Role;

/// The view in a figure: every material with a fit of the model, in the colours of the tile as far as paper has them.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let state = subjects.state;
        let mut settings = state.scene.views.get::<ScatterSettings>().clone();
        let rows = rows(state, &settings);
        if settings.shows_error() {
            settings.errors = rows.iter().map(|row| row.error).collect();
        }
        let dots = rows.into_iter().map(|row| {
            let series = match row.dot.ring.unwrap_or(row.dot.fill) {
                Role::Series(series) => series,
                _ => 0,
            };
            subjects.add_model(row.dot.name, series, row.brdf)
        });
        let dots = dots.collect();
        vec![panel(ViewSpec::Scatter(settings), dots)]
    },
    name: |_| vec!["materials_scatter".into()],
};
