//! The open materials, a row each.

use crate::app::msg::Msg;
use crate::app::msg::library::LibraryMsg;
use crate::app::msg::session::SessionMsg;
use crate::app::state::State;
use crate::app::state::library::PendingTarget;
use crate::app::state::material::{Origin, Presence};
use crate::app::widgets::paint;
use crate::measured::samples::SAMPLES;

/// Draws the rows.
pub fn opened_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    for index in 0..state.scene.opened.len() {
        let size = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
        let row = egui::Rect::from_min_size(ui.cursor().min, size);
        // A fit file may have brought thousands.
        if ui.is_rect_visible(row) {
            material_ui(ui, state, index, out);
        } else {
            ui.allocate_space(size);
        }
    }
    if state.scene.opened.is_empty() && state.jobs.is_empty() {
        ui.weak("Nothing is open. Open a MERL or fit file or a folder, drop them here, or take a sample.");
    }
}

fn material_ui(ui: &mut egui::Ui, state: &State, index: usize, out: &mut Vec<Msg>) {
    let opened = &state.scene.opened[index];
    let Some(material) = state.materials.get(&opened.id) else {
        return;
    };
    let preview = state
        .library
        .preview
        .is_some_and(|preview| preview.id == opened.id);
    let is_pending = matches!(
        &state.library.pending,
        Some(pending) if pending.target == PendingTarget::Material(opened.id)
    );
    ui.horizontal(|ui| {
        let (dot, _) = ui.allocate_exact_size(egui::vec2(10.0, 18.0), egui::Sense::hover());
        ui.painter().circle_filled(
            dot.center(),
            4.5,
            paint::series_color(ui.visuals().dark_mode, index),
        );
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
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
            beside_ui(ui, state, index, &material.name, out);
            if material.presence == Presence::Missing && material.source.is_some() {
                let locate = ui.add(egui::Button::new("…").small());
                locate.widget_info(|| {
                    let label = format!("Locate {}", material.name);
                    egui::WidgetInfo::labeled(egui::Role::Button, true, label)
                });
                if locate.on_hover_text("Say where its file is now").clicked() {
                    out.push(Msg::Session(SessionMsg::Locate(opened.id)));
                }
            }
            ui.with_layout(egui::Layout::top_down_justified(egui::Align::Min), |ui| {
                let mut name = egui::RichText::new(if is_pending {
                    format!("{} – loading…", material.name)
                } else {
                    material.name.clone()
                });
                if preview {
                    name = name.italics();
                }
                let row = egui::Button::selectable(index == state.scene.selected, name).truncate();
                let response = ui.add(row);
                response.widget_info(|| {
                    egui::WidgetInfo::selected(
                        egui::Role::Button,
                        true,
                        index == state.scene.selected,
                        &material.name,
                    )
                });
                let response = response.on_hover_ui(|ui| {
                    ui.label(&material.name);
                    match &material.origin {
                        Origin::File(path) => ui.weak(path.display().to_string()),
                        Origin::Sample(sample) => ui.weak(SAMPLES[*sample].about),
                    };
                    ui.weak(about(material));
                    if preview {
                        ui.weak("The next file of the folder takes its place; double click to leave it open.");
                    }
                });
                if response.clicked() {
                    out.push(Msg::Select(index));
                }
                if response.double_clicked() && preview {
                    out.push(Msg::Library(LibraryMsg::Keep));
                }
            });
        });
    });
}

/// Words on the data of a material: the share measured, or where the data are.
fn about(material: &crate::app::state::material::Material) -> String {
    match material.presence {
        Presence::Loaded => {
            let grid = material.table.grid();
            let valid = 100.0 * material.table.valid_count() as f64 / grid.len() as f64;
            let bins = grid.phi_d_bins();
            format!(
                "{valid:.1} % of {} cells measured, {bins} φd bins",
                grid.len()
            )
        }
        Presence::Evicted => "Its data are loaded again when it is shown.".into(),
        Presence::Loading(_) => "Loading…".into(),
        Presence::Missing => {
            "Its data could not be loaded: the file is not there or cannot be read.".into()
        }
    }
}

/// The check mark that shows a material beside the others.
fn beside_ui(ui: &mut egui::Ui, state: &State, index: usize, name: &str, out: &mut Vec<Msg>) {
    let shown = index == state.scene.selected;
    let mut beside = state.scene.opened[index].beside;
    let tick = ui.add(egui::Checkbox::without_text(&mut beside));
    tick.widget_info(|| {
        let label = format!("Show {name} beside");
        egui::WidgetInfo::selected(egui::Role::CheckBox, true, beside, label)
    });
    let hint = if shown {
        "Leave this material in the plots when another one is shown"
    } else {
        "Show this material in the plots, beside the shown one"
    };
    if tick.on_hover_text(hint).changed() {
        out.push(Msg::SetBeside(index, beside));
    }
}
