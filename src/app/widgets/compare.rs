//! The choice of the models that are fitted beside each other.

use crate::app::command::{Command, ENTRIES, Entry};
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::widgets::controls::tick_menu_ui;
use egui::WidgetInfo;

/// Models in a row of the menu.
const COLUMNS: usize = 2;

/// Draws a button with the choice behind it, beside the button that compares. `place` tells two of them apart.
pub fn choice_ui(ui: &mut egui::Ui, state: &State, place: &str, out: &mut Vec<Msg>) {
    let button = tick_menu_ui(ui, "…", |ui| {
        ui.push_id(place, |ui| menu_ui(ui, state, out));
    });
    button.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, "Models to compare"));
    let count = state.prefs.comparison.count();
    button.on_hover_text(format!("Which models are compared: {count}"));
}

fn menu_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let (sets, models): (Vec<_>, Vec<_>) = entries("Models to compare")
        .partition(|entry| !matches!(entry.command, Command::ToggleCompared(_)));
    ui.horizontal(|ui| {
        ui.strong("Models to compare");
        for entry in sets {
            let chosen = entry.command.is_checked(state).unwrap_or(false);
            let button = ui.add(egui::Button::new(&*entry.name).small().selected(chosen));
            if button.on_hover_text(&*entry.help).clicked() {
                out.push(Msg::Run(entry.command));
            }
        }
    });
    egui::Grid::new("models")
        .num_columns(COLUMNS)
        .show(ui, |ui| {
            // Down the columns, as one reads the list of models.
            let rows = models.len().div_ceil(COLUMNS);
            for row in 0..rows {
                for entry in models.iter().skip(row).step_by(rows) {
                    tick_ui(ui, state, entry, out);
                }
                ui.end_row();
            }
        });
    ui.horizontal(|ui| {
        ui.strong("Fresnel");
        for entry in entries("Fresnel to compare") {
            tick_ui(ui, state, entry, out);
        }
    });
    let comparison = &state.prefs.comparison;
    match comparison.blocked() {
        Some(why_not) => ui.colored_label(ui.visuals().warn_fg_color, why_not),
        None => ui.weak(comparison.count()),
    };
}

fn entries(submenu: &'static str) -> impl Iterator<Item = &'static Entry> {
    let entries = ENTRIES.iter();
    entries.filter(move |entry| entry.menu == "Fit" && entry.submenu == submenu)
}

fn tick_ui(ui: &mut egui::Ui, state: &State, entry: &Entry, out: &mut Vec<Msg>) {
    let mut on = entry.command.is_checked(state).unwrap_or(false);
    let tick = ui.checkbox(&mut on, &*entry.name);
    if tick.on_hover_text(&*entry.help).changed() {
        out.push(Msg::Run(entry.command));
    }
}
