//! The error map: where the E of the model comes from.

pub mod about;
pub mod paper;
pub mod settings;
pub mod work;

use crate::app::msg::Msg;
use crate::app::msg::cache::request;
use crate::app::state::State;
use crate::app::state::fitting::run::FitRun;
use crate::app::state::probe::Probe;
use crate::app::state::shared_table::SharedTable;
use crate::app::views::error_map::settings::ErrorMapSettings;
use crate::app::views::error_map::work::ErrorMapQuery;
use crate::app::widgets::heat::{HeatOnScreen, heat_ui};
use crate::app::widgets::{controls, empty, probe, toolbar};
use crate::export::fit_output::bins;
use crate::figure::ProbeMark;
use crate::figure::error_map::{ErrorSpec, Plane};
use crate::figure::heatmap::{HeatField, HeatSpot};
use crate::figure::scale::RADIAL_SCALES;
use crate::fit::error_map::{Bin, ErrorMap};
use crate::geom::HalfDiff;
use crate::geom::directions::theta;
use std::f64::consts::FRAC_PI_2;

/// Draws the tile.
pub fn error_map_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<ErrorMapSettings>();
    toolbar_ui(ui, view, out);
    let empty = |ui: &mut egui::Ui, text: &str| {
        empty::empty_ui(ui, ui.available_rect_before_wrap(), text);
        false
    };
    let Some((material, opened)) = state.current() else {
        return empty(ui, "Open a material to see where its model errs.");
    };
    if material.table.valid_count() == 0 {
        return empty(ui, "There are no data to compare the model with.");
    }
    let query = ErrorMapQuery {
        data: SharedTable(material.table.clone()),
        weight: state.fit.settings.weight,
        limit: state.fit.settings.limit,
        brdf: opened.brdf,
    };
    // A fit under way needs the cores itself, and so do the frames of a drag: the map follows when it ends.
    let dragged = ui.input(|input| input.pointer.any_down());
    if !dragged && !state.current_run().is_some_and(FitRun::drives_model) {
        request(&state.caches, &query, out);
    }
    let Some((made, fresh)) = state.caches.shown(&query) else {
        return empty(ui, "In the making.");
    };
    let made = match made {
        Ok(made) => made,
        Err(error) => return empty(ui, &error.to_string()),
    };
    let spec = spec(view, made, state.probe());
    let (bins, columns) = bins(view.plane, made);
    let parts: Vec<Option<f64>> = bins.iter().map(|bin| bin.map(|bin| bin.error)).collect();
    let field = spec.field(&parts, columns);
    let heat = spec.heat_spec(&material.name, &field);
    let on_screen = heat_ui(ui, "Error map", &heat, &field, !fresh);
    if let Some(moved) = on_screen.moved_view(ui, view.view) {
        out.push(set(view, |view| view.view = moved));
    }
    interact(&on_screen, state, view.plane, out);
    tooltip(&on_screen, &field, &bins, made.total);
    on_screen.response.contains_pointer()
}

fn set(view: &ErrorMapSettings, change: impl FnOnce(&mut ErrorMapSettings)) -> Msg {
    let mut view = view.clone();
    change(&mut view);
    Msg::set_view(view)
}

fn toolbar_ui(ui: &mut egui::Ui, view: &ErrorMapSettings, out: &mut Vec<Msg>) {
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
        for (plane, name, help) in [
            (
                Plane::Directions,
                "θi, θo",
                "Over the angles of light and view. Swapped they are the same, so each counts half",
            ),
            (
                Plane::HalfDiff,
                "θh, θd",
                "Over half and difference angle, summed over φd",
            ),
        ] {
            let response = ui.selectable_label(view.plane == plane, name);
            if response.on_hover_text(help).clicked() {
                out.push(set(view, |view| {
                    view.plane = plane;
                    view.view = Default::default();
                }));
            }
        }
});
        bar.section(|ui| {
            let scales = RADIAL_SCALES.map(|scale| (scale, scale.name()));
            if let Some(scale) = controls::choice_ui(ui, "Colour scale", view.scale, &scales) {
                out.push(set(view, |view| view.scale = scale));
            }
        });
    });
}

fn spec(view: &ErrorMapSettings, made: &ErrorMap, probe: Option<Probe>) -> ErrorSpec {
    ErrorSpec {
        plane: view.plane,
        scale: view.scale,
        view: view.view,
        total: made.total,
        channels: made.channels,
        spots: probe.map_or_else(Vec::new, |probe| spots(view.plane, probe)),
    }
}

/// The marks of the probe. Hollow where the view holds its two angles only, and not its azimuth.
fn spots(plane: Plane, probe: Probe) -> Vec<HeatSpot> {
    match plane {
        Plane::Directions => {
            let (theta_i, theta_o) = (probe.theta_i(), theta(probe.wo));
            let in_plane = probe.mark_in_plane(theta_i);
            let mark = |a: f64, b: f64| ProbeMark {
                at: [a.to_degrees(), b.to_degrees()],
                exact: in_plane.exact && in_plane.at >= 0.0,
            };
            vec![
                HeatSpot::Mirrored(mark(theta_o, theta_i)),
                HeatSpot::Probe(mark(theta_i, theta_o)),
            ]
        }
        Plane::HalfDiff => crate::app::views::image::settings::mark(probe, FRAC_PI_2)
            .map(HeatSpot::Probe)
            .into_iter()
            .collect(),
    }
}

/// A probe with the angles under the pointer: on the side of the mirror direction, or at φd = 90°.
fn probe_at(plane: Plane, [x, y]: [f64; 2]) -> Option<Probe> {
    let (x, y) = (x.to_radians(), y.to_radians());
    match plane {
        Plane::Directions => Some(Probe::in_plane(x, y)),
        Plane::HalfDiff => Probe::from_angles(HalfDiff {
            theta_h: x,
            theta_d: y,
            phi_d: FRAC_PI_2,
        }),
    }
}

fn interact(on_screen: &HeatOnScreen, state: &State, plane: Plane, out: &mut Vec<Msg>) {
    if let Some(probe) = on_screen.clicked().and_then(|at| probe_at(plane, at)) {
        probe::pin(state, probe, out);
    }
    if on_screen.response.hovered() {
        let under = on_screen.hovered().and_then(|at| probe_at(plane, at));
        probe::hover(state, under, out);
    }
}

fn tooltip(on_screen: &HeatOnScreen, field: &HeatField, bins: &[Option<Bin>], total: f64) {
    let Some((column, row)) = on_screen.hovered().and_then(|at| field.find(at)) else {
        return;
    };
    let bin = bins.get(column + field.columns() * row).copied().flatten();
    on_screen.response.clone().on_hover_ui_at_pointer(|ui| {
        let Some(bin) = bin else {
            ui.label("no cell counts here");
            return;
        };
        ui.label(format!("{:.3} % of E", 100.0 * bin.error / total));
        if let Some(error) = bin.own_error() {
            ui.label(format!("E here {:.1} %", 100.0 * error));
        }
    });
}
