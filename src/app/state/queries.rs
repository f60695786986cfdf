//! Questions about the whole state: what is loading, what is missing, which view is meant.

use crate::app::state::State;
use crate::app::state::about::OnPaper;
use crate::app::state::material::{Material, Presence};
use crate::app::state::session::Missing;
use crate::app::state::views::ViewId;
use crate::app::views::scatter::settings::ScatterSettings;
use crate::brdf::Model;
use crate::files::session;
use std::path::Path;

impl State {
    /// Sentence on the material that is being loaded.
    pub fn loading(&self) -> Option<String> {
        let current = || self.current().map(|(material, _)| material);
        let name = match &self.library.pending {
            Some(pending) => &pending.name,
            None => &current().filter(|material| material.is_loading())?.name,
        };
        Some(format!("Loading {name}…"))
    }

    /// Whether and where a file is open: its position in the scene.
    pub fn position_of_file(&self, path: &Path) -> Option<usize> {
        self.scene.opened.iter().position(|opened| {
            let material = self.materials.get(&opened.id);
            material.and_then(Material::file).as_deref() == Some(path)
        })
    }

    /// The open materials that were not found and not skipped.
    pub fn all_asked_for(&self) -> impl Iterator<Item = &Missing> {
        let lost = |missing: &&Missing| {
            let open = self.scene.opened.iter().any(|one| one.id == missing.id);
            let material = self.materials.get(&missing.id);
            !missing.skipped && open && material.is_some_and(|m| m.presence == Presence::Missing)
        };
        self.session.missing.iter().filter(lost)
    }

    /// The first of them.
    pub fn asked_for(&self) -> Option<&Missing> {
        self.all_asked_for().next()
    }

    /// Title of the window.
    pub fn title(&self) -> String {
        match self.session.files.get(&self.scene.session) {
            Some(file) => format!("{} — Grazing", session::name(file)),
            None => "Grazing".into(),
        }
    }

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
            OnPaper::WithFits => self.fitted_models().next().is_some(),
            OnPaper::WithMaterials => {
                self.has_fits_of(self.scene.views.get::<ScatterSettings>().model)
            }
        }
    }

    /// Whether some material, open or in the folder, has a fit of a model.
    pub fn has_fits_of(&self, model: &Model) -> bool {
        self.fitted_models().any(|fitted| fitted == model)
    }

    /// Models of all fits, of open materials and of the folder's files.
    fn fitted_models(&self) -> impl Iterator<Item = &'static Model> {
        let opened = self.scene.opened.iter();
        let open = opened.filter_map(|opened| self.materials.get(&opened.id));
        let kept = open.flat_map(|material| &material.fits);
        let in_folder = self.library.folder_fits();
        kept.map(|fit| fit.outcome.brdf.model)
            .chain(in_folder.map(|fit| fit.brdf.model))
    }
}
