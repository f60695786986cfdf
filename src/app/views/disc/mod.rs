//! The disc: data, model, residual or ratio over all view directions under one light.

pub mod about;
pub mod paper;
pub mod settings;
pub mod work;

use crate::app::msg::Msg;
use crate::app::msg::cache::request;
use crate::app::state::State;
use crate::app::state::fitting::run::FitRun;
use crate::app::state::probe::Probe;
use crate::app::state::sources::Sources;
use crate::app::views::disc::settings::{DiscSettings, with_light_at, with_probe, zoomed};
use crate::app::views::disc::work::DiscQuery;
use crate::app::widgets::heat::DIMMED;
use crate::app::widgets::{controls, empty, paint, probe, toolbar, zoom};
use crate::figure::Point;
use crate::figure::disc::{DiscField, DiscPlot, DiscSpec, PROJECTIONS};
use crate::figure::palette::Palette;
use crate::figure::scale::RADIAL_SCALES;
use crate::figure::shown::{SHOWN, Shown};
use crate::geom::directions::{phi, theta};
use crate::geom::limits::MAX_THETA_I_DEG;
use egui::{CursorIcon, PointerButton, Response, Sense, Vec2};
use std::sync::Arc;

/// Most cells on a side of the picture on screen: more take longer than a drag waits for.
const MOST_CELLS: usize = 512;

/// Draws the tile.
pub fn disc_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let settings = state.scene.views.get::<DiscSettings>();
    toolbar_ui(ui, settings, out);
    let size = ui.available_size().max(Vec2::splat(60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Disc"));
    let Some((material, _)) = state.current() else {
        empty::empty_ui(
            ui,
            rect,
            "Open a material to see how it reflects into all directions.",
        );
        return false;
    };
    let pixels = rect.size().min_elem() * ui.ctx().pixels_per_point();
    let side = DiscField::side(pixels, MOST_CELLS);
    let query = DiscQuery::new(settings, Sources::of(state), side);
    // A fit under way needs the cores itself: the picture follows when it ends.
    if !state.current_run().is_some_and(FitRun::drives_model) {
        request(&state.caches, &query, out);
    }
    let (Some((_, fresh)), Some((of, field))) =
        (state.caches.shown(&query), state.caches.last::<DiscQuery>())
    else {
        empty::empty_ui(ui, rect, "In the making.");
        return false;
    };
    let spec = with_probe(settings, state.probe());
    let plot = plot(
        ui,
        (of, field),
        settings,
        &material.name,
        rect.size().into(),
    );
    let mut painter = ui.painter().with_clip_rect(rect);
    // A picture that follows a drag is never far behind: dimmed it would only flicker.
    if !fresh && !ui.input(|input| input.pointer.any_down()) {
        painter.multiply_opacity(DIMMED);
    }
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(&painter, rect.min, &plot.drawing, &palette);
    paint::paint(ui.painter(), rect.min, &plot.marks(&spec), &palette);
    interact(ui, &response, state, &plot, out);
    wheel(ui, &response, settings, field, out);
    response.contains_pointer()
}

fn set(settings: &DiscSettings, change: impl FnOnce(&mut DiscSettings)) -> Msg {
    let mut settings = settings.clone();
    change(&mut settings);
    Msg::set_view(settings)
}

fn toolbar_ui(ui: &mut egui::Ui, settings: &DiscSettings, out: &mut Vec<Msg>) {
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            for shown in SHOWN {
                let response = ui.selectable_label(settings.shown == shown, shown.name());
                if response.on_hover_text(shown.help()).clicked() {
                    out.push(set(settings, |settings| {
                        // Amounts, differences and factors have other ends.
                        if !(shown.is_amount() && settings.shown.is_amount()) {
                            settings.limits = None;
                        }
                        settings.shown = shown;
                    }));
                }
            }
        });
        bar.section(|ui| {
            controls::symbol_ui(ui, "θ_{i}");
            let range = 0.0..=MAX_THETA_I_DEG;
            let help = "Angle of incidence";
            if let Some(theta_i) = controls::angle_ui(ui, "theta_i", help, settings.theta_i, range)
            {
                out.push(set(settings, |settings| settings.theta_i = theta_i));
            }
        });
        bar.group(|ui| {
            let projections = PROJECTIONS.map(|projection| (projection, projection.name()));
            let projection =
                controls::choice_ui(ui, "Projection", settings.projection, &projections);
            if let Some(projection) = projection {
                out.push(set(settings, |settings| settings.projection = projection));
            }
        });
        bar.section(|ui| {
            if settings.shown != Shown::Ratio {
                let scales = RADIAL_SCALES.map(|scale| (scale, scale.name()));
                if let Some(scale) =
                    controls::choice_ui(ui, "Colour scale", settings.scale, &scales)
                {
                    out.push(set(settings, |settings| {
                        (settings.scale, settings.limits) = (scale, None);
                    }));
                }
            }
        });
        bar.group(|ui| {
            if let Some(channel) = controls::channel_ui(ui, settings.channel) {
                out.push(set(settings, |settings| settings.channel = channel));
            }
        });
        bar.group(|ui| {
            if let Some(cosine) = controls::cosine_ui(ui, settings.cosine) {
                out.push(set(settings, |settings| settings.cosine = cosine));
            }
        });
    });
}

/// Inputs of a plot without marks.
type PlotInputs = (DiscQuery, DiscSpec, String, [f32; 2]);

/// The plot without marks, from the frame before where it is still the same.
fn plot(
    ui: &egui::Ui,
    (of, field): (&DiscQuery, &DiscField),
    settings: &DiscSettings,
    name: &str,
    size: [f32; 2],
) -> Arc<DiscPlot> {
    let id = ui.scope_id().with("plot");
    let made: PlotInputs = (of.clone(), settings.clone(), name.to_string(), size);
    let kept = ui.data(|data| data.get_temp::<Arc<(PlotInputs, Arc<DiscPlot>)>>(id));
    if let Some(kept) = kept.filter(|kept| kept.0 == made) {
        return Arc::clone(&kept.1);
    }
    let plot = Arc::new(DiscPlot::new(settings, name, field, size));
    let kept = Arc::new((made, Arc::clone(&plot)));
    ui.data_mut(|data| data.insert_temp(id, kept));
    plot
}

fn interact(
    ui: &egui::Ui,
    response: &Response,
    state: &State,
    plot: &DiscPlot,
    out: &mut Vec<Msg>,
) {
    let settings = state.scene.views.get::<DiscSettings>();
    let place = |at: egui::Pos2| plot.frame.place((at - response.rect.min).into());
    let id = response.id.with("from");
    if response.drag_started_by(PointerButton::Primary) {
        // The light moves as far as the pointer, wherever it was pressed.
        let pressed = ui.input(|input| input.pointer.press_origin());
        let light = settings.projection.place(settings.wi());
        let from = pressed
            .map(place)
            .map(|at| [0, 1].map(|k| light[k] - at[k]));
        ui.data_mut(|data| data.insert_temp(id, from.unwrap_or_default()));
    }
    if response.dragged_by(PointerButton::Primary) {
        let from = ui.data(|data| data.get_temp::<[f64; 2]>(id));
        if let Some((from, at)) = from.zip(response.interact_pointer_pos().map(place)) {
            out.push(Msg::set_view(with_light_at(
                settings,
                [0, 1].map(|k| at[k] + from[k]),
            )));
        }
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        return;
    }
    if response.double_clicked() {
        let DiscSettings { theta_i, phi_i, .. } = DiscSettings::default();
        out.push(set(settings, |settings| {
            (settings.theta_i, settings.phi_i, settings.limits) = (theta_i, phi_i, None);
        }));
    }
    let under = |at: Option<egui::Pos2>| probe_at(settings, plot, (at? - response.rect.min).into());
    // The second click of two lets go what the first has pinned.
    if response.clicked()
        && let Some(probe) = under(response.interact_pointer_pos())
    {
        probe::pin(state, probe, out);
    }
    if !response.hovered() {
        return;
    }
    let under = under(response.hover_pos());
    probe::hover(state, under, out);
    if let Some(probe) = under {
        let [theta_o, phi_o] = [theta(probe.wo), phi(probe.wo)].map(f64::to_degrees);
        let head = format!("θo {theta_o:.1}°, φo {phi_o:.1}°");
        controls::values_tooltip(response, state, probe, settings.channel, &head);
    }
}

/// The wheel zooms the values.
fn wheel(
    ui: &egui::Ui,
    response: &Response,
    settings: &DiscSettings,
    field: &DiscField,
    out: &mut Vec<Msg>,
) {
    let factor = zoom::wheel(ui).filter(|_| response.hovered());
    let limits = factor.and_then(|factor| zoomed(&field.colors(settings), factor));
    if limits.is_some() {
        out.push(set(settings, |settings| settings.limits = limits));
    }
}

/// The light of the disc and the view direction under the pointer.
fn probe_at(settings: &DiscSettings, plot: &DiscPlot, point: Point) -> Option<Probe> {
    Some(Probe {
        wi: settings.wi(),
        wo: plot.frame.direction(point)?,
    })
}
