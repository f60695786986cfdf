//! The error landscape: the best E over (s, α), and the way of a fit over it.

pub mod about;
pub mod paper;
pub mod settings;
pub mod work;

use crate::app::msg::Msg;
use crate::app::msg::cache::{again, request, stop};
use crate::app::state::State;
use crate::app::views::landscape::settings::LandscapeSettings;
use crate::app::views::landscape::work::{LandscapeQuery, path};
use crate::app::widgets::formula::number;
use crate::app::widgets::heat::{HeatOnScreen, heat_ui};
use crate::app::widgets::paint::plain;
use crate::app::widgets::{empty, toolbar};
use crate::brdf::{Brdf, Fresnel};
use crate::export::fit_output::terrain;
use crate::figure::heatmap::HeatView;
use crate::figure::landscape::{LandscapeSpec, Terrain, axes};
use crate::fit::landscape::{Eta, Landscape, place};

/// Draws the tile.
pub fn landscape_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<LandscapeSettings>();
    let empty = |ui: &mut egui::Ui, text: &str| {
        empty::empty_ui(ui, ui.available_rect_before_wrap(), text);
        false
    };
    let query = LandscapeQuery::of(state);
    let has_data = |(material, _): (&crate::app::state::material::Material, _)| {
        material.table.valid_count() > 0
    };
    let query = query.filter(|_| state.current().is_some_and(has_data));
    toolbar_ui(ui, state, view, query.as_ref(), out);
    let (Some(query), Some((material, opened))) = (query, state.current()) else {
        return empty(ui, "Open a measured material to see how the error lies.");
    };
    request(&state.caches, &query, out);
    let shown = state.caches.shown(&query);
    let landscape = match shown {
        Some((Err(error), true)) => return empty(ui, &error.to_string()),
        Some((Ok(landscape), _)) => Some(landscape),
        _ => None,
    };
    let terrain = landscape.map_or_else(no_terrain, terrain);
    let spec = LandscapeSpec {
        eta: eta_words(&query),
        view: view.view,
        path: path(state),
        here: Some(place(&opened.brdf)),
        best: best(state, &query, landscape).map(|(brdf, error)| (place(&brdf), 100.0 * error)),
    };
    let heat = spec.heat_spec(&material.name, &terrain);
    let dimmed = shown.is_some_and(|(_, fresh)| !fresh);
    let on_screen = heat_ui(ui, "Error landscape", &heat, &terrain.field(), dimmed);
    if let Some(moved) = on_screen.moved_view(ui, view.view) {
        out.push(set(view, |view| view.view = moved));
    }
    if let Some(landscape) = landscape {
        if let Some([s, alpha]) = on_screen.clicked() {
            out.extend(landscape.model_at(s, alpha).map(Msg::TakeModel));
        }
        tooltip(&on_screen, landscape);
    }
    false
}

/// The best model that is known: that of the landscape, or the kept fit where it is better under the same terms.
fn best(
    state: &State,
    query: &LandscapeQuery,
    landscape: Option<&Landscape>,
) -> Option<(Brdf, f64)> {
    let found = landscape.and_then(|landscape| landscape.best)?;
    let fit = state.current_fit().filter(|kept| {
        let (setup, brdf) = (&kept.setup, &kept.outcome.brdf);
        let same_eta = match query.eta {
            Eta::Fixed(eta) => brdf.fresnel == Fresnel::None || brdf.params.eta == eta,
            Eta::Optimised => true,
        };
        (setup.weight, setup.limit) == (query.weight, query.limit) && same_eta
    });
    let fit = fit.map(|kept| (kept.outcome.brdf, kept.outcome.errors.total));
    fit.filter(|(_, error)| *error < found.1).or(Some(found))
}

fn set(view: &LandscapeSettings, change: impl FnOnce(&mut LandscapeSettings)) -> Msg {
    let mut view = view.clone();
    change(&mut view);
    Msg::set_view(view)
}

fn toolbar_ui(
    ui: &mut egui::Ui,
    state: &State,
    view: &LandscapeSettings,
    query: Option<&LandscapeQuery>,
    out: &mut Vec<Msg>,
) {
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            let with_fresnel = query.is_some_and(|query| query.fresnel != Fresnel::None);
            for (solve_eta, name, help) in [
                (false, "η fixed", "Keep η where its slider stands"),
                (
                    true,
                    "η solved",
                    "Take the best η at each point; takes longer",
                ),
            ] {
                let chosen = with_fresnel && view.solve_eta == solve_eta;
                let button = egui::Button::selectable(chosen, name);
                let response = ui.add_enabled(with_fresnel, button);
                if response.on_hover_text(help).clicked() {
                    out.push(set(view, |view| view.solve_eta = solve_eta));
                }
            }
        });
        bar.group(|ui| {
            if ui
                .add_enabled(view.view != HeatView::default(), egui::Button::new("Whole"))
                .on_hover_text("Show the whole landscape again")
                .clicked()
            {
                out.push(set(view, |view| view.view = HeatView::default()));
            }
        });
        let Some(query) = query else {
            return;
        };
        bar.group(|ui| {
            if let Some(progress) = state.caches.progress::<LandscapeQuery>() {
                ui.separator();
                if ui.button("Stop").clicked() {
                    out.push(stop::<LandscapeQuery>());
                }
                ui.weak(format!("{:.0} %", 100.0 * progress));
            } else if state.caches.is_stopped(query) {
                ui.separator();
                if ui.button("Go on").clicked() {
                    out.push(again(query));
                }
            }
        });
    });
}

fn eta_words(query: &LandscapeQuery) -> String {
    match (query.fresnel, query.eta) {
        (Fresnel::None, _) => "no Fresnel".to_string(),
        (_, Eta::Fixed(eta)) => format!("η = {} fixed", number(eta)),
        (_, Eta::Optimised) => "η solved".to_string(),
    }
}

fn no_terrain() -> Terrain {
    Terrain {
        s: Vec::new(),
        alpha: Vec::new(),
        percent: Vec::new(),
    }
}

fn tooltip(on_screen: &HeatOnScreen, landscape: &Landscape) {
    let Some([s, alpha]) = on_screen.hovered() else {
        return;
    };
    let (Some(error), Some(near)) = (landscape.error_at(s, alpha), landscape.model_at(s, alpha))
    else {
        return;
    };
    on_screen.response.clone().on_hover_ui_at_pointer(|ui| {
        let [x, y] = axes().map(|row| plain(row.symbol));
        ui.label(format!("{x} {}, {y} {alpha:.2}", plain(&number(s))));
        ui.label(format!("E about {:.2} %", 100.0 * error));
        if near.fresnel != Fresnel::None {
            ui.label(format!("η {}", plain(&number(near.params.eta))));
        }
        ui.weak("Click to take these");
    });
}
