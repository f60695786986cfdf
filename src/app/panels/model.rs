//! The model: its formula with live numbers and a slider per parameter row.

use crate::app::command::{Command, ENTRIES};
use crate::app::lessons::LookAt;
use crate::app::msg::Msg;
use crate::app::panels::lesson;
use crate::app::state::{Scene, State};
use crate::app::widgets::formula;
use crate::app::widgets::paint::rich_text_job;
use crate::brdf::params::Scale;
use crate::brdf::{Brdf, Param, params};
use crate::figure::text::RichText;
use crate::geom::color::srgb_bytes;
use egui::{Align, Color32, Layout, Slider, SliderClamping};

const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// Room in points for a slider's number and the gap before it. A row that is wider than the panel makes it grow.
const NUMBER_BOX: f32 = 84.0;

/// Draws the panel.
pub fn model_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.add_space(6.0);
    ui.heading("Model");
    ui.add_space(4.0);
    let Some((_, opened)) = state.current() else {
        ui.weak("Open a material to lay a model over it.");
        return;
    };
    let brdf = &opened.brdf;
    egui::ScrollArea::vertical()
        .auto_shrink([false, true])
        .show(ui, |ui| {
            let top = ui.cursor().min;
            choices_ui(ui, state, out);
            ui.add_space(6.0);
            formula_ui(ui, brdf);
            frame_from(ui, top, state.looks_at(LookAt::Model));
            ui.add_space(6.0);
            // The shape first: it is dragged most, and has to be in sight above the fit.
            params_ui(ui, state, brdf, false, out);
            optimal_ui(ui, state, out);
            params_ui(ui, state, brdf, true, out);
            ui.separator();
            derived_ui(ui, brdf);
            ui.add_space(6.0);
            ui.horizontal(|ui| {
                for (command, name) in [
                    (Command::GuessParams, "Guess from data"),
                    (Command::ResetParams, "Reset"),
                ] {
                    if ui
                        .button(name)
                        .on_hover_text(command.hint(ui.ctx()))
                        .clicked()
                    {
                        out.push(Msg::Run(command));
                    }
                }
            });
            ui.add_space(6.0);
        });
}

/// The models and Fresnel factors as rows of buttons, from the command list.
fn choices_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    for (submenu, label) in [("", ""), ("Fresnel", "Fresnel")] {
        ui.horizontal(|ui| {
            if !label.is_empty() {
                ui.label(label);
            }
            for entry in ENTRIES
                .iter()
                .filter(|e| e.menu == "Model" && e.submenu == submenu)
            {
                let checked = entry.command.is_checked(state).unwrap_or(false);
                let response = ui.selectable_label(checked, &*entry.name);
                if response
                    .on_hover_text(entry.command.hint(ui.ctx()))
                    .clicked()
                    && !checked
                {
                    out.push(Msg::Run(entry.command));
                }
            }
        });
    }
}

/// The sliders of the colours, or of the parameters that all channels share.
fn params_ui(ui: &mut egui::Ui, state: &State, brdf: &Brdf, colors: bool, out: &mut Vec<Msg>) {
    for row in params::ALL.iter().filter(|row| row.id.is_color() == colors) {
        // The model's own row where it has one: ranges differ. The rest is shown greyed.
        let row = brdf.model.param(row.id).unwrap_or(row);
        let follows = state.fit.keep_optimal && colors;
        let top = ui.cursor().min;
        ui.add_enabled_ui(brdf.uses(row.id) && !follows, |ui| {
            param_ui(ui, &state.scene, brdf, row, out);
        });
        frame_from(ui, top, state.looks_at(LookAt::Param(row.id)));
        ui.add_space(4.0);
    }
}

fn optimal_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let command = Command::ToggleKeepOptimal;
    let mut on = state.fit.keep_optimal;
    let tick = crate::app::panels::fit::tick_ui(
        ui,
        &mut on,
        "keep ρ_{d}, k_{s} optimal",
        "keep rho_d, k_s optimal",
    );
    if tick.on_hover_text(command.hint(ui.ctx())).changed() {
        out.push(Msg::Run(command));
    }
    ui.add_space(4.0);
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

/// Frames what was drawn since, if a lesson speaks of it.
fn frame_from(ui: &egui::Ui, top: egui::Pos2, framed: bool) {
    if framed {
        let bottom = egui::pos2(ui.max_rect().right(), ui.min_rect().bottom());
        lesson::frame(ui, egui::Rect::from_min_max(top, bottom).expand(3.0));
    }
}

fn param_ui(ui: &mut egui::Ui, scene: &Scene, brdf: &Brdf, row: &Param, out: &mut Vec<Msg>) {
    let values = brdf.params.get(row.id);
    // Colours that came from elsewhere, from a guess or an undo, are not grey because a box is ticked.
    let is_grey = values.iter().all(|value| *value == values[0]);
    let linked = scene.linked_channels.get(row.id);
    let linked = linked.map(|linked| linked && is_grey);
    let name = ui.horizontal(|ui| {
        let text = format!("{}  {}", row.symbol, row.name);
        let job = rich_text_job(&RichText::parse(&text), 13.5, ui.visuals().text_color());
        let name = ui.add(
            egui::Label::new(job)
                .selectable(false)
                .sense(egui::Sense::click()),
        );
        let name = name.on_hover_ui(|ui| {
            ui.label(row.help);
            let unit = if row.unit.is_empty() {
                String::new()
            } else {
                format!(" {}", row.unit)
            };
            ui.weak(format!(
                "{} to {}{unit}. Double click: {}.",
                row.range.0, row.range.1, row.default
            ));
        });
        if name.double_clicked() {
            out.push(Msg::ResetParam(row.id));
        }
        if let Some(linked) = linked {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let mut ticked = linked;
                let toggle = ui
                    .checkbox(&mut ticked, "grey")
                    .on_hover_text("Move red, green and blue as one");
                toggle.widget_info(|| {
                    egui::WidgetInfo::selected(
                        egui::Role::CheckBox,
                        true,
                        linked,
                        format!("{} grey", row.key),
                    )
                });
                if toggle.changed() {
                    out.push(Msg::SetLinkedChannels(row.id, ticked));
                }
                swatch_ui(ui, values);
            });
        }
        name
    });
    let channels: Vec<Option<usize>> = match linked {
        Some(false) => (0..values.len()).map(Some).collect(),
        _ => vec![None],
    };
    for channel in channels {
        ui.horizontal(|ui| {
            let label = channel.map_or(row.key.to_string(), |k| {
                format!("{} {}", row.key, CHANNELS[k])
            });
            if let Some(k) = channel {
                ui.monospace(CHANNELS[k]);
            }
            let mut value = values[channel.unwrap_or(0)];
            let before = value;
            let response = slider_ui(ui, row, &mut value).labelled_by(name.response.id);
            // Named for screen readers and tests.
            ui.ctx()
                .accesskit_node_builder(response.id, |node| node.set_label(label.as_str()));
            if value != before {
                out.push(Msg::SetParam {
                    id: row.id,
                    channel,
                    value,
                });
            }
        });
    }
}

fn slider_ui(ui: &mut egui::Ui, row: &Param, value: &mut f64) -> egui::Response {
    ui.spacing_mut().slider_width = (ui.available_width() - NUMBER_BOX).max(60.0);
    let mut slider = Slider::new(value, row.range.0..=row.range.1)
        .clamping(SliderClamping::Never)
        .custom_formatter(|value, _| plain_number(value));
    if let Scale::Log { smallest_exponent } = row.scale {
        slider = slider
            .logarithmic(true)
            .smallest_positive(10f64.powi(smallest_exponent));
    }
    let response = ui.add(slider);
    // A drag may pass the slider's ends by typing only; what is accepted is the row's business.
    *value = row.clamp(*value);
    response
}

/// Three significant digits, four where they are free; short enough for [`NUMBER_BOX`].
pub(crate) fn plain_number(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let digits = value.abs().log10().floor() as i32;
    if !(-4..7).contains(&digits) {
        return format!("{value:.1e}");
    }
    let decimals = if digits < 0 { 2 - digits } else { 3 - digits };
    format!("{value:.*}", decimals.clamp(0, 6) as usize)
}

/// The colour, as bright as its largest channel allows.
fn swatch_ui(ui: &mut egui::Ui, values: &[f64]) {
    let [r, g, b] = *values else { return };
    let largest = r.max(g).max(b).max(1.0);
    let [r, g, b] = srgb_bytes([r / largest, g / largest, b / largest]);
    let (rect, _) = ui.allocate_exact_size(egui::vec2(26.0, 13.0), egui::Sense::hover());
    let stroke = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().rect(
        rect,
        3.0,
        Color32::from_rgb(r, g, b),
        stroke,
        egui::StrokeKind::Inside,
    );
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
