//! The ranking in a figure.

use crate::app::views::on_paper::{PaperView, panel};
use crate::app::views::ranking::rows::rows;
use crate::app::views::ranking::settings::RankingSettings;
use crate::figure::ViewSpec;

/// The view in a figure: the errors of the tile, which the figure holds itself.
pub const ON_PAPER: PaperView = PaperView {
    panels: |subjects| {
        let state = subjects.state;
        let view = state.scene.views.get::<RankingSettings>();
        vec![panel(ViewSpec::Ranking(rows(state, view).spec), Vec::new())]
    },
    name: |_| vec!["models_ranking".into()],
};
