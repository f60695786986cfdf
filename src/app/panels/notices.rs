//! Notices in the corner of the window. Errors stay until they are closed.

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::notice::Severity;
use egui::{Align2, Area, Frame, Id, Order, RichText};

const WIDTH: f32 = 420.0;
/// Older ones wait until there is room.
const SHOWN: usize = 5;

/// Draws them over everything else.
pub fn notices_ui(ctx: &egui::Context, state: &State, out: &mut Vec<Msg>) {
    if state.notices.is_empty() {
        return;
    }
    Area::new(Id::unique("notices"))
        .order(Order::Foreground)
        .anchor(Align2::RIGHT_BOTTOM, [-12.0, -40.0])
        .show(ctx, |ui| {
            ui.set_width(WIDTH);
            for notice in state.notices.iter().rev().take(SHOWN).rev() {
                Frame::popup(ui.style()).show(ui, |ui| {
                    ui.set_width(WIDTH - 16.0);
                    ui.horizontal_top(|ui| {
                        let (mark, color) = match notice.level {
                            Severity::Info => ("i", ui.visuals().hyperlink_color),
                            Severity::Error => ("!", ui.visuals().error_fg_color),
                        };
                        ui.label(RichText::new(mark).color(color).strong().size(17.0));
                        ui.vertical(|ui| {
                            ui.set_width(WIDTH - 80.0);
                            ui.add(egui::Label::new(notice.text.as_str()).wrap());
                        });
                        let close = ui.small_button("×");
                        close.widget_info(|| {
                            egui::WidgetInfo::labeled(egui::Role::Button, true, "Close notice")
                        });
                        if close.clicked() {
                            out.push(Msg::Dismiss(notice.id));
                        }
                    });
                });
            }
        });
}
