//! The movable tiles in the middle.

mod fits;
mod lobes;
mod sphere;
pub mod sphere_callback;

use super::state::State;
use super::update::Msg;
use egui_tiles::{Behavior, TileId, Tree, UiResponse};
use serde::{Deserialize, Serialize};

/// A kind of tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Pane {
    Sphere,
    Fits,
    Lobes,
}

/// The tiles and where they are.
pub struct Tiles(Tree<Pane>);

impl Default for Tiles {
    fn default() -> Self {
        let mut tiles = egui_tiles::Tiles::default();
        // The lobes stay in sight under the table: its check boxes draw there.
        let [sphere, fits, lobes] =
            [Pane::Sphere, Pane::Fits, Pane::Lobes].map(|pane| tiles.insert_pane(pane));
        let upper = tiles.insert_tab_tile(vec![sphere, fits]);
        let root = tiles.insert_vertical_tile(vec![upper, lobes]);
        Self(Tree::new(egui::Id::unique("tiles"), root, tiles))
    }
}

impl Tiles {
    /// No tile at all.
    pub fn none() -> Self {
        Self(Tree::empty(egui::Id::unique("tiles")))
    }

    /// Brings the table of fits to the front.
    pub fn show_fits(&mut self) {
        self.0
            .make_active(|_, tile| matches!(tile, egui_tiles::Tile::Pane(Pane::Fits)));
    }

    /// Draws them.
    pub fn ui(&mut self, ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
        self.0.ui(&mut View { state, out }, ui);
    }
}

struct View<'a> {
    state: &'a State,
    out: &'a mut Vec<Msg>,
}

impl Behavior<Pane> for View<'_> {
    fn pane_ui(&mut self, ui: &mut egui::Ui, _id: TileId, pane: &mut Pane) -> UiResponse {
        egui::Frame::new()
            .inner_margin(8.0)
            .show(ui, |ui| match pane {
                Pane::Sphere => sphere::sphere_ui(ui, self.state, self.out),
                Pane::Fits => fits::fits_ui(ui, self.state, self.out),
                Pane::Lobes => lobes::lobes_ui(ui, self.state, self.out),
            });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> egui::WidgetText {
        match pane {
            Pane::Sphere => "Sphere",
            Pane::Fits => "Fits",
            Pane::Lobes => "Polar lobes",
        }
        .into()
    }

    fn simplification_options(&self) -> egui_tiles::SimplificationOptions {
        egui_tiles::SimplificationOptions {
            // A tab gives every tile its name and a handle to move it by.
            all_panes_must_have_tabs: true,
            ..Default::default()
        }
    }
}
