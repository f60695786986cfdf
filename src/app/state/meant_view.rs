//! The view that commands and figures are about.

use crate::app::state::State;
use crate::app::state::views::{OnPaper, ViewId};
use crate::brdf::{Brdf, ParamId};

impl State {
    /// The view that is meant by a command: the one under the pointer, else the last one that can be drawn.
    pub fn meant_view(&self) -> Option<ViewId> {
        let drawn = |pane: &ViewId| self.can_draw(*pane);
        let views = &self.views;
        views.pointed.or(views.last).filter(drawn).or_else(|| {
            let front = [ViewId::Lobes, ViewId::Sphere, ViewId::Slices];
            front.into_iter().find(drawn)
        })
    }

    /// Whether a figure can show a view now.
    pub fn can_draw(&self, view: ViewId) -> bool {
        let Some((material, _)) = self.current() else {
            return false;
        };
        match view.about().on_paper {
            OnPaper::Never => false,
            OnPaper::Always => true,
            OnPaper::WithData => material.table.valid_count() > 0,
            OnPaper::WithCombinedFits => self.has_combined_fits(),
        }
    }

    /// Whether some material, open or in the folder, has a fit of the combined model.
    fn has_combined_fits(&self) -> bool {
        let combined = |brdf: &Brdf| brdf.uses(ParamId::Alpha);
        let open = self
            .scene
            .opened
            .iter()
            .filter_map(|opened| self.materials.get(&opened.id));
        let mut kept = open.flat_map(|material| &material.fits);
        kept.any(|fit| combined(&fit.outcome.brdf))
            || self.library.folder_fits().any(|fit| combined(&fit.brdf))
    }
}
