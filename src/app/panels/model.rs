//! The model: its formula with live numbers and a row per parameter.

use crate::app::command::{Command, ENTRIES, Entry};
use crate::app::lessons::LookAt;
use crate::app::msg::Msg;
use crate::app::panels::sides::fold_ui;
use crate::app::panels::{lesson, params};
use crate::app::state::State;
use crate::app::state::side_panels::Side;
use crate::app::widgets::controls::{command_choice_ui, tick_ui};
use crate::app::widgets::formula;
use crate::app::widgets::paint::rich_text_job;
use crate::brdf::{Brdf, PHONG_FAMILY};
use crate::figure::text::RichText;

/// Draws the heading with its buttons.
pub fn head_ui(ui: &mut egui::Ui, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        ui.heading("Model");
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            fold_ui(ui, Side::Model, out);
            buttons_ui(ui, out);
        });
    });
}

/// The buttons that set all sliders at once.
pub fn buttons_ui(ui: &mut egui::Ui, out: &mut Vec<Msg>) {
    for (command, name) in [
        (Command::ResetParams, "Reset"),
        (Command::GuessParams, "Guess from data"),
    ] {
        let button = ui.button(name).on_hover_text(command.hint(ui.ctx()));
        if button.clicked() {
            out.push(Msg::Run(command));
        }
    }
}

/// Draws the model over the shown material.
pub fn model_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let Some((_, opened)) = state.current() else {
        ui.weak("Open a material to lay a model over it.");
        return;
    };
    let brdf = &opened.brdf;
    let top = ui.cursor().min;
    choices_ui(ui, state, out);
    ui.add_space(2.0);
    formula_ui(ui, brdf);
    lesson::frame_from(ui, top, state.looks_at(LookAt::Model));
    ui.add_space(2.0);
    // The shape first: it is dragged most.
    params::params_ui(ui, state, opened, false, out);
    optimal_ui(ui, state, out);
    params::params_ui(ui, state, opened, true, out);
    derived_ui(ui, brdf);
}

/// Width in points of the menu of further models.
const MORE: f32 = 84.0;

/// The models and Fresnel factors as rows of buttons, from the command list; models beyond the Phong family in a menu.
fn choices_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    // In a narrow panel the menu is below them.
    ui.horizontal_wrapped(|ui| {
        let (near, more) = entries("").partition::<Vec<_>, _>(
            |entry| matches!(entry.command, Command::UseModel(index) if index < PHONG_FAMILY.len()),
        );
        for entry in near {
            choice_ui(ui, state, entry, out);
        }
        let is_chosen = |entry: &&Entry| entry.command.is_checked(state).unwrap_or(false);
        let chosen = more.iter().copied().find(is_chosen);
        let text = chosen.map_or("More", |entry| &entry.name);
        if chosen.is_some() {
            // As the button of a chosen model beside it.
            let visuals = ui.visuals_mut();
            let selection = visuals.selection;
            for state in [
                &mut visuals.widgets.inactive,
                &mut visuals.widgets.hovered,
                &mut visuals.widgets.open,
            ] {
                state.weak_bg_fill = selection.bg_fill;
                state.fg_stroke = selection.stroke;
            }
        }
        let menu = egui::ComboBox::from_id_salt("more models")
            .width(MORE)
            .truncate()
            .height(400.0)
            .selected_text(text)
            .show_ui(ui, |ui| {
                more.into_iter()
                    .for_each(|entry| choice_ui(ui, state, entry, out));
            });
        ui.ctx()
            .accesskit_node_builder(menu.response.id, |node| node.set_label("More models"));
        menu.response
            .on_hover_text("Models beside the Phong family");
    });
    ui.horizontal(|ui| {
        ui.label("Fresnel");
        entries("Fresnel").for_each(|entry| choice_ui(ui, state, entry, out));
    });
}

/// The entries of the Model menu, or of a menu in it.
fn entries(submenu: &'static str) -> impl Iterator<Item = &'static Entry> {
    let entries = ENTRIES.iter();
    entries.filter(move |entry| entry.menu == "Model" && entry.submenu == submenu)
}

fn choice_ui(ui: &mut egui::Ui, state: &State, entry: &Entry, out: &mut Vec<Msg>) {
    let chosen = entry.command.is_checked(state).unwrap_or(false);
    command_choice_ui(ui, entry.command, &entry.name, chosen, out);
}

fn optimal_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let command = Command::ToggleKeepOptimal;
    let mut on = state.fit.keep_optimal;
    let tick = tick_ui(
        ui,
        &mut on,
        "keep ρ_{d}, k_{s} optimal",
        "keep rho_d, k_s optimal",
    );
    if tick.on_hover_text(command.hint(ui.ctx())).changed() {
        out.push(Msg::Run(command));
    }
}

fn formula_ui(ui: &mut egui::Ui, brdf: &Brdf) {
    egui::Frame::group(ui.style()).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let strong = ui.visuals().strong_text_color();
        let weak = ui.visuals().text_color();
        ui.add(
            egui::Label::new(rich_text_job(
                &RichText::parse(&formula::symbolic(brdf)),
                15.0,
                strong,
            ))
            .wrap(),
        )
        .on_hover_text(brdf.model.source);
        ui.add(
            egui::Label::new(rich_text_job(
                &RichText::parse(&formula::numeric(brdf)),
                12.5,
                weak,
            ))
            .wrap(),
        );
    });
}

fn derived_ui(ui: &mut egui::Ui, brdf: &Brdf) {
    let mut rows = Vec::new();
    if let Some(rho_s) = brdf.rho_s() {
        rows.push((
            "ρ_{s}",
            rho_s,
            "Specular reflectance of the normalised form with this k_s",
        ));
    }
    rows.push((
        "k_{s}·R_{F}(0)",
        brdf.specular_at_normal(),
        "Height of the lobe seen from above; as η nears 1 only this product counts",
    ));
    egui::Grid::new("derived")
        .num_columns(2)
        .spacing([12.0, 3.0])
        .show(ui, |ui| {
            for (symbol, values, help) in rows {
                let color = ui.visuals().text_color();
                ui.label(rich_text_job(&RichText::parse(symbol), 13.0, color))
                    .on_hover_text(help);
                let text = values.map(formula::number).join("   ");
                ui.label(rich_text_job(&RichText::parse(&text), 13.0, color));
                ui.end_row();
            }
        });
}
