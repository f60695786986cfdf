//! The dialog that makes a figure for a paper: its views and looks at the left, the very sheet at the right.

use crate::app::msg::Msg;
use crate::app::msg::cache::request;
use crate::app::msg::figure::FigureMsg;
use crate::app::paper::figure::figure_of;
use crate::app::paper::work::{FigurePreview, PreviewQuery};
use crate::app::state::State;
use crate::app::state::figure::FigurePrefs;
use crate::app::state::views::{VIEWS, ViewId};
use crate::app::widgets::paint::pictures::paint_picture;
use crate::export::{FORMATS, FigureFormat};
use crate::figure::page::{COLUMNS, INKS, SAME_AXES};
use crate::figure::write::POINTS_PER_MM;
use egui::{Align2, Color32, FontId, Rect, Sense, Stroke, StrokeKind, vec2};

/// Height of the line below the sheet.
const FOOTER: f32 = 22.0;
/// Width of the controls in points.
const CONTROLS: f32 = 268.0;
const MM_PER_INCH: f64 = 25.4;

/// Draws the dialog.
pub fn figure_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let window = ui.ctx().content_rect().size();
    let size = vec2((window.x - 90.0).min(1080.0), (window.y - 150.0).min(640.0));
    ui.set_width(size.x);
    ui.heading("Export figure");
    ui.add_space(4.0);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let (left, right) = rect.split_left_right_at_x(rect.left() + CONTROLS);
    let mut controls = ui.new_child(egui::UiBuilder::new().max_rect(left));
    // A low window has them behind a bar.
    egui::ScrollArea::vertical().show(&mut controls, |ui| controls_ui(ui, state, out));
    let mut preview = ui.new_child(egui::UiBuilder::new().max_rect(right));
    let room = right.shrink2(vec2(12.0, 0.0)).size() - vec2(0.0, FOOTER);
    preview.add_space(2.0);
    preview.horizontal(|ui| {
        ui.add_space(18.0);
        preview_ui(ui, state, room, out);
    });
}

fn controls_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.set_width(CONTROLS - 14.0);
    views_ui(ui, state, out);
    ui.add_space(6.0);
    let mut prefs = state.prefs.figure.clone();
    egui::Grid::new("figure")
        .num_columns(2)
        .spacing([12.0, 6.0])
        .show(ui, |ui| looks_ui(ui, &mut prefs));
    let style = &mut prefs.style;
    ui.checkbox(&mut style.legend, "Legend");
    ui.checkbox(&mut style.letters, "Letters (a), (b), …");
    ui.checkbox(&mut style.transparent, "Transparent page");
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        for format in FORMATS {
            let response = ui.selectable_label(prefs.format == format, format.name());
            if response.on_hover_text(help(format)).clicked() {
                prefs.format = format;
            }
        }
    });
    ui.add_space(2.0);
    let can = !state.views.chosen.is_empty();
    let button = egui::Button::new("Export…").min_size(vec2(110.0, 0.0));
    let hint = "The figure, and beside it a .figure.json that draws it again";
    if ui.add_enabled(can, button).on_hover_text(hint).clicked() {
        out.push(Msg::Figure(FigureMsg::Export));
    }
    if prefs != state.prefs.figure {
        out.push(Msg::Figure(FigureMsg::Set(prefs)));
    }
}

fn help(format: FigureFormat) -> &'static str {
    match format {
        FigureFormat::Svg => "Lines and text, for drawing programs and the web",
        FigureFormat::Pdf => "Lines and text, for LaTeX",
        FigureFormat::Png => "Pixels, for slides",
        FigureFormat::Csv => "The numbers that are drawn",
        FigureFormat::Exr => "A sphere alone, in linear light",
    }
}

/// The views in the order in which they are ticked.
fn views_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let chosen = &state.views.chosen;
    let mut changed = chosen.clone();
    let drawable = VIEWS.iter().filter(|row| row.id != ViewId::Fits);
    egui::Grid::new("views")
        .num_columns(2)
        .spacing([12.0, 3.0])
        .show(ui, |ui| {
            for (k, row) in drawable.enumerate() {
                let mut on = chosen.contains(&row.id);
                let can = state.can_draw(row.id);
                let text = row.name;
                let response = ui.add_enabled(can, egui::Checkbox::new(&mut on, text));
                if response.on_hover_text(row.help[0]).changed() {
                    changed.retain(|pane| *pane != row.id);
                    if on {
                        changed.push(row.id);
                    }
                }
                if k % 2 == 1 {
                    ui.end_row();
                }
            }
        });
    if changed != *chosen {
        out.push(Msg::Figure(FigureMsg::Choose(changed)));
    }
}

fn looks_ui(ui: &mut egui::Ui, prefs: &mut FigurePrefs) {
    let FigurePrefs { style, columns, .. } = prefs;
    let label = ui.label("Width");
    ui.horizontal(|ui| {
        ui.add(number(&mut style.width_mm, 0.5, [20.0, 2000.0], " mm"))
            .labelled_by(label.id);
        let mut inches = style.width_mm / MM_PER_INCH;
        let field = egui::DragValue::new(&mut inches)
            .speed(0.02)
            .range(0.8..=78.0)
            .max_decimals(2)
            .suffix(" in");
        if ui.add(field).changed() {
            style.width_mm = inches * MM_PER_INCH;
        }
    });
    ui.end_row();
    ui.label("");
    ui.horizontal(|ui| {
        for (name, width) in COLUMNS {
            if ui.selectable_label(style.width_mm == width, name).clicked() {
                style.width_mm = width;
            }
        }
    });
    ui.end_row();
    let label = ui.label("In a row");
    ui.add(
        egui::DragValue::new(columns)
            .speed(0.05)
            .range(FigurePrefs::COLUMNS),
    )
    .labelled_by(label.id)
    .on_hover_text("How many views stand beside each other");
    ui.end_row();
    for (name, value, step, range, suffix) in [
        ("Font", &mut style.font_pt, 0.1, [3.0, 72.0], " pt"),
        ("Curves", &mut style.line_pt, 0.02, [0.05, 20.0], " pt"),
        ("Pictures", &mut style.dpi, 2.0, [30.0, 2400.0], " dpi"),
    ] {
        let label = ui.label(name);
        ui.add(number(value, step, range, suffix))
            .labelled_by(label.id);
        ui.end_row();
    }
    ui.label("Colours");
    ui.horizontal(|ui| {
        for inks in INKS {
            if ui
                .selectable_label(style.palette == inks, inks.name())
                .clicked()
            {
                style.palette = inks;
            }
        }
    });
    ui.end_row();
    ui.label("Same axes");
    egui::ComboBox::from_id_salt("same axes")
        .selected_text(style.same_axes.name())
        .show_ui(ui, |ui| {
            for axes in SAME_AXES {
                ui.selectable_value(&mut style.same_axes, axes, axes.name());
            }
        });
    ui.end_row();
}

fn number<'a>(
    value: &'a mut f64,
    step: f64,
    [low, high]: [f64; 2],
    suffix: &'static str,
) -> egui::DragValue<'a> {
    egui::DragValue::new(value)
        .speed(step)
        .range(low..=high)
        .max_decimals(1)
        .suffix(suffix)
}

/// The sheet as it will be written, as large as there is room.
fn preview_ui(ui: &mut egui::Ui, state: &State, room: egui::Vec2, out: &mut Vec<Msg>) {
    let (rect, response) = ui.allocate_exact_size(room, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Preview"));
    let weak = ui.visuals().weak_text_color();
    let say = |text: &str| {
        let font = FontId::proportional(14.0);
        ui.painter()
            .text(rect.center(), Align2::CENTER_CENTER, text, font, weak);
    };
    let prefs = &state.prefs.figure;
    let drawable = figure_of(state, &state.views.chosen, prefs.columns, &prefs.style);
    let Some(drawable) = drawable else {
        say("Tick a view to see it on paper.");
        return;
    };
    // A pixel of the preview is one of the screen where the page is as wide as the room.
    let across = f64::from(room.x * ui.ctx().pixels_per_point());
    let dpi = (across * 72.0 / (prefs.style.width_mm * POINTS_PER_MM)).clamp(40.0, 400.0);
    let query = PreviewQuery {
        drawable,
        dpi: dpi.round(),
    };
    request(&state.caches, &query, out);
    match state.caches.shown(&query) {
        None => say("Drawing…"),
        Some((Err(error), _)) => say(error),
        Some((Ok(sheet), fresh)) => {
            sheet_ui(ui, rect, sheet, fresh);
            let [width, height] = sheet.size_mm;
            let numbers = match sheet.numbers {
                0 => String::new(),
                rows => format!(", {rows} rows of numbers"),
            };
            let text = format!("{width:.0} × {height:.0} mm{numbers}");
            let font = FontId::proportional(12.0);
            let at = rect.left_bottom() + vec2(0.0, 18.0);
            ui.painter().text(at, Align2::LEFT_BOTTOM, text, font, weak);
        }
    }
}

fn sheet_ui(ui: &egui::Ui, rect: Rect, sheet: &FigurePreview, fresh: bool) {
    let size = [sheet.pixels.width as f32, sheet.pixels.height as f32];
    let scale = (rect.width() / size[0]).min(rect.height() / size[1]);
    let paper = Rect::from_center_size(rect.center(), vec2(size[0], size[1]) * scale);
    let painter = ui.painter();
    painter.rect_filled(paper, 0.0, Color32::from_gray(226));
    let size = [sheet.pixels.width, sheet.pixels.height].map(|n| n as usize);
    paint_picture(painter, paper, size, &sheet.pixels.rgba, true);
    if !fresh {
        painter.rect_filled(paper, 0.0, Color32::from_white_alpha(90));
    }
    let line = Stroke::new(1.0, ui.visuals().weak_text_color());
    painter.rect_stroke(paper, 0.0, line, StrokeKind::Outside);
}
