//! Controls that several tiles have.

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::Probe;
use crate::app::widgets::formula::number;
use crate::app::widgets::paint;
use crate::figure::cosine::CosineFactor;
use crate::figure::subject::{CHANNELS, Channel};
use crate::figure::text::RichText;
use crate::geom::Rgb;
use egui::PopupCloseBehavior;
use egui::containers::menu::{MenuButton, MenuConfig};
use std::ops::RangeInclusive;

/// The choice of a channel; the new one where it changed.
pub fn channel_ui(ui: &mut egui::Ui, channel: Channel) -> Option<Channel> {
    let choices = CHANNELS.map(|channel| (channel, channel.name()));
    choice_ui(ui, "Channel", channel, &choices)
}

/// The cosines that f_r is multiplied by; the new ones where they changed.
pub fn cosine_ui(ui: &mut egui::Ui, cosine: CosineFactor) -> Option<CosineFactor> {
    let mut changed = cosine;
    ui.checkbox(&mut changed.theta_i, "× cos θi")
        .on_hover_text("Multiply f_r by the cosine of the angle of incidence");
    ui.checkbox(&mut changed.theta_o, "× cos θo")
        .on_hover_text("Multiply f_r by the cosine of the view angle: the cosine-corrected BRDF");
    (changed != cosine).then_some(changed)
}

/// A drop-down list with a name for screen readers; the new value where it changed.
pub fn choice_ui<T: Copy + PartialEq>(
    ui: &mut egui::Ui,
    name: &str,
    value: T,
    choices: &[(T, &str)],
) -> Option<T> {
    sized_choice_ui(ui, name, value, choices, 92.0)
}

/// A drop-down list of a width in points, otherwise as [`choice_ui`].
pub fn sized_choice_ui<T: Copy + PartialEq>(
    ui: &mut egui::Ui,
    name: &str,
    value: T,
    choices: &[(T, &str)],
    width: f32,
) -> Option<T> {
    let mut chosen = value;
    let shown = choices.iter().find(|(choice, _)| *choice == value);
    let menu = egui::ComboBox::from_id_salt(name)
        .width(width)
        .selected_text(shown.map_or("", |(_, text)| *text));
    let menu = menu.show_ui(ui, |ui| {
        for (choice, text) in choices {
            ui.selectable_value(&mut chosen, *choice, *text);
        }
    });
    ui.ctx()
        .accesskit_node_builder(menu.response.id, |node| node.set_label(name));
    (chosen != value).then_some(chosen)
}

/// A button with a menu that stays open from tick to tick.
pub fn tick_menu_ui(
    ui: &mut egui::Ui,
    text: &str,
    content: impl FnOnce(&mut egui::Ui),
) -> egui::Response {
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    MenuButton::new(text).config(config).ui(ui, content).0
}

/// A check box with a marked-up label, named for screen readers and tests.
pub fn tick_ui(ui: &mut egui::Ui, on: &mut bool, markup: &str, name: &str) -> egui::Response {
    let color = if ui.is_enabled() {
        ui.visuals().text_color()
    } else {
        ui.visuals().weak_text_color()
    };
    let job = paint::rich_text_job(&RichText::parse(markup), 13.5, color);
    let tick = ui.checkbox(on, egui::WidgetText::from(job));
    let (is_enabled, is_on) = (ui.is_enabled(), *on);
    tick.widget_info(|| egui::WidgetInfo::selected(egui::Role::CheckBox, is_enabled, is_on, name));
    tick
}

/// One of several choices that commands make; `chosen` where it is the one that is shown.
pub fn command_choice_ui(
    ui: &mut egui::Ui,
    command: Command,
    name: &str,
    chosen: bool,
    out: &mut Vec<Msg>,
) {
    let response = ui.selectable_label(chosen, name);
    if response.on_hover_text(command.hint(ui.ctx())).clicked() && !chosen {
        out.push(Msg::Run(command));
    }
}

/// A symbol such as `θ_{i}`.
pub fn symbol_ui(ui: &mut egui::Ui, markup: &str) {
    let color = ui.visuals().text_color();
    ui.label(paint::rich_text_job(&RichText::parse(markup), 14.0, color));
}

/// An angle that is dragged in degrees; the new one in radians where it changed.
pub fn angle_ui(
    ui: &mut egui::Ui,
    name: &str,
    help: &str,
    angle: f64,
    range_deg: RangeInclusive<f64>,
) -> Option<f64> {
    let mut degrees = angle.to_degrees();
    let drag = egui::DragValue::new(&mut degrees)
        .speed(0.2)
        .range(range_deg)
        .suffix("°")
        .fixed_decimals(0);
    let response = ui.add(drag).on_hover_text(help);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, name));
    response.changed().then(|| degrees.to_radians())
}

/// Measured value and value of the model at a probe, beside the pointer; `head` says where that is.
pub fn values_tooltip(
    response: &egui::Response,
    state: &State,
    probe: Probe,
    channel: Channel,
    head: &str,
) {
    let (measured, model) = state.values_at(probe);
    response.clone().on_hover_ui_at_pointer(|ui| {
        ui.label(format!("{head}, {}", channel.name()));
        let text = |rgb: Rgb| paint::plain(&number(channel.of(rgb)));
        ui.label(measured.map_or("not measured".into(), |rgb| {
            format!("measured {}", text(rgb))
        }));
        ui.label(format!("model {}", model.map_or("–".into(), text)));
    });
}

/// Three significant digits, four where they are free; nine characters at most.
pub fn plain_number(value: f64) -> String {
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
