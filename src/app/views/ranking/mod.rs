//! The models by their E over the materials.

pub mod about;
mod bar;
pub mod paper;
mod rows;
pub mod settings;

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::views::ranking::rows::{RankingRows, rows};
use crate::app::views::ranking::settings::RankingSettings;
use crate::app::widgets::formula::percent;
use crate::app::widgets::{empty, paint};
use crate::figure::RichText;
use crate::figure::palette::Palette;
use crate::figure::ranking::RankingPlot;
use egui::{CursorIcon, Sense, Vec2};

/// Draws the tile, which has no place for the probe.
pub fn ranking_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<RankingSettings>();
    let rows = rows(state, view);
    bar::toolbar_ui(ui, view, &rows, out);
    let size = ui.available_size().max(Vec2::splat(60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Ranking"));
    let plot = RankingPlot::new(&rows.spec, [rect.width(), rect.height()]);
    if plot.ranking.rows.is_empty() {
        let text = "Compare models on some materials, or on the folder, to rank them here.";
        empty::empty_ui(ui, rect, text);
        return false;
    }
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    let pointed = response.hover_pos().and_then(|at| {
        let at = at - rect.min;
        plot.dot_at([at.x, at.y])
    });
    let Some((row, model)) = pointed else {
        return false;
    };
    ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    let material = plot.ranking.rows[row].material;
    if response.clicked() {
        out.push(Msg::show_material(&rows.places[material]));
    }
    response.on_hover_ui_at_pointer(|ui| {
        ui.strong(&rows.spec.materials[material].name);
        ui.label(RichText::parse(&words(&rows, &plot, row, model)).plain());
    });
    false
}

/// Model, rank and E of a dot, as markup.
fn words(rows: &RankingRows, plot: &RankingPlot, row: usize, model: usize) -> String {
    let Some((fit, error)) = plot.ranking.rows[row].fits[model] else {
        return String::new();
    };
    let won = plot.ranking.rows[row].winner == Some(model);
    format!(
        "{}, Fresnel {}:  E {}{}\n{} of {} materials",
        fit.model.name,
        fit.fresnel.key(),
        percent(error),
        if won { ", best" } else { "" },
        row + 1,
        rows.spec.materials.len().min(plot.ranking.rows.len()),
    )
}
