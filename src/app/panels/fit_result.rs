//! Report of the fit under way, or of the kept one: the result, what to know of it, the trace of E.

use crate::app::msg::Msg;
use crate::app::msg::fit::FitMsg;
use crate::app::state::State;
use crate::app::state::fitting::kept::{KeptFit, variant_name};
use crate::app::state::fitting::run::{FitRun, Part};
use crate::app::state::material::{Material, Opened};
use crate::app::widgets::formula::hundredths;
use crate::app::widgets::paint::rich_text_job;
use crate::app::widgets::{fit_details, paint};
use crate::figure::palette::Palette;
use crate::figure::text::RichText;
use crate::figure::trace;
use crate::figure::trace::{TracePoint, TraceSpec};
use crate::fit::{FitProgress, Variant};
use egui::{Align, Layout, Sense, vec2};

/// Least and greatest height of the trace in points.
const TRACE: (f32, f32) = (64.0, 220.0);

/// The part of the run under way to show: the shown variant's, or the one that is being fitted.
pub fn shown_part(state: &State) -> Option<(&FitRun, &Part)> {
    let run = state.current_run()?;
    Some((run, run.current_part()?))
}

/// The result in words; below it the trace, where there is one, in what room is left.
pub fn result_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.add_space(2.0);
    line_ui(ui, state);
    let updates: &[FitProgress] = match (shown_part(state), state.current_fit()) {
        (Some((_, part)), _) => &part.updates,
        (None, Some(kept)) => {
            remarks_ui(ui, state, kept, out);
            &kept.trace
        }
        (None, None) => &[],
    };
    if !updates.is_empty() {
        ui.add_space(2.0);
        trace_ui(ui, updates, state.scene.selected);
    }
}

/// One line: the fit that is under way, the E of the kept one, or that there is none.
pub fn line_ui(ui: &mut egui::Ui, state: &State) {
    match (shown_part(state), state.current_fit()) {
        (Some((run, part)), _) => running_ui(ui, run, part),
        (None, Some(kept)) => error_ui(ui, state, kept),
        (None, None) => {
            let is_guess = |(material, opened): (&Material, &Opened)| {
                opened.brdf == material.guess.with_model(opened.brdf.model)
            };
            ui.weak(if state.current().is_some_and(is_guess) {
                "First guess from the data, not fitted yet."
            } else {
                "This model is not fitted yet."
            });
        }
    }
}

fn running_ui(ui: &mut egui::Ui, run: &FitRun, part: &Part) {
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add(egui::ProgressBar::new(run.share()).desired_width(70.0));
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let text = if run.stopping {
                    "Stopping; the best so far is kept".into()
                } else {
                    variant_name(part.variant)
                };
                ui.add(egui::Label::new(text).truncate());
            });
        });
    });
}

fn error_ui(ui: &mut egui::Ui, state: &State, kept: &KeptFit) {
    let errors = &kept.outcome.errors;
    let mut text = format!("E {} %", hundredths(errors.total));
    if let Some(grazing) = errors.grazing {
        text += &format!(", {} % at grazing angles", hundredths(grazing));
    }
    let strong = ui.visuals().strong_text_color();
    let job = rich_text_job(&RichText::parse(&text), 13.5, strong);
    ui.add(egui::Label::new(job).truncate()).on_hover_ui(|ui| {
        ui.set_max_width(330.0);
        ui.label(fit_details::meaning(kept.setup.weight));
        ui.separator();
        fit_details::details_ui(ui, state, kept);
    });
}

/// Facts to know of a kept fit, a line each.
fn remarks_ui(ui: &mut egui::Ui, state: &State, kept: &KeptFit, out: &mut Vec<Msg>) {
    let mut remarks = Vec::new();
    if kept.on_opening && !kept.is_cancelled() {
        ui.weak("Fitted on opening.");
    }
    if kept.is_cancelled() {
        remarks.push("Cancelled: this is the best up to then.".to_string());
    }
    if state.is_stale(kept) {
        remarks.push(format!(
            "Other settings: {}.",
            lower_first(&kept.setup.text())
        ));
    }
    for remark in remarks {
        let text = egui::RichText::new(remark).color(ui.visuals().warn_fg_color);
        ui.add(egui::Label::new(text).wrap());
    }
    fit_details::concerns_ui(ui, kept);
    let moved = state
        .current()
        .is_some_and(|(_, opened)| opened.brdf != kept.outcome.brdf);
    if moved {
        ui.horizontal(|ui| {
            ui.weak("The sliders stand elsewhere.");
            let back = ui.small_button("Show fit");
            if back
                .on_hover_text("Put the sliders back to where this fit ended")
                .clicked()
            {
                let variant = Variant::from(&kept.outcome.brdf);
                out.push(Msg::Fit(FitMsg::Show(variant)));
            }
        });
    }
}

fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_lowercase().collect::<String>() + letters.as_str()
    })
}

fn trace_ui(ui: &mut egui::Ui, updates: &[FitProgress], series: usize) {
    let height = (ui.available_height() - 4.0).clamp(TRACE.0, TRACE.1);
    let size = vec2(ui.available_width(), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Trace of E"));
    let points: Vec<TracePoint> = updates
        .iter()
        .map(|word| TracePoint {
            stage: word.stage.number(),
            evaluations: word.evaluations,
            error: word.error,
            all_cells: word.all_cells,
        })
        .collect();
    let spec = TraceSpec {
        points: &points,
        series,
    };
    let drawing = trace::draw(&spec, [rect.width(), rect.height()]);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &drawing, &palette);
    response
        .on_hover_text("E over evaluations; lighter where it is estimated on a part of the cells");
}
