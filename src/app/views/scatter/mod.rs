//! The materials by two quantities of their fits of a model: of the combined one some are Phong-like, some Blinn-Phong-like.

pub mod about;
mod bar;
pub mod paper;
mod rows;
pub mod settings;

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::views::scatter::rows::{ScatterRow, rows};
use crate::app::views::scatter::settings::{ScatterSettings, with_ends};
use crate::app::widgets::formula::{number, percent};
use crate::app::widgets::zoom::PlaneZoom;
use crate::app::widgets::{empty, paint, zoom};
use crate::figure::RichText;
use crate::figure::palette::Palette;
use crate::figure::scatter::{Quantity, ScatterDot, ScatterPlot};
use egui::{CursorIcon, Sense, Vec2};

/// Draws the tile.
pub fn scatter_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<ScatterSettings>();
    bar::toolbar_ui(ui, state, view, out);
    let size = ui.available_size().max(Vec2::splat(60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Scatter"));
    let rows = rows(state, view);
    if rows.is_empty() {
        let text = format!(
            "Fit the {} model to some materials, or to the folder, to compare them here.",
            view.model.word
        );
        empty::empty_ui(ui, rect, &text);
        return false;
    }
    let dots: Vec<ScatterDot> = rows.iter().map(|row| row.dot.clone()).collect();
    let plot = ScatterPlot::new(&dots, view, [rect.width(), rect.height()]);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    let moved = match zoom::plane_gesture(ui, &response, &plot.frame) {
        Some(PlaneZoom::Ends(ends)) => with_ends(view, ends),
        Some(PlaneZoom::Reset) => ScatterSettings {
            window: None,
            y_window: None,
            ..view.clone()
        },
        None => view.clone(),
    };
    if moved != *view {
        out.push(Msg::set_view(moved));
    }
    let pointed = response.hover_pos().and_then(|at| {
        let at = at - rect.min;
        plot.dot_at([at.x, at.y])
    });
    if let Some(row) = pointed.and_then(|index| rows.get(index)) {
        ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
        if response.clicked() {
            out.push(Msg::show_material(&row.place));
        }
        response.on_hover_ui_at_pointer(|ui| {
            ui.strong(&row.dot.name);
            ui.label(RichText::parse(&words(view, row)).plain());
        });
    }
    false
}

/// The values of a dot, and E.
fn words(view: &ScatterSettings, row: &ScatterRow) -> String {
    let [x, y] = view.rows();
    let all = view.quantities().into_iter().zip([x, y]);
    let values = all.zip([row.dot.x, row.dot.y]).rev();
    let mut words: Vec<String> = values
        .filter(|((quantity, _), _)| *quantity != Quantity::Error)
        .map(|((_, shown), value)| format!("{} {}", shown.symbol, number(value)))
        .collect();
    words.push(format!("E {}", percent(row.error)));
    words.join("  ")
}
