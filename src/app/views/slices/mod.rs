//! The slices: f_r over one angle, with the residual below.

pub mod about;
pub mod bar;
pub mod paper;
pub mod settings;

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::Probe;
use crate::app::state::subjects::Subjects;
use crate::app::views::slices::settings::{SliceSettings, mark, probe_at, through};
use crate::app::widgets::legend::legend_ui;
use crate::app::widgets::{controls, paint, probe, zoom};
use crate::figure::palette::Palette;
use crate::figure::slices::{SlicePlot, SliceSpec};
use egui::{Sense, Vec2};

/// Draws the tile.
pub fn slices_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<SliceSettings>();
    let shown = followed(ui, state, view);
    bar::toolbar_ui(ui, view, &shown, out);
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(Vec2::splat(60.0)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Slices"));
    let spec = SliceSpec {
        probe: state.probe().and_then(|probe| mark(&shown, probe)),
        ..shown
    };
    let subjects = Subjects::of(state);
    let size = [rect.width(), rect.height()];
    let plot = SlicePlot::new(&spec, &subjects.list, size);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    let inside = response.contains_pointer();
    ui.data_mut(|data| data.insert_temp(pointer_id(ui), inside));
    interact(ui, &response, state, &plot, &spec, out);
    legend_ui(ui, rect.min, &plot.legend, &subjects, out);
    inside
}

fn pointer_id(ui: &egui::Ui) -> egui::Id {
    ui.scope_id().with("pointer")
}

/// The slices at the probe's angles where they follow it. They keep still under the pointer, and keep the last angles
/// when there is no probe.
fn followed(ui: &egui::Ui, state: &State, view: &SliceSettings) -> SliceSpec {
    let id = ui.scope_id().with("followed");
    if !view.follow {
        ui.data_mut(|data| data.remove::<Probe>(id));
        return view.spec.clone();
    }
    let inside = ui.data(|data| data.get_temp::<bool>(pointer_id(ui)).unwrap_or(false));
    let last = ui.data(|data| data.get_temp::<Probe>(id));
    let now = if inside { None } else { state.hovered };
    let probe = state.pinned.or(now).or(last);
    match probe {
        Some(probe) => {
            ui.data_mut(|data| data.insert_temp(id, probe));
            through(&view.spec, probe)
        }
        None => view.spec.clone(),
    }
}

fn interact(
    ui: &egui::Ui,
    response: &egui::Response,
    state: &State,
    plot: &SlicePlot,
    spec: &SliceSpec,
    out: &mut Vec<Msg>,
) {
    let view = state.scene.views.get::<SliceSettings>();
    if let Some(zoom) = zoom::gesture(ui, response, &plot.frame) {
        let mut changed = view.clone();
        let spec = &mut changed.spec;
        let range = spec.over.range();
        zoom.apply(&plot.frame.y, range, &mut spec.window, &mut spec.limits);
        if changed != *view {
            out.push(Msg::set_view(changed));
        }
    }
    let Some(pointer) = response.interact_pointer_pos().or(response.hover_pos()) else {
        return;
    };
    let point = (pointer - response.rect.min).into();
    let under = plot.x_at(point).and_then(|x| probe_at(spec, x));
    // The second click of two lets go what the first has pinned.
    if let Some(probe) = under.filter(|_| response.clicked()) {
        probe::pin(state, probe, out);
    }
    if !response.hovered() || zoom::is_panning(response) {
        return;
    }
    probe::hover(state, under, out);
    if let (Some(probe), Some(x)) = (under, plot.x_at(point)) {
        let head = format!("{} {:.2}°", spec.over.name(), x.to_degrees()).replace('-', "−");
        controls::values_tooltip(response, state, probe, spec.channel, &head);
    }
}
