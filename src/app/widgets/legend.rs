//! The names in the legend of a plot: click and double click.

use crate::app::msg::Msg;
use crate::app::state::subjects::Subjects;
use crate::figure::LegendEntry;
use egui::{CursorIcon, Pos2, Rect, Sense};

/// Lets the names be clicked in a plot whose upper left corner is at `origin`. To be called after the plot itself.
pub fn legend_ui(
    ui: &egui::Ui,
    origin: Pos2,
    legend: &[LegendEntry],
    subjects: &Subjects,
    out: &mut Vec<Msg>,
) {
    for entry in legend {
        let [min, max] = entry.bounds.map(|corner| origin + egui::Vec2::from(corner));
        let subject = &subjects.list[entry.subject];
        let id = ui.scope_id().with(("legend", entry.subject));
        let response = ui
            .interact(Rect::from_min_max(min, max), id, Sense::click())
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_text("Click: show or hide. Double click: this alone.");
        response.widget_info(|| {
            let name = format!("Show {}", subject.label);
            egui::WidgetInfo::selected(egui::Role::CheckBox, true, !subject.hidden, name)
        });
        let key = subjects.keys[entry.subject];
        if response.double_clicked() {
            // The first of the two clicks has hidden or shown it.
            out.push(Msg::Legend { key, solo: false });
            out.push(Msg::Legend { key, solo: true });
        } else if response.clicked() {
            out.push(Msg::Legend { key, solo: false });
        }
    }
}
