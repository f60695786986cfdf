//! What the fit under way says, or the kept one said: a row per stage, the result, the trace of E.

use super::fit_details::{self, hundredths};
use crate::app::fitting::{FitMsg, KeptFit, Part, Run, Settings, stage_words, variant_name};
use crate::app::formula::number;
use crate::app::paint::{self, rich_text_job};
use crate::app::state::State;
use crate::app::update::Msg;
use crate::brdf::Brdf;
use crate::brdf::params::ALL;
use crate::figure::palette::Palette;
use crate::figure::text::RichText;
use crate::figure::trace::{self, TracePoint, TraceSpec};
use crate::fit::{Progress, STAGES, Stage, Variant};
use egui::{Align, Layout, Sense, vec2};

/// Room in points for what stands left of the numbers.
const LABELS: f32 = 118.0;
/// Least height of the trace in points.
const TRACE: f32 = 92.0;

/// What a stage came to, or is at.
struct StageRow {
    start: f64,
    now: f64,
    evaluations: usize,
    brdf: Brdf,
    under_way: bool,
}

/// The part of the run under way to show: the shown variant's, or the one that is being fitted.
fn shown_part(state: &State) -> Option<(&Run, &Part)> {
    let run = state.current_run()?;
    Some((run, run.current_part()?))
}

fn stage_row(state: &State, stage: Stage) -> Option<StageRow> {
    if let Some((run, part)) = shown_part(state) {
        let (first, last) = stage_words(&part.heard, stage)?;
        let newest = part.best().is_some_and(|best| best.stage == stage);
        return Some(StageRow {
            start: first.error,
            now: last.error,
            evaluations: last.evaluations,
            brdf: last.brdf,
            under_way: newest && !run.stopping,
        });
    }
    let outcome = &state.current_fit()?.outcome;
    let report = outcome.stages.iter().find(|report| report.stage == stage)?;
    Some(StageRow {
        start: report.start_error,
        now: report.error,
        evaluations: report.evaluations,
        brdf: report.end,
        under_way: false,
    })
}

/// A row per stage: its tick, what it moves, E from start to end, evaluations.
pub fn stages_ui(ui: &mut egui::Ui, state: &State, settings: &mut Settings) {
    let width = ui.available_width();
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.horizontal(|ui| {
        ui.weak("Stages");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let weak = ui.visuals().weak_text_color();
            cells_ui(ui, width, ["evaluations", "E end [%]", "E start"], weak)
                .on_hover_text(fit_details::meaning(settings.weight));
        });
    });
    for (stage, on) in STAGES.into_iter().zip(&mut settings.stages) {
        let row = stage_row(state, stage);
        let response = ui
            .horizontal(|ui| {
                ui.set_width(width);
                let markup = format!("{}  {}", stage.number(), stage.symbols());
                let name = format!("stage {}", stage.number());
                super::fit::tick_ui(ui, on, &markup, &name);
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    stage_numbers_ui(ui, width, row.as_ref());
                });
            })
            .response;
        if let Some(row) = row {
            response.on_hover_ui(|ui| {
                ui.label(format!("Stage {} ended at", stage.number()));
                params_ui(ui, &row.brdf);
            });
        } else {
            response.on_hover_text(stage_help(stage));
        }
    }
}

fn stage_help(stage: Stage) -> &'static str {
    match stage {
        Stage::Amplitudes => "The best ρd and ks for fixed s, α and η",
        Stage::Shape => "s, α and η for fixed ρd and ks",
        Stage::ShapeAndSpecular => "s, α, η and ks for fixed ρd",
        Stage::Joint => "All parameters together, from several starts",
    }
}

fn stage_numbers_ui(ui: &mut egui::Ui, width: f32, row: Option<&StageRow>) {
    let Some(row) = row else {
        cells_ui(ui, width, ["–"; 3], ui.visuals().weak_text_color());
        return;
    };
    let color = if row.under_way {
        paint::role_color(ui.visuals().dark_mode, crate::figure::Role::Accent)
    } else {
        ui.visuals().text_color()
    };
    let errors = [row.now, row.start].map(hundredths);
    let evaluations = row.evaluations.to_string();
    cells_ui(ui, width, [&evaluations, &errors[0], &errors[1]], color);
}

/// The columns of numbers, from the right; returns that of E. In a narrow panel they share what there is.
fn cells_ui(
    ui: &mut egui::Ui,
    row_width: f32,
    texts: [&str; 3],
    color: egui::Color32,
) -> egui::Response {
    ui.spacing_mut().item_spacing.x = 6.0;
    let narrowing = ((row_width - LABELS) / 198.0).clamp(0.3, 1.0);
    let mut cell = |width: f32, text: &str| {
        let layout = Layout::right_to_left(Align::Center);
        let size = vec2(narrowing * width, ui.available_height());
        let cell = ui.allocate_ui_with_layout(size, layout, |ui| {
            ui.set_width(size.x);
            let job = rich_text_job(&RichText::parse(text), 13.0, color);
            ui.add(egui::Label::new(job).truncate())
        });
        cell.inner
    };
    cell(72.0, texts[0]);
    let response = cell(62.0, texts[1]);
    cell(52.0, texts[2]);
    response
}

fn params_ui(ui: &mut egui::Ui, brdf: &Brdf) {
    egui::Grid::new("stage parameters")
        .num_columns(2)
        .spacing([12.0, 3.0])
        .show(ui, |ui| {
            let color = ui.visuals().text_color();
            for row in ALL.iter().filter(|row| brdf.uses(row.id)) {
                let values: Vec<String> =
                    brdf.params.get(row.id).iter().map(|x| number(*x)).collect();
                ui.label(rich_text_job(&RichText::parse(row.symbol), 12.5, color));
                let text = values.join("   ");
                ui.label(rich_text_job(&RichText::parse(&text), 12.5, color));
                ui.end_row();
            }
        });
}

/// The result in words, and the trace in what room is left.
pub fn result_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.add_space(2.0);
    let (heard, empty): (&[Progress], &str) = match (shown_part(state), state.current_fit()) {
        (Some((run, part)), _) => {
            running_ui(ui, run, part);
            let empty = if run.stopping {
                "Stopping"
            } else {
                "Arranging the data"
            };
            (&part.heard, empty)
        }
        (None, Some(kept)) => {
            kept_ui(ui, state, kept, out);
            (&kept.trace, "No trace was kept of this fit.")
        }
        (None, None) => {
            ui.weak("This model is not fitted yet.");
            (&[], "E over evaluations")
        }
    };
    ui.add_space(4.0);
    trace_ui(ui, heard, state.scene.selected, empty);
}

fn running_ui(ui: &mut egui::Ui, run: &Run, part: &Part) {
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

fn kept_ui(ui: &mut egui::Ui, state: &State, kept: &KeptFit, out: &mut Vec<Msg>) {
    let errors = &kept.outcome.errors;
    let mut text = format!("E {} %", hundredths(errors.total));
    if let Some(grazing) = errors.grazing {
        text += &format!(", {} % at grazing angles", hundredths(grazing));
    }
    let strong = ui.visuals().strong_text_color();
    let job = rich_text_job(&RichText::parse(&text), 13.5, strong);
    ui.add(egui::Label::new(job).wrap()).on_hover_ui(|ui| {
        ui.set_max_width(330.0);
        ui.label(fit_details::meaning(kept.setup.weight));
        ui.separator();
        fit_details::details_ui(ui, state, kept);
    });
    let mut remarks = Vec::new();
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

fn trace_ui(ui: &mut egui::Ui, heard: &[Progress], series: usize, empty: &str) {
    let height = (ui.available_height() - 4.0).clamp(TRACE, 2.5 * TRACE);
    let size = vec2(ui.available_width(), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Trace of E"));
    let points: Vec<TracePoint> = heard
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
        empty,
    };
    let drawing = trace::draw(&spec, [rect.width(), rect.height()]);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &drawing, &palette);
    response
        .on_hover_text("E over evaluations; lighter where it is estimated on a part of the cells");
}
