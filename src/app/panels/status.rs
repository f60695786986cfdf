//! The line at the bottom: the probe's angles and values, and the jobs under way.

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::{Probe, ratio};
use crate::app::widgets::paint::rich_text_job;
use crate::figure::text::RichText;
use crate::geom::{HalfDiff, Rgb, directions};

/// Draws the line.
pub fn status_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            jobs_ui(ui, state, out);
            ui.with_layout(
                egui::Layout::left_to_right(egui::Align::Center),
                |ui| match state.probe() {
                    Some(probe) => {
                        pin_ui(ui, state, out);
                        probe_ui(ui, state, probe);
                    }
                    None => {
                        ui.weak("Point at the sphere or at a lobe to read angles and values.");
                    }
                },
            );
        });
    });
}

fn jobs_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let Some(job) = state.jobs.first() else {
        fit_job_ui(ui, state, out);
        return;
    };
    let cancel = ui.small_button("×").on_hover_text("Stop");
    cancel.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Stop opening"));
    if cancel.clicked() {
        out.push(Msg::Cancel(job.id));
    }
    ui.add(egui::ProgressBar::new(job.progress).desired_width(90.0));
    let more = match state.jobs.len() {
        1 => String::new(),
        count => format!(" and {} more", count - 1),
    };
    ui.add(egui::Label::new(format!("Opening {}{more}", job.label)).truncate());
}

/// The fit under way: of another material than the one that is shown, it can be seen nowhere else.
fn fit_job_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let Some(run) = state.fit.run.as_ref().filter(|run| !run.stopping) else {
        return;
    };
    let cancel = ui
        .small_button("×")
        .on_hover_text(Command::CancelFit.hint(ui.ctx()));
    cancel.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Stop fitting"));
    if cancel.clicked() {
        out.push(Msg::Run(Command::CancelFit));
    }
    ui.add(egui::ProgressBar::new(run.share()).desired_width(90.0));
    let name = state.materials.get(&run.material);
    let name = name.map_or("", |material| material.name.as_str());
    ui.add(egui::Label::new(format!("Fitting {name}")).truncate());
}

/// Says that the probe stays, and lets it go.
fn pin_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    if state.pinned.is_some()
        && ui
            .small_button("Pinned ×")
            .on_hover_text(Command::Unpin.hint(ui.ctx()))
            .clicked()
    {
        out.push(Msg::Run(Command::Unpin));
    }
}

fn probe_ui(ui: &mut egui::Ui, state: &State, probe: Probe) {
    ui.spacing_mut().item_spacing.x = 14.0;
    let color = ui.visuals().text_color();
    let mut show = |text: &str| ui.label(rich_text_job(&RichText::parse(text), 12.5, color));
    let degrees = |radians: f64| format!("{:.1}°", radians.to_degrees());
    show(&format!(
        "θ_{{i}} {}  φ_{{i}} {}",
        degrees(directions::theta(probe.wi)),
        degrees(directions::phi(probe.wi))
    ));
    show(&format!(
        "θ_{{o}} {}  φ_{{o}} {}",
        degrees(directions::theta(probe.wo)),
        degrees(directions::phi(probe.wo))
    ));
    if let Some(angles) = HalfDiff::from_directions(probe.wi, probe.wo) {
        let folded = angles.folded();
        show(&format!(
            "θ_{{h}} {}  θ_{{d}} {}  φ_{{d}} {}",
            degrees(folded.theta_h),
            degrees(folded.theta_d),
            degrees(folded.phi_d)
        ));
    }
    let (measured, model) = state.values_at(probe);
    show(&measured.map_or("not measured".into(), |value| {
        format!("measured {}", rgb(value))
    }));
    show(&format!("model {}", model.map_or("–".into(), rgb)));
    if let (Some(measured), Some(model)) = (measured, model) {
        let ratio: Vec<String> = ratio(measured, model)
            .iter()
            .map(|ratio| {
                if ratio.is_nan() {
                    "–".into()
                } else {
                    format!("{ratio:.2}")
                }
            })
            .collect();
        show(&format!("model/measured {}", ratio.join(" ")));
    }
}

fn rgb(value: Rgb) -> String {
    value.map(crate::app::widgets::formula::number).join(" ")
}
