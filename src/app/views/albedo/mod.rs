//! The albedo over the angle of incidence.

pub mod about;
pub mod paper;
pub mod settings;
pub mod work;

use crate::app::msg::Msg;
use crate::app::msg::cache::request;
use crate::app::state::State;
use crate::app::state::probe::Probe;
use crate::app::state::subjects::Subjects;
use crate::app::views::albedo::settings::AlbedoSettings;
use crate::app::views::albedo::work::{MeasuredAlbedo, curves, queries};
use crate::app::widgets::legend::legend_ui;
use crate::app::widgets::{controls, paint, probe, toolbar, zoom};
use crate::figure::ProbeMark;
use crate::figure::albedo::{AlbedoCurve, AlbedoPlot, AlbedoSpec};
use crate::figure::palette::Palette;
use crate::figure::samples::{Sample, value_at};
use crate::geom::limits::MAX_THETA_I;
use egui::{Sense, Vec2};
use std::f64::consts::FRAC_PI_2;

/// Draws the tile.
pub fn albedo_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<AlbedoSettings>();
    let subjects = Subjects::of(state);
    let (measured, models) = queries(&subjects.list);
    request(&state.caches, &measured, out);
    request(&state.caches, &models, out);
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            if let Some(channel) = controls::channel_ui(ui, view.spec.channel) {
                let mut changed = view.clone();
                changed.spec.channel = channel;
                out.push(Msg::set_view(changed));
            }
        });
        bar.group(|ui| {
            // Models are there at once: only the long job is worth a word.
            if let Some(progress) = state.caches.progress::<MeasuredAlbedo>() {
                ui.add(egui::ProgressBar::new(progress).desired_width(90.0));
                ui.weak("computing");
            }
        });
    });
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(Vec2::splat(60.0)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Albedo"));
    let curves = curves(&state.caches, &subjects.list);
    let spec = AlbedoSpec {
        probe: state.probe().map(|probe| ProbeMark {
            at: probe.theta_i(),
            exact: false,
        }),
        ..view.spec.clone()
    };
    let size = [rect.width(), rect.height()];
    let plot = AlbedoPlot::new(&spec, &subjects.list, &curves, size);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    interact(ui, &response, state, &plot, (&subjects, &curves), out);
    legend_ui(ui, rect.min, &plot.legend, &subjects, out);
    response.contains_pointer()
}

fn interact(
    ui: &egui::Ui,
    response: &egui::Response,
    state: &State,
    plot: &AlbedoPlot,
    (subjects, curves): (&Subjects, &[AlbedoCurve]),
    out: &mut Vec<Msg>,
) {
    let view = state.scene.views.get::<AlbedoSettings>();
    if let Some(zoom) = zoom::gesture(ui, response, &plot.frame) {
        let mut changed = view.clone();
        let spec = &mut changed.spec;
        let range = [0.0, FRAC_PI_2];
        zoom.apply(&plot.frame.y, range, &mut spec.window, &mut spec.limits);
        if changed != *view {
            out.push(Msg::set_view(changed));
        }
    }
    let Some(pointer) = response.interact_pointer_pos().or(response.hover_pos()) else {
        return;
    };
    let theta_i = plot.theta_i_at((pointer - response.rect.min).into());
    let theta_i = theta_i.map(|theta_i| theta_i.clamp(0.0, MAX_THETA_I));
    // Of all directions of view the mirror's stands for the angle.
    let under = theta_i.map(|theta_i| Probe::in_plane(theta_i, theta_i));
    // The second click of two lets go what the first has pinned.
    if let Some(probe) = under.filter(|_| response.clicked()) {
        probe::pin(state, probe, out);
    }
    if !response.hovered() || zoom::is_panning(response) {
        return;
    }
    probe::hover(state, under, out);
    let Some(theta_i) = theta_i else { return };
    response.clone().on_hover_ui_at_pointer(|ui| {
        ui.label(format!("θi {:.1}°", theta_i.to_degrees()));
        for (subject, curve) in subjects.list.iter().zip(curves) {
            let of = |value: &dyn Fn(&crate::figure::albedo::AlbedoPoint) -> f64| {
                let samples: Vec<Sample> = curve
                    .points
                    .iter()
                    .map(|point| Sample {
                        x: point.theta_i,
                        value: Some(value(point)),
                    })
                    .collect();
                value_at(&samples, theta_i)
            };
            let channel = view.spec.channel;
            let albedo = of(&|point| channel.of(point.rgb));
            let share = of(&|point| point.measured);
            if let (false, Some(albedo), Some(share)) = (subject.hidden, albedo, share) {
                let label = &subject.label;
                ui.label(if share < 0.9995 {
                    format!("{label}: {albedo:.3}, over {:.1} %", 100.0 * share)
                } else {
                    format!("{label}: {albedo:.3}")
                });
            }
        }
    });
}
