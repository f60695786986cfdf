//! Whether a layout from a file is one: a tree, with each tile in it once.

use crate::app::state::views::ViewId;
use egui_tiles::{Container, GridLayout, Tile, Tree};
use std::collections::BTreeSet;

/// More tiles and groups than anybody has.
const MOST: usize = 200;

/// Copy of the tree under our id and with nothing that hangs beside it.
pub(crate) fn checked(tree: &Tree<ViewId>) -> Result<Tree<ViewId>, String> {
    let Some(root) = tree.root else {
        return Ok(Tree::empty(tree_id()));
    };
    let mut tiles = egui_tiles::Tiles::default();
    let (mut seen, mut panes) = (BTreeSet::new(), Vec::new());
    let mut todo = vec![root];
    while let Some(id) = todo.pop() {
        if !seen.insert(id.0) || seen.len() > MOST {
            return Err("the layout is no tree".into());
        }
        let Some(tile) = tree.tiles.get(id) else {
            return Err("the layout has a tile that is nowhere".into());
        };
        match tile {
            Tile::Pane(pane) if panes.contains(pane) => {
                return Err(format!("the layout has {} twice", pane.about().name));
            }
            Tile::Pane(pane) => panes.push(*pane),
            Tile::Container(container) => {
                if !has_shares(container) {
                    return Err("the layout has a share that is none".into());
                }
                todo.extend(container.children());
            }
        }
        tiles.insert(id, tile.clone());
        tiles.set_visible(id, tree.tiles.is_visible(id));
    }
    Ok(Tree::new(tree_id(), root, tiles))
}

fn has_shares(container: &Container) -> bool {
    let fits = |share: &f32| (0.0..1e6).contains(share);
    match container {
        Container::Tabs(_) => true,
        Container::Linear(linear) => linear.shares.iter().all(|(_, share)| fits(share)),
        Container::Grid(grid) => {
            let columns: fn(GridLayout) -> bool = |layout| match layout {
                GridLayout::Auto => true,
                GridLayout::Columns(count) => (1..=MOST).contains(&count),
            };
            let shares = grid.col_shares.iter().chain(&grid.row_shares);
            columns(grid.layout) && shares.take(2 * MOST).all(fits)
        }
    }
}

pub(crate) fn tree_id() -> egui::Id {
    egui::Id::unique("tiles")
}

#[cfg(test)]
mod tests {
    use crate::app::state::layout::Tiles;
    use crate::app::state::views::VIEWS;
    use serde_json::{Value, json};

    #[test]
    fn a_layout_that_is_no_tree_is_refused_and_a_good_one_is_kept() {
        let good = serde_json::to_value(Tiles::default()).expect("data");
        let read = |value: &Value| serde_json::from_value::<Tiles>(value.clone());
        assert_eq!(read(&good).expect("good"), Tiles::default());
        let root = good["tree"]["root"].clone();
        type Break<'a> = &'a dyn Fn(&mut Value);
        let broken: [(&str, Break); 5] = [
            ("no tree", &|v| {
                let tile = &mut v["tree"]["tiles"]["tiles"][root.to_string()];
                tile["Container"]["Linear"]["children"] = json!([root]);
            }),
            ("nowhere", &|v| v["tree"]["root"] = json!(12345)),
            ("twice", &|v| {
                let tiles = v["tree"]["tiles"]["tiles"].as_object_mut().expect("tiles");
                for tile in tiles.values_mut().filter(|tile| tile.get("Pane").is_some()) {
                    *tile = json!({"Pane": "Sphere"});
                }
            }),
            ("share", &|v| {
                let tile = &mut v["tree"]["tiles"]["tiles"][root.to_string()];
                tile["Container"]["Linear"]["shares"]["shares"] = json!({"1": 1e39});
            }),
            ("version", &|v| v["version"] = json!(7)),
        ];
        for (words, break_it) in broken {
            let mut value = good.clone();
            break_it(&mut value);
            let error = read(&value).expect_err("broken").to_string();
            assert!(error.contains(words), "{error}");
        }
        // Adding tiles works whatever the file says of the next number.
        let mut value = good.clone();
        value["tree"]["tiles"]["next_tile_id"] = json!(u64::MAX);
        let mut tiles = read(&value).expect("good");
        for row in VIEWS {
            tiles.toggle(row.id);
            tiles.toggle(row.id);
        }
    }
}
