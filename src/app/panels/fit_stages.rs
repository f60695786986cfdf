//! A row per stage of the fit: its tick, what it moves, and what it came to.

use crate::app::panels::fit_result::shown_part;
use crate::app::state::State;
use crate::app::state::fitting::run::stage_ends;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::widgets::controls::tick_ui;
use crate::app::widgets::formula::{hundredths, number};
use crate::app::widgets::paint::rich_text_job;
use crate::app::widgets::{fit_details, paint};
use crate::brdf::Brdf;
use crate::figure::text::RichText;
use crate::fit::{STAGES, Stage};
use egui::{Align, Layout, vec2};

/// Room in points for what stands left of the numbers.
const LABELS: f32 = 118.0;

/// Numbers of a stage, at its end or so far.
struct StageRow {
    start: f64,
    now: f64,
    evaluations: usize,
    brdf: Brdf,
    under_way: bool,
}

fn stage_row(state: &State, stage: Stage) -> Option<StageRow> {
    if let Some((run, part)) = shown_part(state) {
        let (first, last) = stage_ends(&part.updates, stage)?;
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
pub fn stages_ui(ui: &mut egui::Ui, state: &State, settings: &mut FitSettings) {
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
    let model = state.current().map(|(_, opened)| opened.brdf.model);
    for stage in STAGES {
        let on = &mut settings.stages[stage];
        let row = stage_row(state, stage);
        let response = ui
            .horizontal(|ui| {
                ui.set_width(width);
                let symbols = model.map(|model| stage.symbols(model)).unwrap_or_default();
                let markup = format!("{}  {symbols}", stage.number());
                let name = format!("stage {}", stage.number());
                tick_ui(ui, on, &markup, &name);
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
        Stage::Amplitudes => "The best ρd and ks for a lobe that stays",
        Stage::Shape => "The lobe and η for fixed ρd and ks",
        Stage::ShapeAndSpecular => "The lobe, η and ks for fixed ρd",
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
            for row in brdf.used() {
                let values: Vec<String> = brdf.get(row.id).iter().map(|x| number(*x)).collect();
                ui.label(rich_text_job(&RichText::parse(row.symbol), 12.5, color));
                let text = values.join("   ");
                ui.label(rich_text_job(&RichText::parse(&text), 12.5, color));
                ui.end_row();
            }
        });
}
