//! The toolbar of the ranking: which part of E, in which order, and which models.

use crate::app::msg::Msg;
use crate::app::views::ranking::rows::RankingRows;
use crate::app::views::ranking::settings::{RankingSettings, with_model};
use crate::app::widgets::controls::{choice_ui, sized_choice_ui, tick_menu_ui};
use crate::app::widgets::toolbar;
use crate::brdf::fresnel::FRESNELS;
use crate::brdf::{Fresnel, MODELS, Model};
use crate::figure::ranking::RankingPart;
use crate::geom::limits::GRAZING_THETA_DEG;

/// Width in points of the lists.
const ORDER: f32 = 130.0;

/// Draws it.
pub fn toolbar_ui(
    ui: &mut egui::Ui,
    view: &RankingSettings,
    rows: &RankingRows,
    out: &mut Vec<Msg>,
) {
    let mut changed = view.clone();
    let fitted: Vec<&'static Model> = MODELS
        .iter()
        .copied()
        .filter(|model| {
            let mut fits = rows
                .spec
                .materials
                .iter()
                .flat_map(|material| &material.fits);
            fits.any(|fit| fit.model == *model)
        })
        .collect();
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            let grazing = format!("from {GRAZING_THETA_DEG}° on");
            let parts = [
                (RankingPart::Total, "all cells"),
                (RankingPart::Grazing, grazing.as_str()),
            ];
            ui.label("E of");
            let part = choice_ui(ui, "Part of E", changed.part, &parts);
            changed.part = part.unwrap_or(changed.part);
        });
        bar.group(|ui| {
            let least = std::iter::once((None, "least E"));
            let models = fitted.iter().map(|model| (Some(*model), model.name));
            let orders: Vec<(Option<&'static Model>, &str)> = least.chain(models).collect();
            // What is not fitted sorts nothing.
            let now = changed.sort.filter(|sort| fitted.contains(sort));
            ui.label("by");
            if let Some(sort) = sized_choice_ui(ui, "Order of the materials", now, &orders, ORDER) {
                changed.sort = sort;
            }
        });
        bar.group(|ui| models_ui(ui, &fitted, &mut changed));
        bar.group(|ui| {
            let best = std::iter::once((None, "best of each"));
            let factors = FRESNELS.into_iter().map(|one| (Some(one), one.name()));
            let factors: Vec<(Option<Fresnel>, &str)> = best.chain(factors).collect();
            ui.label("Fresnel");
            if let Some(fresnel) = choice_ui(ui, "Fresnel factor", changed.fresnel, &factors) {
                changed.fresnel = fresnel;
            }
        });
        if rows.left_out > 0 {
            bar.group(|ui| {
                ui.weak(format!("{} left out", rows.left_out)).on_hover_text(
                    "Fits with another weight or grazing limit than those set now, and fits that were stopped, cannot be compared.",
                );
            });
        }
    });
    if changed != *view {
        out.push(Msg::set_view(changed));
    }
}

/// The choice of models.
fn models_ui(ui: &mut egui::Ui, fitted: &[&'static Model], view: &mut RankingSettings) {
    let button = tick_menu_ui(ui, "Models", |ui| {
        for model in fitted {
            let mut on = view.hidden.iter().all(|hidden| hidden.0 != *model);
            if ui.checkbox(&mut on, model.name).changed() {
                *view = with_model(view, model, on);
            }
        }
    });
    button.on_hover_text("Which models are shown");
}
