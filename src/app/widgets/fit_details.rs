//! All that is known of a kept fit, for hovering; and how E is written.

use crate::app::state::State;
use crate::app::state::fitting::kept::{KeptFit, variant_name};
use crate::app::widgets::formula::{number, percent};
use crate::app::widgets::paint::rich_text_job;
use crate::figure::text::RichText;
use crate::fit::Weight;
use crate::fit::outcome::ALBEDO_ANGLES;
use crate::geom::limits::GRAZING_THETA_DEG;

/// Marks an albedo.
const ABOVE_ONE: &str = "   > 1";

/// Meaning of E under a weight.
pub fn meaning(weight: Weight) -> &'static str {
    match weight {
        Weight::Cosine => "E: the share of reflected energy that is misplaced under uniform light.",
        Weight::SolidAngle => {
            "E: Σ w |model − measured| / Σ w measured, each cell weighted by its solid angles."
        }
        Weight::Cells => "E: Σ |model − measured| / Σ measured, every cell counting the same.",
    }
}

/// Errors, parameters, albedo, what was asked, and what to know.
pub fn details_ui(ui: &mut egui::Ui, state: &State, kept: &KeptFit) {
    ui.set_max_width(330.0);
    let outcome = &kept.outcome;
    ui.strong(variant_name(kept.variant()));
    let mut lines = vec![("E".to_string(), percent(outcome.errors.total))];
    if let Some(grazing) = outcome.errors.grazing {
        lines.push((format!("E, θ ≥ {GRAZING_THETA_DEG}°"), percent(grazing)));
    }
    let channels = outcome.errors.channels.map(percent).join("   ");
    lines.push(("E of R, G, B".into(), channels));
    let brdf = &outcome.brdf;
    for row in brdf.used() {
        let values: Vec<String> = brdf.get(row.id).iter().map(|x| number(*x)).collect();
        lines.push((row.symbol.into(), values.join("   ")));
    }
    // Of the brightest channel: the one that may exceed 1.
    let highest = outcome
        .albedo
        .map(|albedo| albedo.into_iter().fold(0.0, f64::max));
    let angles = ALBEDO_ANGLES.map(|angle| format!("{angle:.0}°")).join(", ");
    let mark = if outcome.exceeds_one() { ABOVE_ONE } else { "" };
    lines.push((
        format!("albedo at {angles}"),
        highest.map(|share| format!("{share:.2}")).join("   ") + mark,
    ));
    let mut took = format!("{} evaluations", outcome.evaluations);
    if let Some(seconds) = kept.seconds {
        took = format!("{seconds:.1} s, {took}");
    }
    lines.push((outcome.ended.key().into(), took));
    egui::Grid::new("fit details")
        .num_columns(2)
        .spacing([14.0, 3.0])
        .show(ui, |ui| {
            let (weak, color) = (ui.visuals().weak_text_color(), ui.visuals().text_color());
            for (name, value) in lines {
                ui.label(rich_text_job(&RichText::parse(&name), 12.5, weak));
                let color = if value.ends_with(ABOVE_ONE) {
                    ui.visuals().warn_fg_color
                } else {
                    color
                };
                ui.label(rich_text_job(&RichText::parse(&value), 12.5, color));
                ui.end_row();
            }
        });
    ui.weak(kept.setup.text());
    if state.is_stale(kept) {
        ui.weak("The settings ask something else now.");
    }
    concerns_ui(ui, kept);
}

/// Concerns to know before trusting the parameters.
pub fn concerns_ui(ui: &mut egui::Ui, kept: &KeptFit) {
    for concern in &kept.outcome.concerns {
        let text = egui::RichText::new(concern.text())
            .size(12.5)
            .color(ui.visuals().warn_fg_color);
        ui.add(egui::Label::new(text).wrap());
    }
}
