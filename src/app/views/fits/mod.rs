//! The table of fits of the shown material: one row per variant.

pub mod about;
pub mod columns;
pub mod head;
pub mod rows;

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::msg::fit::FitMsg;
use crate::app::state::State;
use crate::app::state::fitting::kept::{short_variant_name, variant_name};
use crate::app::state::fitting::run::FitRun;
use crate::app::state::fitting::table::Column;
use crate::app::state::subjects::look_beside;
use crate::app::widgets::paint::rich_text_job;
use crate::app::widgets::{compare, controls, empty, fit_details, paint};
use crate::figure::drawing::Drawing;
use crate::figure::palette::{Palette, Role};
use crate::figure::text::RichText;
use columns::Columns;
use egui::{Align, Color32, Layout, Rect, Sense, UiBuilder, Vec2, pos2, vec2};
use head::{ROW, header_ui};
use rows::{FitRow, RowRemark};

/// Draws the tile, which has no place for the probe.
pub fn fits_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let Some((material, _)) = state.current() else {
        let rect = ui.available_rect_before_wrap();
        empty::empty_ui(ui, rect, "Open a material to fit models to it.");
        return false;
    };
    let rows = rows::rows(state);
    toolbar_ui(ui, state, &rows, &material.name, out);
    if rows.is_empty() {
        let rect = ui.available_rect_before_wrap();
        empty::empty_ui(ui, rect, "No fit of this material yet.");
        return false;
    }
    egui::ScrollArea::both()
        .auto_shrink([false, false])
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let columns = Columns::new(ui.available_width(), &shown_columns(state, &rows));
            header_ui(ui, &state.fit.table, &columns, out);
            for row in &rows {
                row_ui(ui, state, row, &columns, out);
            }
        });
    false
}

/// The columns of numbers that are shown for these rows, from left to right.
fn shown_columns(state: &State, rows: &[FitRow]) -> Vec<Column> {
    let hidden = &state.fit.table.hidden;
    Column::all()
        .filter(|column| *column != Column::Name && !hidden.contains(column))
        .filter(|column| columns::is_of_use(*column, rows))
        .collect()
}

fn toolbar_ui(ui: &mut egui::Ui, state: &State, rows: &[FitRow], name: &str, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        let (command, text) = if state.current_run().is_some_and(|run| !run.stopping) {
            (Command::CancelFit, "Cancel")
        } else {
            (Command::Compare, "Compare")
        };
        let button = ui.add_enabled(command.is_enabled(state), egui::Button::new(text));
        let button = button
            .on_hover_text(command.hint(ui.ctx()))
            .on_disabled_hover_text(state.comparison_blocked().unwrap_or_default());
        if button.clicked() {
            out.push(Msg::Run(command));
        }
        compare::choice_ui(ui, state, "fits", out);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            columns_ui(ui, state, rows, out);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                match state.current_run() {
                    Some(run) => {
                        ui.add(egui::ProgressBar::new(run.share()).desired_width(110.0));
                        ui.add(egui::Label::new(under_way(run)).truncate());
                    }
                    None => {
                        let settings = &state.fit.settings;
                        let text = format!(
                            "{name}: weight {}, grazing limit {:.0}°",
                            settings.weight.name().to_lowercase(),
                            settings.limit.to_degrees()
                        );
                        ui.add(egui::Label::new(egui::RichText::new(text).weak()).truncate());
                    }
                }
            });
        });
    });
    ui.add_space(4.0);
}

/// The choice of columns.
fn columns_ui(ui: &mut egui::Ui, state: &State, rows: &[FitRow], out: &mut Vec<Msg>) {
    let button = controls::tick_menu_ui(ui, "Columns", |ui| {
        let of_use = |column: &Column| *column != Column::Name && columns::is_of_use(*column, rows);
        for column in Column::all().filter(of_use) {
            let words = columns::words(column);
            let mut on = !state.fit.table.hidden.contains(&column);
            let name = format!("column {}", column.key());
            let tick = controls::tick_ui(ui, &mut on, &words.head, &name);
            if tick.on_hover_text(words.help).changed() {
                out.push(Msg::Fit(FitMsg::ShowColumn(column, on)));
            }
        }
    });
    button.on_hover_text("Which columns are shown");
}

/// Activity of a run, in words.
fn under_way(run: &FitRun) -> String {
    if run.stopping {
        return "Stopping".into();
    }
    match run.current_part() {
        Some(part) if run.parts.len() > 1 => format!(
            "{} of {}: {}",
            run.at + 1,
            run.parts.len(),
            variant_name(part.variant)
        ),
        Some(part) => variant_name(part.variant),
        None => String::new(),
    }
}

fn row_ui(ui: &mut egui::Ui, state: &State, row: &FitRow, columns: &Columns, out: &mut Vec<Msg>) {
    let name = variant_name(row.variant);
    let (rect, response) = ui.allocate_exact_size(vec2(columns.width, ROW), Sense::click());
    let can_show = row.kept.is_some();
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, can_show, format!("Show {name}"))
    });
    let visuals = ui.visuals().clone();
    if row.shown {
        let fill = visuals.selection.bg_fill.gamma_multiply(0.45);
        ui.painter().rect_filled(rect, 3.0, fill);
    } else if response.hovered() && can_show {
        let fill = visuals.widgets.hovered.weak_bg_fill.gamma_multiply(0.6);
        ui.painter().rect_filled(rect, 3.0, fill);
    }
    let color = match row.mark {
        RowRemark::None | RowRemark::Best => visuals.strong_text_color(),
        RowRemark::Fitting | RowRemark::Cancelled => visuals.text_color(),
        RowRemark::Waiting | RowRemark::Stale => visuals.weak_text_color(),
    };
    tick_ui(ui, state, row, rect, &name, out);
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    let middle = |galley: &egui::Galley| rect.center().y - 0.5 * galley.size().y;

    let mut end = rect.left() + columns.name;
    let written = if columns.narrow {
        short_variant_name(row.variant)
    } else {
        name
    };
    let mut parts = vec![(written, color)];
    parts.extend(
        row.mark
            .text()
            .map(|text| (text.to_string(), tag_color(ui, row.mark))),
    );
    if row
        .kept
        .is_some_and(|kept| !kept.outcome.concerns.is_empty())
    {
        parts.push(("!".into(), visuals.warn_fg_color));
    }
    for (k, (text, color)) in parts.into_iter().enumerate() {
        let size = if k == 0 { 13.5 } else { 12.0 };
        let font = egui::FontId::proportional(size);
        let mut galley = painter.layout_no_wrap(text.clone(), font.clone(), color);
        let room = rect.left() + columns.name_end() - end;
        if k == 0 && galley.size().x > room {
            let cut = crate::figure::text::elided(&text, room / size);
            galley = painter.layout_no_wrap(cut.plain(), font, color);
        } else if galley.size().x > room {
            break;
        }
        let width = galley.size().x;
        painter.galley(pos2(end, middle(&galley)), galley, color);
        end += width + 8.0;
    }
    for (column, right) in &columns.numbers {
        let cell = columns::cell(row, *column);
        let color = if cell.is_some() {
            color
        } else {
            visuals.weak_text_color()
        };
        let text = cell.unwrap_or_else(|| "–".into());
        let job = rich_text_job(&RichText::parse(&text), 13.5, color);
        let galley = painter.layout_job(job);
        let x = rect.left() + right - galley.size().x;
        painter.galley(pos2(x, middle(&galley)), galley, color);
    }
    if let Some(kept) = row.kept {
        let response = response.on_hover_ui(|ui| fit_details::details_ui(ui, state, kept));
        if response.clicked() {
            out.push(Msg::Fit(FitMsg::Show(row.variant)));
        }
    }
}

fn tag_color(ui: &egui::Ui, mark: RowRemark) -> Color32 {
    match mark {
        RowRemark::Best => paint::role_color(ui.visuals().dark_mode, Role::Accent),
        _ => ui.visuals().weak_text_color(),
    }
}

/// The check box that draws the fit's lobes, and their line.
fn tick_ui(
    ui: &mut egui::Ui,
    state: &State,
    row: &FitRow,
    rect: Rect,
    name: &str,
    out: &mut Vec<Msg>,
) {
    let Some(kept) = row.kept else { return };
    let place = Rect::from_min_size(rect.min + vec2(4.0, 0.0), vec2(22.0, rect.height()));
    let mut child = ui.new_child(
        UiBuilder::new()
            .max_rect(place)
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    let mut on = kept.overlaid;
    let tick = child.add(egui::Checkbox::without_text(&mut on));
    tick.widget_info(|| {
        egui::WidgetInfo::selected(
            egui::Role::CheckBox,
            true,
            kept.overlaid,
            format!("Overlay {name}"),
        )
    });
    if tick
        .on_hover_text("Draw this fit's lobes beside the model's")
        .changed()
    {
        out.push(Msg::Fit(FitMsg::Overlay(row.variant, on)));
    }
    let (look, series) = look_beside(row.variant, state.scene.selected);
    let mut swatch = Drawing::new([26.0, ROW]);
    let strength = if kept.overlaid { 1.0 } else { 0.35 };
    swatch.dashed_line(
        vec![[0.0, 0.5 * ROW], [26.0, 0.5 * ROW]],
        look.width(),
        look.dash(),
        crate::figure::Ink::from(Role::Series(series)).faded(strength),
    );
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    let at = rect.min + Vec2::new(31.0, 0.0);
    paint::paint(ui.painter(), at, &swatch, &palette);
}
