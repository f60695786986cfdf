//! The panels beside the tiles: open, or folded to a strip that opens them.

use crate::app::command::Command;
use crate::app::lessons::LookAt;
use crate::app::msg::Msg;
use crate::app::panels::{fit, fit_result, lesson, library, model};
use crate::app::state::State;
use crate::app::state::side_panels::{Side, SideTab};
use crate::brdf::all_params;
use egui::{Align, Align2, FontId, Layout, Panel, Pos2, Sense, Ui, WidgetInfo, vec2};

/// Width in points below which a window is narrow.
pub const NARROW: f32 = 1100.0;
/// Width of a strip in points.
const STRIP: f32 = 28.0;
/// Height in points from which the model and the fit stand one above the other.
const BOTH: f32 = 600.0;
/// Room that is left for the fit below the model.
const FIT_ROOM: f32 = 226.0;

/// Draws both panels.
pub fn sides_ui(ui: &mut Ui, state: &State, out: &mut Vec<Msg>) {
    let width = ui.available_width();
    if state.prefs.panels.is_open(Side::Library) {
        Panel::left("library")
            .default_size(210.0)
            .size_range(150.0..=420.0)
            .show(ui, |ui| library::library_ui(ui, state, out));
    } else {
        folded_ui(ui, Panel::left("library strip"), Side::Library, out);
    }
    if state.prefs.panels.is_open(Side::Model) || looked_at(state).is_some() {
        // A narrow window has no room to give: the panel takes its share, and is not resized.
        let panel = if state.prefs.panels.is_narrow {
            let share = (0.36 * width).clamp(256.0, 316.0);
            Panel::right("model narrow")
                .exact_size(share)
                .resizable(false)
        } else {
            Panel::right("model")
                .default_size(316.0)
                .size_range(300.0..=520.0)
        };
        panel.show(ui, |ui| right_ui(ui, state, out));
    } else {
        folded_ui(ui, Panel::right("model strip"), Side::Model, out);
    }
}

/// Half of the model's panel that a lesson speaks of.
fn looked_at(state: &State) -> Option<SideTab> {
    if state.looks_at(LookAt::Fit) {
        return Some(SideTab::Fit);
    }
    let params = all_params().map(|row| LookAt::Param(row.id));
    let mut model = params.chain([LookAt::Model]);
    model
        .any(|what| state.looks_at(what))
        .then_some(SideTab::Model)
}

fn folded_ui(ui: &mut Ui, panel: Panel, side: Side, out: &mut Vec<Msg>) {
    let strip = panel.exact_size(STRIP).resizable(false);
    strip.show(ui, |ui| strip_ui(ui, side, out));
}

/// A folded panel: its name from below to above; a click opens it.
fn strip_ui(ui: &mut Ui, side: Side, out: &mut Vec<Msg>) {
    let name = side.name();
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, format!("Open {name}")));
    let color = ui.style().interact(&response).fg_stroke.color;
    let galley = ui
        .painter()
        .layout_no_wrap(name.to_owned(), FontId::proportional(14.0), color);
    let at = Pos2::new(
        rect.center().x - 0.5 * galley.size().y,
        rect.top() + 14.0 + galley.size().x,
    );
    let text = egui::epaint::TextShape::new(at, galley, color);
    ui.painter()
        .add(text.with_angle(-std::f32::consts::FRAC_PI_2));
    let hint = Command::TogglePanel(side).hint(ui.ctx());
    if response.on_hover_text(hint).clicked() {
        out.push(Msg::Run(Command::TogglePanel(side)));
    }
}

/// A button that folds a panel, at the right end of its heading.
pub fn fold_ui(ui: &mut Ui, side: Side, out: &mut Vec<Msg>) {
    let size = vec2(16.0, ui.spacing().interact_size.y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let label = format!("Fold {}", side.name());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &label));
    let color = ui.style().interact(&response).fg_stroke.color;
    let text = match side {
        Side::Library => "«",
        Side::Model => "»",
    };
    let font = FontId::proportional(15.0);
    ui.painter()
        .text(rect.center(), Align2::CENTER_CENTER, text, font, color);
    if response.on_hover_text("Fold to a strip").clicked() {
        out.push(Msg::Run(Command::TogglePanel(side)));
    }
}

/// The model above the fit, or one of them where there is no room for both.
fn right_ui(ui: &mut Ui, state: &State, out: &mut Vec<Msg>) {
    // A panel is as wide as its content: without this it would shrink.
    ui.set_min_width(ui.available_width());
    ui.add_space(3.0);
    if ui.available_height() < BOTH {
        tabs_ui(ui, state, out);
        return;
    }
    model::head_ui(ui, out);
    egui::ScrollArea::vertical()
        .id_salt("model")
        .max_height(ui.available_height() - FIT_ROOM)
        .auto_shrink([false, true])
        .show(ui, |ui| model::model_ui(ui, state, out));
    ui.separator();
    let rect = ui.available_rect_before_wrap();
    fit::head_ui(ui, state, out);
    fit::fit_ui(ui, state, out);
    if state.looks_at(LookAt::Fit) {
        lesson::frame(ui, rect);
    }
}

/// Two tabs with the button of the fit beside them, and below them its error: what is worked with whichever is shown.
fn tabs_ui(ui: &mut Ui, state: &State, out: &mut Vec<Msg>) {
    let tab = looked_at(state).unwrap_or(state.prefs.panels.tab);
    ui.horizontal(|ui| {
        for (choice, name) in [(SideTab::Model, "Model"), (SideTab::Fit, "Fit")] {
            let response = ui.selectable_label(tab == choice, name);
            response
                .widget_info(|| WidgetInfo::selected(egui::Role::Tab, true, tab == choice, name));
            if response.clicked() {
                out.push(Msg::ShowTab(choice));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            fold_ui(ui, Side::Model, out);
            fit::buttons_ui(ui, state, out);
        });
    });
    let rect = ui.available_rect_before_wrap();
    match tab {
        SideTab::Model => {
            fit_result::line_ui(ui, state);
            egui::ScrollArea::vertical()
                .id_salt("model")
                .auto_shrink([false, false])
                .show(ui, |ui| {
                    model::model_ui(ui, state, out);
                    ui.horizontal(|ui| model::buttons_ui(ui, out));
                });
        }
        SideTab::Fit => fit::fit_ui(ui, state, out),
    }
    if state.looks_at(LookAt::Fit) {
        lesson::frame(ui, rect);
    }
}
