//! The toolbar of the materials: whose fits, and by which quantities.

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::views::scatter::settings::{ScatterSettings, with_model, with_quantities};
use crate::app::widgets::controls::sized_choice_ui;
use crate::app::widgets::paint::plain;
use crate::app::widgets::toolbar;
use crate::brdf::MODELS;
use crate::figure::scatter::Quantity;

/// Draws it.
pub fn toolbar_ui(ui: &mut egui::Ui, state: &State, view: &ScatterSettings, out: &mut Vec<Msg>) {
    let mut changed = view.clone();
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| model_ui(ui, state, &mut changed));
        bar.group(|ui| {
            let [mut x, mut y] = changed.quantities();
            let names: Vec<(Quantity, String)> = Quantity::all(changed.model)
                .into_iter()
                .filter_map(|one| {
                    let row = one.row(changed.model)?;
                    Some((one, format!("{}, {}", plain(row.symbol), row.name)))
                })
                .collect();
            let names: Vec<(Quantity, &str)> = names
                .iter()
                .map(|(one, name)| (*one, name.as_str()))
                .collect();
            y = sized_choice_ui(ui, "Vertical axis", y, &names, AXIS).unwrap_or(y);
            ui.label("over");
            x = sized_choice_ui(ui, "Horizontal axis", x, &names, AXIS).unwrap_or(x);
            changed = with_quantities(&changed, [x, y]);
        });
    });
    if changed != *view {
        out.push(Msg::set_view(changed));
    }
}

/// Width in points of the list of quantities.
const AXIS: f32 = 150.0;

/// The models; those without fits are greyed.
fn model_ui(ui: &mut egui::Ui, state: &State, view: &mut ScatterSettings) {
    let menu = egui::ComboBox::from_id_salt("scatter model")
        .width(120.0)
        .height(400.0)
        .selected_text(view.model.name);
    let menu = menu.show_ui(ui, |ui| {
        for model in MODELS {
            let button = egui::Button::selectable(view.model == *model, model.name);
            let response = ui.add_enabled(state.has_fits_of(model), button);
            let response = response.on_disabled_hover_text("No material has a fit of it");
            if response.clicked() {
                *view = with_model(view, model);
            }
        }
    });
    ui.ctx()
        .accesskit_node_builder(menu.response.id, |node| node.set_label("Model of the fits"));
    menu.response.on_hover_text("Model whose fits are shown");
}
