//! The tiles and where they are.

use crate::app::state::about::Home;
use crate::app::state::layout_check::{checked, tree_id};
use crate::app::state::views::{VIEWS, ViewId};
use egui_tiles::{Container, Tile, Tree};
use serde::{Deserialize, Serialize};

/// Version of the layout, to be raised when an old one makes no sense; one that cannot be read is forgotten anyway.
const VERSION: u32 = 1;

/// The tiles and where they are. A person moves them by hand.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "SavedTiles", into = "SavedTiles")]
pub struct Tiles(Tree<ViewId>);

/// The tiles as they are kept between runs.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Saved")]
struct SavedTiles {
    version: u32,
    tree: Tree<ViewId>,
}

impl From<Tiles> for SavedTiles {
    fn from(tiles: Tiles) -> Self {
        Self {
            version: VERSION,
            tree: tiles.0,
        }
    }
}

impl TryFrom<SavedTiles> for Tiles {
    type Error = String;

    fn try_from(saved: SavedTiles) -> Result<Self, String> {
        if saved.version != VERSION {
            return Err(format!("layout version {}", saved.version));
        }
        checked(&saved.tree).map(Self)
    }
}

impl Default for Tiles {
    fn default() -> Self {
        let mut tiles = egui_tiles::Tiles::default();
        // The lobes stay in sight under the table of fits: its check boxes draw there.
        let groups = [Home::Upper, Home::Lower].map(|home| {
            let rows = VIEWS.iter().filter(|row| row.home == home);
            let panes = rows.map(|row| tiles.insert_pane(row.id)).collect();
            tiles.insert_tab_tile(panes)
        });
        let root = tiles.insert_vertical_tile(groups.to_vec());
        Self(Tree::new(tree_id(), root, tiles))
    }
}

impl Tiles {
    /// No tile at all.
    pub fn none() -> Self {
        Self(Tree::empty(tree_id()))
    }

    /// Layout with every tile in sight at once.
    pub fn side_by_side() -> Self {
        let panes = VIEWS.iter().map(|row| row.id).collect();
        Self(Tree::new_grid(tree_id(), panes))
    }

    /// Whether a tile is open, in front or behind another one.
    pub fn is_open(&self, pane: ViewId) -> bool {
        self.0.tiles.find_pane(&pane).is_some()
    }

    /// Opens a tile where it is closed, and brings it to the front.
    pub fn show(&mut self, pane: ViewId) {
        if !self.is_open(pane) {
            self.open(pane);
        }
        self.0
            .make_active(|_, tile| matches!(tile, Tile::Pane(other) if *other == pane));
    }

    /// Closes an open tile, opens a closed one.
    pub fn toggle(&mut self, pane: ViewId) {
        match self.0.tiles.find_pane(&pane) {
            Some(id) => {
                self.0.remove_recursively(id);
            }
            None => self.show(pane),
        }
    }

    /// Adds a tile behind one that is at home where it is, else below all.
    fn open(&mut self, pane: ViewId) {
        let id = self.0.tiles.insert_pane(pane);
        let neighbors = VIEWS.iter().filter(|row| row.home == pane.about().home);
        let group = neighbors
            .filter_map(|row| self.0.tiles.find_pane(&row.id))
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

    /// The tree of tiles, for what draws it.
    pub fn tree(&self) -> &Tree<ViewId> {
        &self.0
    }

    /// The tiles as a person has moved them.
    pub fn moved(tree: Tree<ViewId>) -> Self {
        Self(tree)
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
            tiles.show(ViewId::Slices);
            tiles.toggle(ViewId::Lobe3d);
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
            for row in VIEWS {
                tiles.show(row.id);
            }
            assert!(VIEWS.iter().all(|row| tiles.is_open(row.id)));
            for row in VIEWS {
                tiles.toggle(row.id);
            }
            assert!(!VIEWS.iter().any(|row| tiles.is_open(row.id)));
        }
    }
}
