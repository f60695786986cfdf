//! The open materials.

use crate::app::command::Command;
use crate::app::paint;
use crate::app::state::{Origin, State};
use crate::app::update::Msg;
use crate::measured::samples::SAMPLES;

/// Draws the list, and what to do where it is empty.
pub fn library_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        ui.heading("Materials");
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui
                .button("Open…")
                .on_hover_text(Command::Open.hint(ui.ctx()))
                .clicked()
            {
                out.push(Msg::Run(Command::Open));
            }
        });
    });
    ui.add_space(4.0);
    egui::ScrollArea::vertical()
        .auto_shrink([false, true])
        .show(ui, |ui| {
            for index in 0..state.scene.opened.len() {
                material_ui(ui, state, index, out);
            }
            if state.scene.opened.is_empty() && state.jobs.is_empty() {
                ui.weak(
                    "Nothing is open. Open a MERL or fit file, drop files here, or take a sample.",
                );
            }
            ui.add_space(12.0);
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
        });
}

fn material_ui(ui: &mut egui::Ui, state: &State, index: usize, out: &mut Vec<Msg>) {
    let Some(material) = state.materials.get(&state.scene.opened[index].id) else {
        return;
    };
    let grid = material.table.grid();
    let valid = 100.0 * material.table.valid_count() as f64 / grid.len() as f64;
    ui.horizontal(|ui| {
        let (dot, _) = ui.allocate_exact_size(egui::vec2(10.0, 18.0), egui::Sense::hover());
        ui.painter().circle_filled(
            dot.center(),
            4.5,
            paint::series_color(ui.visuals().dark_mode, index),
        );
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let close = ui.add(egui::Button::new("×").small().frame(false));
            close.widget_info(|| {
                egui::WidgetInfo::labeled(
                    egui::Role::Button,
                    true,
                    format!("Close {}", material.name),
                )
            });
            if close.on_hover_text("Close this material").clicked() {
                out.push(Msg::Close(index));
            }
            ui.with_layout(egui::Layout::top_down_justified(egui::Align::Min), |ui| {
                let row =
                    egui::Button::selectable(index == state.scene.selected, material.name.as_str())
                        .truncate();
                let response = ui.add(row).on_hover_ui(|ui| {
                    ui.label(&material.name);
                    match &material.origin {
                        Origin::File(path) => ui.weak(path.display().to_string()),
                        Origin::Sample(sample) => ui.weak(SAMPLES[*sample].about),
                    };
                    ui.weak(format!(
                        "{valid:.1} % of {} cells measured, {} φd bins",
                        grid.len(),
                        grid.phi_d_bins()
                    ));
                });
                if response.clicked() {
                    out.push(Msg::Select(index));
                }
            });
        });
    });
}
