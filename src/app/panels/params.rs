//! The rows of the parameters: symbol, slider and number; a colour has one slider for its brightness, and opens into its
//! channels.

use crate::app::lessons::LookAt;
use crate::app::msg::Msg;
use crate::app::panels::lesson;
use crate::app::state::State;
use crate::app::state::material::Opened;
use crate::app::widgets::controls::plain_number;
use crate::app::widgets::paint::rich_text_job;
use crate::brdf::params::Scale;
use crate::brdf::{Param, ParamId};
use crate::figure::text::RichText;
use crate::geom::Rgb;
use crate::geom::color::srgb_bytes;
use egui::{Color32, Id, Label, Response, Sense, Slider, SliderClamping, Ui, WidgetInfo, vec2};

const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// Width in points of what stands left of a slider: a symbol, and the swatch of a colour.
const NAME: f32 = 50.0;

/// Room in points for a slider's number and the gap before it. A row that is wider than the panel makes it grow.
const NUMBER_BOX: f32 = 74.0;

/// Draws the rows of the colours, or of the parameters that all channels share.
pub fn params_ui(ui: &mut Ui, state: &State, opened: &Opened, colors: bool, out: &mut Vec<Msg>) {
    let brdf = &opened.brdf;
    for row in brdf.model.rows().filter(|row| row.id.is_color() == colors) {
        let follows = state.fit.keep_optimal && colors;
        let top = ui.cursor().min;
        ui.add_enabled_ui(brdf.uses(row.id) && !follows, |ui| {
            match *brdf.get(row.id) {
                [r, g, b] => color_ui(ui, row, opened, [r, g, b], out),
                [value, ..] => number_ui(ui, row, value, out),
                [] => {}
            }
        });
        lesson::frame_from(ui, top, state.looks_at(LookAt::Param(row.id)));
    }
}

fn number_ui(ui: &mut Ui, row: &Param, value: f64, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        let name = cell_ui(ui, |ui| name_ui(ui, row, out));
        if let Some(value) = slider_ui(ui, row, row.key(), &name, value) {
            out.push(Msg::SetParam {
                id: row.id,
                channel: None,
                value,
            });
        }
    });
}

fn color_ui(ui: &mut Ui, row: &Param, opened: &Opened, rgb: Rgb, out: &mut Vec<Msg>) {
    let id = Id::unique(("channels", row.key()));
    let mut open = ui.data(|data| data.get_temp(id)).unwrap_or(false);
    ui.horizontal(|ui| {
        let name = cell_ui(ui, |ui| {
            let name = name_ui(ui, row, out);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if swatch_ui(ui, row, rgb, open).clicked() {
                    open = !open;
                    ui.data_mut(|data| data.insert_temp(id, open));
                }
            });
            name
        });
        let hue = hue(ui, (opened, row.id), rgb);
        if let Some(value) = slider_ui(ui, row, row.key(), &name, largest(rgb)) {
            out.push(Msg::SetColor {
                id: row.id,
                rgb: hue.map(|share| share * value),
            });
        }
    });
    if !open {
        return;
    }
    for (channel, (letter, value)) in CHANNELS.iter().zip(rgb).enumerate() {
        ui.horizontal(|ui| {
            let name = cell_ui(ui, |ui| {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    ui.add_space(16.0);
                    ui.add(Label::new(*letter).selectable(false))
                })
                .inner
            });
            let label = format!("{} {letter}", row.key());
            if let Some(value) = slider_ui(ui, row, &label, &name, value) {
                out.push(Msg::SetParam {
                    id: row.id,
                    channel: Some(channel),
                    value,
                });
            }
        });
    }
    ui.horizontal(|ui| {
        ui.add_space(NAME + ui.spacing().item_spacing.x);
        let grey = ui.small_button("Make grey");
        grey.widget_info(|| {
            WidgetInfo::labeled(egui::Role::Button, true, format!("{} grey", row.key()))
        });
        if grey
            .on_hover_text("Give red, green and blue one value, of the same luminance")
            .clicked()
        {
            out.push(Msg::MakeGrey(row.id));
        }
    });
}

/// The brightness that a colour's slider sets.
fn largest([r, g, b]: Rgb) -> f64 {
    r.max(g).max(b)
}

/// The colour over its largest channel. Black has none: it keeps the one that it was darkened from.
fn hue(ui: &Ui, (opened, param): (&Opened, ParamId), rgb: Rgb) -> Rgb {
    let id = Id::unique(("hue", opened.id, param));
    let largest = largest(rgb);
    if largest > 0.0 {
        let hue = rgb.map(|value| value / largest);
        ui.data_mut(|data| data.insert_temp(id, hue));
        return hue;
    }
    ui.data(|data| data.get_temp(id)).unwrap_or([1.0; 3])
}

/// The part of a row that is left of its slider.
fn cell_ui(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> Response) -> Response {
    let size = vec2(NAME, ui.spacing().interact_size.y);
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let cell = ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_width(NAME);
        add(ui)
    });
    cell.inner
}

/// The symbol, with what it means for hovering.
fn name_ui(ui: &mut Ui, row: &Param, out: &mut Vec<Msg>) -> Response {
    let color = ui.visuals().text_color();
    let job = rich_text_job(&RichText::parse(row.symbol), 15.0, color);
    let label = Label::new(job).selectable(false).sense(Sense::click());
    let name = ui.add(label).on_hover_ui(|ui| {
        ui.strong(row.name);
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
    name.widget_info(|| WidgetInfo::labeled(egui::Role::Label, ui.is_enabled(), row.name));
    if name.double_clicked() {
        out.push(Msg::ResetParam(row.id));
    }
    name
}

/// A slider with its number; the new value where it changed.
fn slider_ui(ui: &mut Ui, row: &Param, label: &str, name: &Response, value: f64) -> Option<f64> {
    let mut changed = value;
    ui.spacing_mut().slider_width = (ui.available_width() - NUMBER_BOX).max(60.0);
    ui.spacing_mut().interact_size.x = NUMBER_BOX - ui.spacing().item_spacing.x;
    let mut slider = Slider::new(&mut changed, row.range.0..=row.range.1)
        .clamping(SliderClamping::Never)
        .custom_formatter(|value, _| plain_number(value));
    if let Scale::Log { smallest_exponent } = row.scale {
        slider = slider
            .logarithmic(true)
            .smallest_positive(10f64.powi(smallest_exponent));
    }
    let response = ui.add(slider).labelled_by(name.id);
    // Named for screen readers and tests.
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label(label));
    // A drag may pass the slider's ends by typing only; what is accepted is the row's business.
    changed = row.clamp(changed);
    (changed != value).then_some(changed)
}

/// The colour as bright as its largest channel allows, with a wedge that points to its channels.
fn swatch_ui(ui: &mut Ui, row: &Param, rgb: Rgb, open: bool) -> Response {
    let largest = largest(rgb).max(1.0);
    let [r, g, b] = srgb_bytes(rgb.map(|value| value / largest));
    let size = vec2(24.0, ui.spacing().interact_size.y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| {
        let label = format!("{} channels", row.key());
        WidgetInfo::selected(egui::Role::Button, ui.is_enabled(), open, label)
    });
    let look = ui.style().interact(&response);
    let field = egui::Rect::from_center_size(rect.center() - vec2(5.0, 0.0), vec2(14.0, 14.0));
    let color = Color32::from_rgb(r, g, b);
    let border = ui.visuals().widgets.inactive.fg_stroke.color;
    ui.painter().rect(
        field,
        3.0,
        color,
        egui::Stroke::new(1.0, border.gamma_multiply(0.6)),
        egui::StrokeKind::Inside,
    );
    let middle = rect.right_center() - vec2(5.0, 0.0);
    let wedge = if open {
        [vec2(-3.5, -2.0), vec2(3.5, -2.0), vec2(0.0, 3.0)]
    } else {
        [vec2(-2.0, -3.5), vec2(3.0, 0.0), vec2(-2.0, 3.5)]
    };
    ui.painter().add(egui::Shape::convex_polygon(
        wedge.map(|corner| middle + corner).to_vec(),
        look.fg_stroke.color,
        egui::Stroke::NONE,
    ));
    response.on_hover_text("Red, green and blue")
}
