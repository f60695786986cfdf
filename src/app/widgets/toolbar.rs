//! Toolbars of tiles: one row, and a "…" menu with what the row has no room for.

use egui::{Align, Button, Layout, Popup, PopupCloseBehavior, Ui, UiBuilder, WidgetInfo, vec2};

/// Room in points for the "…" at the end of a row.
const MORE: f32 = 30.0;

/// Draws a row of groups of controls. Those that do not fit stand in a "…" menu at its end, a line each.
///
/// `content` adds its groups by [`Groups::group`], the most wanted first, the same ones at each call: it is called once
/// for the row, again for the menu where that is open, and once more at first for the widths.
pub fn row_ui(ui: &mut Ui, mut content: impl FnMut(&mut Groups<'_>)) {
    let id = ui.scope_id().with("toolbar");
    let known = ui.data(|data| data.get_temp::<Vec<f32>>(id));
    let mut widths = known.unwrap_or_else(|| measured(ui, &mut content));
    let gap = ui.spacing().item_spacing.x;
    let shown = shown_groups(&widths, gap, ui.available_width());
    let button = ui.text_style_height(&egui::TextStyle::Button);
    let height = button + 2.0 * ui.spacing().button_padding.y;
    let size = vec2(ui.available_width(), height);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        let all = shown == widths.len();
        let mut row = Groups {
            ui,
            widths: &mut widths,
            at: 0,
            shown: 0..if all { usize::MAX } else { shown },
            separators: true,
        };
        content(&mut row);
        if !all {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                more_ui(ui, |ui| {
                    let mut menu = Groups {
                        ui,
                        widths: &mut widths,
                        at: 0,
                        shown: shown..usize::MAX,
                        separators: false,
                    };
                    content(&mut menu);
                });
            });
        }
    });
    ui.data_mut(|data| data.insert_temp(id, widths));
}

/// Groups of controls on their way into a row or into its menu.
pub struct Groups<'a> {
    ui: &'a mut Ui,
    /// Width of each group in points, as it was drawn last.
    widths: &'a mut Vec<f32>,
    at: usize,
    /// Positions of those that are drawn here.
    shown: std::ops::Range<usize>,
    /// Whether lines part the sections: in a row, and not in a menu.
    separators: bool,
}

impl Groups<'_> {
    /// Controls that stay together. One that is empty for now takes no room.
    pub fn group(&mut self, add: impl FnOnce(&mut Ui)) {
        let at = self.at;
        self.at += 1;
        if !self.shown.contains(&at) {
            return;
        }
        let width = self.ui.horizontal(add).response.rect.width();
        match self.widths.get_mut(at) {
            Some(known) => *known = width,
            None => self.widths.push(width),
        }
    }

    /// Controls that stay together, parted by a line from those before.
    pub fn section(&mut self, add: impl FnOnce(&mut Ui)) {
        let line = self.separators && self.at > 0;
        self.group(|ui| {
            if line {
                ui.separator();
            }
            add(ui);
        });
    }
}

/// Widths of the groups, from drawing them where nobody sees it.
fn measured(ui: &mut Ui, content: &mut impl FnMut(&mut Groups<'_>)) -> Vec<f32> {
    let mut widths = Vec::new();
    let builder = UiBuilder::new()
        .id_salt("widths")
        .layout(Layout::left_to_right(Align::Center))
        .sizing_pass()
        .invisible();
    let mut unseen = ui.new_child(builder);
    content(&mut Groups {
        ui: &mut unseen,
        widths: &mut widths,
        at: 0,
        shown: 0..usize::MAX,
        separators: true,
    });
    widths
}

/// Number of groups that a row of this width has room for.
fn shown_groups(widths: &[f32], gap: f32, room: f32) -> usize {
    // An empty group is as wide as nothing, and the gap before it is too little to see.
    let ends = widths.iter().scan(-gap, |end, width| {
        *end += gap + width;
        Some(*end)
    });
    let ends: Vec<f32> = ends.collect();
    if ends.last().is_none_or(|end| *end <= room) {
        return widths.len();
    }
    ends.iter()
        .take_while(|end| **end + gap + MORE <= room)
        .count()
}

/// The "…" button and its menu, which stays open while its controls are used.
fn more_ui(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    let id = ui.scope_id().with("more");
    let mut open = ui.data(|data| data.get_temp(id)).unwrap_or(false);
    let button = ui
        .add(Button::selectable(open, "…"))
        .on_hover_text("More controls");
    button.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, "More controls"));
    if button.clicked() {
        open = !open;
    }
    // A list that opens out of the menu is a popup of its own: a click in it is not one beside the menu.
    let list_open = Popup::is_any_open(ui.ctx());
    let shown = Popup::from_response(&button)
        .open(open)
        .close_behavior(PopupCloseBehavior::IgnoreClicks)
        .show(|ui| ui.vertical(content));
    let beside = |menu: &egui::Response| menu.clicked_elsewhere() && button.clicked_elsewhere();
    let leave = ui.input(|input| input.key_pressed(egui::Key::Escape));
    if shown.is_some_and(|menu| !list_open && (leave || beside(&menu.response))) {
        open = false;
    }
    ui.data_mut(|data| data.insert_temp(id, open));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_left_to_the_menu() {
        let widths = [50.0, 60.0, 70.0];
        for (room, shown) in [
            (200.0, 3),
            (196.0, 3),
            (195.0, 2),
            (156.0, 2),
            (155.0, 1),
            (10.0, 0),
        ] {
            assert_eq!(shown_groups(&widths, 8.0, room), shown, "{room}");
        }
        assert_eq!(shown_groups(&[], 8.0, 10.0), 0);
    }
}
