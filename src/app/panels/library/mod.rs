//! The open materials, and below them the open folder.

mod files;
mod folder;
mod opened;

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::panels::sides::fold_ui;
use crate::app::state::State;
use crate::app::state::material::Origin;
use crate::app::state::side_panels::Side;
use crate::files::folder::shown_name;
use crate::measured::samples::SAMPLES;

/// Draws the lists, and what to do where they are empty.
pub fn library_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let whole = ui.available_rect_before_wrap();
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        ui.heading("Materials");
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            fold_ui(ui, Side::Library, out);
            button_ui(ui, "Open…", Command::Open, out);
        });
    });
    ui.add_space(4.0);
    if state.library.folder.is_none() {
        egui::ScrollArea::vertical()
            .auto_shrink([false, true])
            .show(ui, |ui| {
                opened::opened_ui(ui, state, out);
                ui.add_space(8.0);
                no_folder_ui(ui, state, out);
                ui.add_space(8.0);
                samples_ui(ui, state, out);
            });
        return;
    }
    let height = (0.4 * ui.available_height()).max(60.0);
    egui::ScrollArea::vertical()
        .id_salt("opened")
        .max_height(height)
        .auto_shrink([false, true])
        .show(ui, |ui| opened::opened_ui(ui, state, out));
    ui.separator();
    folder::folder_ui(ui, state, whole, out);
}

fn button_ui(ui: &mut egui::Ui, name: &str, command: Command, out: &mut Vec<Msg>) {
    let hint = command.hint(ui.ctx());
    if ui.button(name).on_hover_text(hint).clicked() {
        out.push(Msg::Run(command));
    }
}

/// Offers to open a folder, and the one from the last time.
fn no_folder_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.weak("Folder");
    ui.horizontal_wrapped(|ui| {
        button_ui(ui, "Open folder…", Command::OpenFolder, out);
        let Some(path) = &state.prefs.folder else {
            return;
        };
        let again = egui::Button::new(format!("{}/", shown_name(path)))
            .frame(false)
            .truncate();
        if ui
            .add(again)
            .on_hover_text(path.display().to_string())
            .clicked()
        {
            out.push(Msg::OpenFiles(vec![path.clone()]));
        }
    });
}

fn samples_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.weak("Samples");
    for (index, sample) in SAMPLES.iter().enumerate() {
        let is_open = state.scene.opened.iter().any(|opened| {
            state
                .materials
                .get(&opened.id)
                .is_some_and(|material| material.origin == Origin::Sample(index))
        });
        let button = egui::Button::new(sample.name).frame(false).truncate();
        if !is_open && ui.add(button).on_hover_text(sample.about).clicked() {
            out.push(Msg::Run(Command::OpenSample(index)));
        }
    }
}
