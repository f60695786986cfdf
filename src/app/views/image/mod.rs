//! The image slice: data, model, residual or ratio over θh and θd.

pub mod about;
pub mod paper;
pub mod settings;

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::Probe;
use crate::app::state::sources::Sources;
use crate::app::views::image::settings::{ImageSettings, with_probe};
use crate::app::views::slices::settings::SliceSettings;
use crate::app::widgets::formula::number;
use crate::app::widgets::heat::{HeatOnScreen, heat_ui};
use crate::app::widgets::paint::plain;
use crate::app::widgets::{controls, probe, toolbar};
use crate::figure::heatmap::{Cell, HeatField};
use crate::figure::image_slice::ImageSpec;
use crate::figure::scale::RADIAL_SCALES;
use crate::figure::shown::{SHOWN, Shown};
use crate::geom::HalfDiff;
use std::sync::Arc;

/// Draws the tile.
pub fn image_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<ImageSettings>();
    toolbar_ui(ui, view, out);
    let spec = with_probe(view, state.probe());
    let sources = Sources::of(state);
    let fields = fields(ui, &spec, &sources);
    let name = state.current().map_or("", |(material, _)| &material.name);
    let heat = spec.heat_spec(name, &fields.shown, &fields.reference);
    let on_screen = heat_ui(ui, "Image slice", &heat, &fields.shown, false);
    if let Some(moved) = on_screen.moved_view(ui, view.view) {
        out.push(set(view, |view| view.view = moved));
    }
    interact(&on_screen, state, &spec, &sources, out);
    on_screen.response.contains_pointer()
}

fn set(view: &ImageSettings, change: impl FnOnce(&mut ImageSettings)) -> Msg {
    let mut view = view.clone();
    change(&mut view);
    Msg::set_view(view)
}

fn toolbar_ui(ui: &mut egui::Ui, view: &ImageSettings, out: &mut Vec<Msg>) {
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            for shown in SHOWN {
                let response = ui.selectable_label(view.shown == shown, shown.name());
                if response.on_hover_text(shown.help()).clicked() {
                    out.push(set(view, |view| view.shown = shown));
                }
            }
        });
        bar.section(|ui| {
            let hint = "Azimuth of the light around the half vector; 90° shows the usual picture";
            controls::symbol_ui(ui, "φ_{d}");
            if let Some(phi_d) = controls::angle_ui(ui, "phi_d", hint, view.phi_d, 0.0..=180.0) {
                out.push(set(view, |view| view.phi_d = phi_d));
            }
        });
        bar.group(|ui| {
            let mut root = view.root;
            let hint = "Spread θh by its square root, so that all cells are of one size";
            if ui.checkbox(&mut root, "√θh").on_hover_text(hint).changed() {
                out.push(set(view, |view| view.root = root));
            }
        });
        bar.section(|ui| {
            if view.shown != Shown::Ratio {
                let scales = RADIAL_SCALES.map(|scale| (scale, scale.name()));
                if let Some(scale) = controls::choice_ui(ui, "Colour scale", view.scale, &scales) {
                    out.push(set(view, |view| view.scale = scale));
                }
            }
        });
        bar.group(|ui| {
            if let Some(channel) = controls::channel_ui(ui, view.channel) {
                out.push(set(view, |view| view.channel = channel));
            }
        });
        bar.group(|ui| {
            if let Some(cosine) = controls::cosine_ui(ui, view.cosine) {
                out.push(set(view, |view| view.cosine = cosine));
            }
        });
    });
}

/// The cells that are shown, and those that the colours are made for.
struct Fields {
    of: (ImageSpec, Sources),
    shown: HeatField,
    reference: HeatField,
}

/// The fields from the frame before, where they are still the same.
fn fields(ui: &egui::Ui, spec: &ImageSpec, sources: &Sources) -> Arc<Fields> {
    let id = ui.scope_id().with("fields");
    let mut of = (
        ImageSpec {
            probe: None,
            view: Default::default(),
            ..spec.clone()
        },
        sources.clone(),
    );
    if spec.shown == Shown::Measured && sources.measured.is_some() {
        // The sliders move nothing then.
        of.1.model = None;
    }
    let kept = ui.data(|data| data.get_temp::<Arc<Fields>>(id));
    if let Some(kept) = kept.filter(|kept| kept.of == of) {
        return kept;
    }
    let (shown, reference) = spec.fields(sources.measured.as_ref(), sources.model.as_ref());
    let fields = Arc::new(Fields {
        of,
        shown,
        reference,
    });
    ui.data_mut(|data| data.insert_temp(id, Arc::clone(&fields)));
    fields
}

fn interact(
    on_screen: &HeatOnScreen,
    state: &State,
    spec: &ImageSpec,
    sources: &Sources,
    out: &mut Vec<Msg>,
) {
    let angles_at = |[theta_h, theta_d]: [f64; 2]| HalfDiff {
        theta_h: theta_h.to_radians(),
        theta_d: theta_d.to_radians(),
        phi_d: spec.phi_d,
    };
    let at = on_screen.clicked().map(angles_at);
    if let Some((angles, probe)) = at.and_then(|at| Some((at, Probe::from_angles(at)?))) {
        clicked(state, probe, angles, out);
    }
    if !on_screen.response.hovered() {
        return;
    }
    let under = on_screen.hovered().map(angles_at);
    probe::hover(state, under.and_then(Probe::from_angles), out);
    if let Some(angles) = under {
        tooltip(on_screen, spec, sources, angles);
    }
}

/// A click on a cell pins it and lays the slices over θh, θd and φd through it.
fn clicked(state: &State, probe: Probe, angles: HalfDiff, out: &mut Vec<Msg>) {
    probe::pin(state, probe, out);
    let mut slices = state.scene.views.get::<SliceSettings>().clone();
    (slices.spec.theta_h, slices.spec.theta_d) = (angles.theta_h, angles.theta_d);
    slices.spec.phi_d = angles.phi_d;
    if slices != *state.scene.views.get::<SliceSettings>() {
        out.push(Msg::set_view(slices));
    }
}

fn tooltip(on_screen: &HeatOnScreen, spec: &ImageSpec, sources: &Sources, at: HalfDiff) {
    // Of the cell, not of the place in it.
    let grid = crate::measured::Grid::FOLDED;
    let (theta_h, theta_d, _) = grid.bins_of(at);
    let cell = spec.angles(theta_h, theta_d);
    let value = |shown| {
        let spec = ImageSpec {
            shown,
            ..spec.clone()
        };
        spec.cell(sources.measured.as_ref(), sources.model.as_ref(), cell)
    };
    on_screen.response.clone().on_hover_ui_at_pointer(|ui| {
        let (h, d) = (at.theta_h.to_degrees(), at.theta_d.to_degrees());
        ui.label(format!("θh {h:.1}°, θd {d:.1}°, {}", spec.channel.name()));
        for (shown, name) in [
            (Shown::Measured, "measured"),
            (Shown::Model, "model"),
            (Shown::Ratio, "ratio"),
        ] {
            match value(shown) {
                Cell::Value(value) => ui.label(format!("{name} {}", plain(&number(value)))),
                Cell::Missing if shown == Shown::Measured => ui.label("not measured"),
                Cell::Outside if shown == Shown::Measured => ui.label("below the horizon"),
                Cell::Missing | Cell::Outside => continue,
            };
        }
    });
}
