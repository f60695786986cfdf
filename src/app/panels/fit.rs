//! The fit: what it is asked, and the buttons that start and stop it.

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::msg::fit::FitMsg;
use crate::app::panels::{fit_result, fit_stages};
use crate::app::state::State;
use crate::app::state::fitting::kept::short_variant_name;
use crate::app::state::fitting::settings::{FitSettings, widest_bounds};
use crate::app::widgets::compare;
use crate::app::widgets::controls::{plain_number, tick_ui};
use crate::app::widgets::paint::rich_text_job;
use crate::brdf::{Brdf, Param, ParamId};
use crate::figure::text::RichText;
use crate::fit::options::Bounds;
use crate::fit::{Variant, WEIGHTS};
use std::collections::BTreeMap;

/// Least and greatest grazing limit that is offered, in degrees.
const LIMIT_DEG: std::ops::RangeInclusive<f64> = 20.0..=90.0;

/// Draws the heading with the buttons.
pub fn head_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        ui.heading("Fit");
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            buttons_ui(ui, state, out);
            let Some((_, opened)) = state.current() else {
                return;
            };
            let variant = short_variant_name(Variant::from(&opened.brdf));
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                let name = egui::RichText::new(&variant).weak();
                ui.add(egui::Label::new(name).truncate())
                    .on_hover_text(format!("{variant}: the model that is fitted"));
            });
        });
    });
}

/// Draws the settings, the stages and the result, over all of the room.
pub fn fit_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let Some((_, opened)) = state.current() else {
        ui.weak("Open a material to fit a model to it.");
        return;
    };
    egui::ScrollArea::vertical()
        .id_salt("fit")
        .auto_shrink([false, false])
        .show(ui, |ui| {
            let before = &state.fit.settings;
            let mut settings = before.clone();
            weight_ui(ui, &mut settings);
            if free_ui(ui, &mut settings, &opened.brdf) {
                more_ui(ui, &mut settings, &opened.brdf);
            }
            fit_stages::stages_ui(ui, state, &mut settings);
            fit_result::result_ui(ui, state, out);
            if settings != *before {
                out.push(Msg::Fit(FitMsg::Settings(settings)));
            }
        });
}

/// The buttons that start and stop a fit, from the right.
pub fn buttons_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let running = state.fit.run.as_ref().is_some_and(|run| !run.stopping);
    let (command, name, label) = if running {
        (Command::CancelFit, "Cancel", "Stop the fit")
    } else {
        (Command::Fit, "Fit", "Start the fit")
    };
    let main = egui::Button::new(name).min_size(egui::vec2(64.0, 0.0));
    let main = main.selected(!running);
    button_ui(ui, state, command, main, (label, state.fit_blocked()), out);
    compare::choice_ui(ui, state, "panel", out);
    let why_not = state.comparison_blocked();
    let (command, text) = (Command::Compare, egui::Button::new("Compare"));
    button_ui(ui, state, command, text, ("Start to compare", why_not), out);
}

/// Draws the button of a command. `name` is for screen readers, where a menu has an entry of the same word.
fn button_ui(
    ui: &mut egui::Ui,
    state: &State,
    command: Command,
    button: egui::Button,
    (name, why_not): (&str, Option<&str>),
    out: &mut Vec<Msg>,
) {
    let response = ui
        .add_enabled(command.is_enabled(state), button)
        .on_hover_text(command.hint(ui.ctx()))
        .on_disabled_hover_text(why_not.unwrap_or_default());
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label(name));
    if response.clicked() {
        out.push(Msg::Run(command));
    }
}

fn weight_ui(ui: &mut egui::Ui, settings: &mut FitSettings) {
    ui.horizontal(|ui| {
        ui.label("Weight");
        let menu = egui::ComboBox::from_id_salt("weight")
            .width(92.0)
            .selected_text(settings.weight.name());
        let menu = menu.show_ui(ui, |ui| {
            for weight in WEIGHTS {
                ui.selectable_value(&mut settings.weight, weight, weight.name())
                    .on_hover_text(weight.help());
            }
        });
        ui.ctx()
            .accesskit_node_builder(menu.response.id, |node| node.set_label("Weight"));
        menu.response.on_hover_text(settings.weight.help());
        let label = ui.label("Limit");
        let mut degrees = settings.limit.to_degrees();
        let drag = egui::DragValue::new(&mut degrees)
            .speed(0.2)
            .range(LIMIT_DEG)
            .suffix("°")
            .max_decimals(1);
        let response = ui.add(drag).labelled_by(label.id).on_hover_text(
            "Grazing limit: cells with θi or θo above it do not count; 90° leaves none out.",
        );
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "Grazing limit")
        });
        if response.changed() {
            settings.limit = degrees.to_radians();
        }
    });
}

/// A tick per parameter; returns whether start and bounds are to be shown.
fn free_ui(ui: &mut egui::Ui, settings: &mut FitSettings, brdf: &Brdf) -> bool {
    let id = egui::Id::unique("start and bounds");
    let mut open = ui.data(|data| data.get_temp(id)).unwrap_or(false);
    ui.horizontal_wrapped(|ui| {
        ui.label("Free")
            .on_hover_text("What the fit may move. The rest keeps the value of its slider.");
        ui.spacing_mut().item_spacing.x = 10.0;
        for row in brdf.model.rows() {
            let mut free = !settings.held.contains(&row.id);
            ui.add_enabled_ui(brdf.uses(row.id), |ui| {
                let tick = tick_ui(ui, &mut free, row.symbol, &format!("{} free", row.key()))
                    .on_hover_text(format!("Let the fit find the {}", row.name));
                if tick.changed() {
                    settings.hold(row.id, !free);
                }
            });
        }
        let more = ui.selectable_label(open, "More");
        if more.on_hover_text("Start and bounds").clicked() {
            open = !open;
            ui.data_mut(|data| data.insert_temp(id, open));
        }
    });
    open
}

/// Settings that are seldom changed: where the fit begins, and bounds.
fn more_ui(ui: &mut egui::Ui, settings: &mut FitSettings, brdf: &Brdf) {
    egui::Frame::group(ui.style()).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.checkbox(&mut settings.from_sliders, "Start from sliders")
            .on_hover_text(Command::ToggleFromSliders.hint(ui.ctx()));
        egui::Grid::new("bounds")
            .num_columns(4)
            .spacing([8.0, 3.0])
            .show(ui, |ui| {
                ui.weak("");
                ui.weak("least");
                ui.weak("most");
                ui.end_row();
                for row in brdf.model.rows().filter(|row| !row.id.is_color()) {
                    bounds_ui(ui, row, &mut settings.bounds);
                    ui.end_row();
                }
            });
    });
}

fn bounds_ui(ui: &mut egui::Ui, row: &Param, all: &mut BTreeMap<ParamId, Bounds>) {
    let color = ui.visuals().text_color();
    ui.label(rich_text_job(&RichText::parse(row.symbol), 13.5, color));
    let bounds = all.get(&row.id).copied();
    let (mut low, mut high) = bounds.unwrap_or(row.bounds);
    let (least, most) = widest_bounds(row);
    let mut changed = false;
    let (lowest, highest) = (low, high);
    let ends = [
        (&mut low, least, highest, "least"),
        (&mut high, lowest, most, "most"),
    ];
    for (value, from, to, end) in ends {
        let speed = 0.005 * value.abs().max(1.0);
        let drag = egui::DragValue::new(value)
            .speed(speed)
            .range(from..=to)
            .custom_formatter(|value, _| plain_number(value));
        let response = ui.add(drag);
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::SpinButton, true, format!("{} {end}", row.key()))
        });
        changed |= response.changed();
    }
    if changed {
        all.insert(row.id, (low, high));
    }
    let reset = ui.add_enabled(bounds.is_some(), egui::Button::new("Reset").small());
    reset.widget_info(|| {
        egui::WidgetInfo::labeled(
            egui::Role::Button,
            true,
            format!("Reset bounds of {}", row.key()),
        )
    });
    if reset.on_hover_text("Back to the default bounds").clicked() {
        all.remove(&row.id);
    }
}
