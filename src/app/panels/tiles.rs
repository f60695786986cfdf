//! The movable tiles in the middle: a row per view, and where they are.

use crate::app::lessons::LookAt;
use crate::app::msg::Msg;
use crate::app::msg::figure::FigureMsg;
use crate::app::panels::lesson;
use crate::app::state::State;
use crate::app::state::layout::Tiles;
use crate::app::state::views::ViewId;
use crate::app::views::ViewRow;
use egui_tiles::{Behavior, TileId, UiResponse};

/// Draws the tiles. What no view has under the pointer is under no probe; what a person moved is a message.
pub fn tiles_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    // egui moves tiles in place.
    let mut tree = state.tiles.tree().clone();
    if tree.is_empty() {
        ui.centered_and_justified(|ui| {
            ui.weak("All tiles are closed. View > Reset layout brings them back.");
        });
    }
    let (probed, pointed) = (&mut false, &mut None);
    let mut content = TileContent {
        state,
        out,
        probed,
        pointed,
    };
    tree.ui(&mut content, ui);
    if *pointed != state.views.pointed {
        out.push(Msg::Figure(FigureMsg::Point(*pointed)));
    }
    if !*probed && state.hovered.is_some() {
        out.push(Msg::Hover(None));
    }
    if tree != *state.tiles.tree() {
        out.push(Msg::SetLayout(Tiles::moved(tree)));
    }
}

/// Content of the tiles.
struct TileContent<'a> {
    state: &'a State,
    out: &'a mut Vec<Msg>,
    probed: &'a mut bool,
    /// The view that the pointer is on.
    pointed: &'a mut Option<ViewId>,
}

impl Behavior<ViewId> for TileContent<'_> {
    fn pane_ui(&mut self, ui: &mut egui::Ui, _id: TileId, pane: &mut ViewId) -> UiResponse {
        if ui.rect_contains_pointer(ui.max_rect()) {
            *self.pointed = Some(*pane);
        }
        egui::Frame::new().inner_margin(8.0).show(ui, |ui| {
            // Two tiles may have one kind of control.
            ui.push_id(pane.about().key, |ui| {
                *self.probed |=
                    ViewRow::of(*pane).is_some_and(|row| (row.ui)(ui, self.state, self.out));
            });
            if self.state.looks_at(LookAt::Tile(*pane)) {
                lesson::frame(ui, ui.max_rect().expand(6.0));
            }
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &ViewId) -> egui::WidgetText {
        pane.about().name.into()
    }

    fn is_tab_closable(&self, _tiles: &egui_tiles::Tiles<ViewId>, _id: TileId) -> bool {
        true
    }

    fn top_bar_right_ui(
        &mut self,
        tiles: &egui_tiles::Tiles<ViewId>,
        ui: &mut egui::Ui,
        _id: TileId,
        tabs: &egui_tiles::Tabs,
        _scroll_offset: &mut f32,
    ) {
        let Some(pane) = tabs.active.and_then(|id| tiles.get_pane(&id)) else {
            return;
        };
        let row = pane.about();
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
