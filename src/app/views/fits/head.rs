//! The heads of the columns; a click sorts.

use crate::app::msg::Msg;
use crate::app::msg::fit::FitMsg;
use crate::app::state::fitting::table::{Column, FitTable};
use crate::app::views::fits::columns::{Columns, words};
use crate::app::widgets::paint::rich_text_job;
use crate::figure::text::RichText;
use egui::{Rect, Sense, Shape, Stroke, pos2, vec2};

/// Height of a row in points.
pub const ROW: f32 = 25.0;

/// Draws the heads of the columns.
pub fn header_ui(ui: &mut egui::Ui, table: &FitTable, columns: &Columns, out: &mut Vec<Msg>) {
    let (rect, _) = ui.allocate_exact_size(vec2(columns.width, ROW), Sense::hover());
    head_ui(ui, rect, (Column::Name, None), table, columns, out);
    for (column, right) in &columns.numbers {
        head_ui(ui, rect, (*column, Some(*right)), table, columns, out);
    }
    let line = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().hline(rect.x_range(), rect.bottom(), line);
}

/// Draws a head; its column ends at `right`, or begins where names do.
fn head_ui(
    ui: &egui::Ui,
    row: Rect,
    (column, right): (Column, Option<f32>),
    table: &FitTable,
    columns: &Columns,
    out: &mut Vec<Msg>,
) {
    let sorted = column == table.sort;
    let color = if sorted {
        ui.visuals().strong_text_color()
    } else {
        ui.visuals().weak_text_color()
    };
    let words = words(column);
    let text = match words.head.split_once(" [") {
        // The unit is in the help, too.
        Some((short, _)) if columns.narrow => short,
        _ => &words.head,
    };
    let job = rich_text_job(&RichText::parse(text), 12.5, color);
    let galley = ui.painter().layout_job(job);
    let x = row.left() + right.map_or(columns.name, |right| right - galley.size().x);
    let at = pos2(x, row.center().y - 0.5 * galley.size().y);
    let cell = Rect::from_min_size(at, galley.size()).expand2(vec2(5.0, 4.0));
    ui.painter().galley(at, galley, color);
    if sorted {
        let base = pos2(cell.right() - 5.0, cell.bottom() - 3.0);
        let left = pos2(cell.left() + 5.0, base.y);
        let line = Stroke::new(1.0, color);
        ui.painter().line_segment([left, base], line);
        arrow_ui(ui, cell, table.descending, color);
    }
    let response = ui.interact(cell, ui.scope_id().with(column.key()), Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Sort by {text}"))
    });
    if response.clicked() {
        out.push(Msg::Fit(FitMsg::SortBy(column)));
    }
    response.on_hover_text(words.help);
}

/// A small triangle over the middle of the head: up where the smallest comes first.
fn arrow_ui(ui: &egui::Ui, cell: Rect, descending: bool, color: egui::Color32) {
    let (tip, base) = if descending { (3.0, 0.0) } else { (0.0, 3.0) };
    let top = cell.top() - 1.0;
    let middle = cell.center().x;
    let points = vec![
        pos2(middle, top + tip),
        pos2(middle - 3.5, top + base),
        pos2(middle + 3.5, top + base),
    ];
    ui.painter()
        .add(Shape::convex_polygon(points, color, Stroke::NONE));
}
