//! The movable tiles in the middle: a row per view, and where they are.

mod albedo;
mod check;
mod controls;
mod error_map;
mod fits;
mod heat;
mod image;
mod landscape;
mod legend;
mod lobe3d;
pub mod lobe3d_callback;
mod lobes;
mod panes;
mod scatter;
mod slices;
mod slices_bar;
mod sphere;
pub mod sphere_callback;
mod sphere_error;
mod zoom;

pub use panes::{PANES, Pane};
pub use scatter::combined_fits;

use super::lessons::LookAt;
use super::panels::lesson;
use super::paper::PaperMsg;
use super::state::State;
use super::update::Msg;
use egui_tiles::{Behavior, Container, Tile, TileId, Tree, UiResponse};
use panes::Home;
use serde::{Deserialize, Serialize};

/// To be raised when an old layout no longer makes sense; one that cannot be read is forgotten anyway.
const VERSION: u32 = 1;

/// The tiles and where they are. A person moves them by hand, so egui changes this in place while it draws.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Saved", into = "Saved")]
pub struct Tiles(Tree<Pane>);

/// The tiles as they are kept between runs.
#[derive(Serialize, Deserialize)]
struct Saved {
    version: u32,
    tree: Tree<Pane>,
}

impl From<Tiles> for Saved {
    fn from(tiles: Tiles) -> Self {
        Self {
            version: VERSION,
            tree: tiles.0,
        }
    }
}

impl TryFrom<Saved> for Tiles {
    type Error = String;

    fn try_from(saved: Saved) -> Result<Self, String> {
        if saved.version != VERSION {
            return Err(format!("layout version {}", saved.version));
        }
        check::checked(&saved.tree).map(Self)
    }
}

impl Default for Tiles {
    fn default() -> Self {
        let mut tiles = egui_tiles::Tiles::default();
        // The lobes stay in sight under the table of fits: its check boxes draw there.
        let groups = [Home::Upper, Home::Lower].map(|home| {
            let rows = PANES.iter().filter(|row| row.home == home);
            let panes = rows.map(|row| tiles.insert_pane(row.pane)).collect();
            tiles.insert_tab_tile(panes)
        });
        let root = tiles.insert_vertical_tile(groups.to_vec());
        Self(Tree::new(tree_id(), root, tiles))
    }
}

fn tree_id() -> egui::Id {
    egui::Id::unique("tiles")
}

impl Tiles {
    /// No tile at all.
    pub fn none() -> Self {
        Self(Tree::empty(tree_id()))
    }

    /// Every tile in sight at once.
    pub fn side_by_side() -> Self {
        let panes = PANES.iter().map(|row| row.pane).collect();
        Self(Tree::new_grid(tree_id(), panes))
    }

    /// Whether a tile is open, in front or behind another one.
    pub fn is_open(&self, pane: Pane) -> bool {
        self.0.tiles.find_pane(&pane).is_some()
    }

    /// Opens a tile where it is closed, and brings it to the front.
    pub fn show(&mut self, pane: Pane) {
        if !self.is_open(pane) {
            self.open(pane);
        }
        self.0
            .make_active(|_, tile| matches!(tile, Tile::Pane(other) if *other == pane));
    }

    /// Closes an open tile, opens a closed one.
    pub fn toggle(&mut self, pane: Pane) {
        match self.0.tiles.find_pane(&pane) {
            Some(id) => {
                self.0.remove_recursively(id);
            }
            None => self.show(pane),
        }
    }

    /// Adds a tile behind one that is at home where it is, else below all.
    fn open(&mut self, pane: Pane) {
        let id = self.0.tiles.insert_pane(pane);
        let neighbors = PANES.iter().filter(|row| row.home == pane.row().home);
        let group = neighbors
            .filter_map(|row| self.0.tiles.find_pane(&row.pane))
            .filter(|neighbor| *neighbor != id)
            .filter_map(|neighbor| self.0.tiles.parent_of(neighbor))
            .find(|parent| {
                let tile = self.0.tiles.get(*parent);
                matches!(tile, Some(Tile::Container(Container::Tabs(_))))
            });
        if let Some(Tile::Container(group)) = group.and_then(|group| self.0.tiles.get_mut(group)) {
            group.add_child(id);
            return;
        }
        let tab = self.0.tiles.insert_tab_tile(vec![id]);
        let root = match self.0.root {
            Some(root) => self.0.tiles.insert_vertical_tile(vec![root, tab]),
            None => tab,
        };
        self.0.root = Some(root);
    }

    /// Draws them. What no view has under the pointer is under no probe.
    pub fn ui(&mut self, ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
        if self.0.is_empty() {
            ui.centered_and_justified(|ui| {
                ui.weak("All tiles are closed. View > Reset layout brings them back.");
            });
        }
        let (probed, pointed) = (&mut false, &mut None);
        let mut view = View {
            state,
            out,
            probed,
            pointed,
        };
        self.0.ui(&mut view, ui);
        if *pointed != state.views.pointed {
            out.push(Msg::Paper(PaperMsg::Point(*pointed)));
        }
        if !*probed && state.hovered.is_some() {
            out.push(Msg::Hover(None));
        }
    }
}

struct View<'a> {
    state: &'a State,
    out: &'a mut Vec<Msg>,
    probed: &'a mut bool,
    /// The view that the pointer is on.
    pointed: &'a mut Option<Pane>,
}

impl Behavior<Pane> for View<'_> {
    fn pane_ui(&mut self, ui: &mut egui::Ui, _id: TileId, pane: &mut Pane) -> UiResponse {
        if ui.rect_contains_pointer(ui.max_rect()) {
            *self.pointed = Some(*pane);
        }
        egui::Frame::new().inner_margin(8.0).show(ui, |ui| {
            // Two tiles may have one kind of control.
            ui.push_id(pane.row().key, |ui| {
                *self.probed |= (pane.row().ui)(ui, self.state, self.out);
            });
            if self.state.looks_at(LookAt::Tile(*pane)) {
                lesson::frame(ui, ui.max_rect().expand(6.0));
            }
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> egui::WidgetText {
        pane.row().name.into()
    }

    fn is_tab_closable(&self, _tiles: &egui_tiles::Tiles<Pane>, _id: TileId) -> bool {
        true
    }

    fn top_bar_right_ui(
        &mut self,
        tiles: &egui_tiles::Tiles<Pane>,
        ui: &mut egui::Ui,
        _id: TileId,
        tabs: &egui_tiles::Tabs,
        _scroll_offset: &mut f32,
    ) {
        let Some(pane) = tabs.active.and_then(|id| tiles.get_pane(&id)) else {
            return;
        };
        let row = pane.row();
        ui.add_space(8.0);
        let response = ui.add(egui::Button::new("?").frame(false));
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Help: {}", row.name))
        });
        egui::Popup::from_toggle_button_response(&response).show(|ui| {
            ui.set_max_width(340.0);
            ui.strong(row.name);
            for line in row.help {
                ui.label(line);
            }
        });
    }

    fn simplification_options(&self) -> egui_tiles::SimplificationOptions {
        egui_tiles::SimplificationOptions {
            // A tab gives every tile its name and a handle to move it by.
            all_panes_must_have_tabs: true,
            ..Default::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Keeps what eframe does between two runs.
    #[derive(Default)]
    struct Kept(std::collections::BTreeMap<String, String>);

    impl eframe::Storage for Kept {
        fn get_string(&self, key: &str) -> Option<String> {
            self.0.get(key).cloned()
        }

        fn set_string(&mut self, key: &str, value: String) {
            self.0.insert(key.into(), value);
        }

        fn remove_string(&mut self, key: &str) {
            self.0.remove(key);
        }

        fn flush(&mut self) {}
    }

    #[test]
    fn a_layout_outlives_the_window_and_a_broken_one_is_forgotten() {
        let mut kept = Kept::default();
        let read = |kept: &Kept| eframe::get_value::<Tiles>(kept, "layout");
        for mut tiles in [Tiles::default(), Tiles::side_by_side(), Tiles::none()] {
            tiles.show(Pane::Slices);
            tiles.toggle(Pane::Lobe3d);
            eframe::set_value(&mut kept, "layout", &tiles);
            assert_eq!(read(&kept), Some(tiles));
        }
        let text = kept.0["layout"].clone();
        for broken in [
            text.replace("version:1", "version:9"),
            text.replace("Slices", "Cube"),
            text[..text.len() / 2].to_string(),
            String::new(),
        ] {
            assert_ne!(broken, text);
            kept.0.insert("layout".into(), broken);
            assert_eq!(read(&kept), None);
        }
    }

    #[test]
    fn a_closed_tile_comes_back_to_its_group_or_to_an_empty_window() {
        for mut tiles in [Tiles::default(), Tiles::none()] {
            for row in PANES {
                tiles.show(row.pane);
            }
            assert!(PANES.iter().all(|row| tiles.is_open(row.pane)));
            for row in PANES {
                tiles.toggle(row.pane);
            }
            assert!(!PANES.iter().any(|row| tiles.is_open(row.pane)));
        }
    }
}
