//! The polar lobes in the plane of incidence.

use crate::app::command::Command;
use crate::app::fitting::{KeptFit, variant_name};
use crate::app::formula::number;
use crate::app::paint;
use crate::app::state::{LobeTile, Material, Probe, Scene, State};
use crate::app::update::Msg;
use crate::brdf::Fresnel;
use crate::figure::lobes::{CHANNELS, Curve, LobePlot, LobeSpec, Look};
use crate::figure::palette::{Palette, companion};
use crate::figure::scale::RADIAL_SCALES;
use crate::figure::text::RichText;
use crate::fit::Variant;
use crate::geom::{Rgb, direction};
use egui::{CursorIcon, PointerButton, Sense, Vec2};
use glam::DVec3;
use std::f64::consts::PI;

/// How near in points the pointer must be to a light's arrow to take it.
const GRAB: f32 = 14.0;
/// The light cannot be dragged past the last degree.
const MAX_THETA_I: f64 = 89.0;

/// Draws the tile.
pub fn lobes_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let tile = &state.scene.lobes;
    toolbar_ui(ui, tile, out);
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(Vec2::splat(60.0)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Polar lobes"));
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    let size = [rect.width(), rect.height()];
    let Some((material, opened)) = state.current() else {
        let plot = LobePlot::new(&spec(tile, None), &[], size);
        paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
        return;
    };
    let measured = |wi: DVec3, wo: DVec3| material.table.lookup(wi, wo, state.scene.lookup);
    let model = |wi: DVec3, wo: DVec3| opened.brdf.f_r(wi, wo);
    let series = state.scene.selected;
    let beside = overlays(material, series);
    let mut curves = vec![
        Curve {
            label: material.name.clone(),
            look: Look::Measured,
            series,
            f_r: &measured,
        },
        Curve {
            label: opened.brdf.model.name.to_string(),
            look: Look::Model,
            series,
            f_r: &model,
        },
    ];
    curves.extend(beside.iter().map(|overlay| Curve {
        label: variant_name(overlay.variant),
        look: overlay.look,
        series: overlay.series,
        f_r: &overlay.f_r,
    }));
    let plot = LobePlot::new(&spec(tile, probe_theta_o(state, tile)), &curves, size);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    interact(ui, &response, state, &plot, out);
}

/// A kept fit whose lobes are drawn beside the model's.
struct Overlay<F> {
    variant: Variant,
    look: Look,
    series: usize,
    f_r: F,
}

/// The ticked fits of a material in the order of the models: a colour per model, dots without and dashes with Fresnel.
fn overlays(
    material: &Material,
    series: usize,
) -> Vec<Overlay<impl Fn(DVec3, DVec3) -> Option<Rgb>>> {
    let mut ticked: Vec<&KeptFit> = material.fits.iter().filter(|fit| fit.overlaid).collect();
    ticked.sort_by_key(|fit| (fit.variant().model.index(), fit.variant().fresnel.index()));
    let overlay = |fit: &KeptFit| {
        let (variant, brdf) = (fit.variant(), fit.outcome.brdf);
        let (look, series) = look_beside(variant, series);
        Overlay {
            variant,
            look,
            series,
            f_r: move |wi: DVec3, wo: DVec3| brdf.f_r(wi, wo),
        }
    };
    ticked.into_iter().map(overlay).collect()
}

/// Line and colour of a variant beside the model of series `series`.
pub(super) fn look_beside(variant: Variant, series: usize) -> (Look, usize) {
    let long = variant.fresnel != Fresnel::None;
    (
        Look::Beside { long },
        companion(series, variant.model.index()),
    )
}

fn spec(tile: &LobeTile, probe_theta_o: Option<f64>) -> LobeSpec {
    LobeSpec {
        theta_i: tile.theta_i.clone(),
        active: tile.active,
        scale: tile.scale,
        with_cosine: tile.with_cosine,
        channel: tile.channel,
        probe_theta_o,
        ..LobeSpec::default()
    }
}

/// The probe as a point of this plot, if it lies in its plane of incidence under the active light.
fn probe_theta_o(state: &State, tile: &LobeTile) -> Option<f64> {
    let probe = state.probe?;
    let theta_i = *tile.theta_i.get(tile.active)?;
    let same_light = (probe.wi - to_light(theta_i)).length() < 1e-6;
    (same_light && probe.wo.y.abs() < 1e-9).then(|| probe.wo.x.atan2(probe.wo.z))
}

/// Light from the left.
fn to_light(theta_i: f64) -> DVec3 {
    direction(theta_i, PI)
}

fn toolbar_ui(ui: &mut egui::Ui, tile: &LobeTile, out: &mut Vec<Msg>) {
    ui.horizontal_wrapped(|ui| {
        for scale in RADIAL_SCALES {
            let response = ui.selectable_label(tile.scale == scale, scale.name());
            if response
                .on_hover_text(Command::UseScale(scale).hint(ui.ctx()))
                .clicked()
            {
                out.push(Msg::Run(Command::UseScale(scale)));
            }
        }
        ui.separator();
        let theta_i = RichText::parse("θ_{i}");
        ui.label(paint::rich_text_job(
            &theta_i,
            14.0,
            ui.visuals().text_color(),
        ));
        for (index, theta_i) in tile.theta_i.iter().enumerate() {
            let mut degrees = theta_i.to_degrees();
            let drag = egui::DragValue::new(&mut degrees)
                .speed(0.2)
                .range(0.0..=MAX_THETA_I)
                .suffix("°")
                .fixed_decimals(0);
            let response = ui.add(drag).on_hover_text("Angle of incidence");
            response.widget_info(|| {
                egui::WidgetInfo::labeled(
                    egui::Role::SpinButton,
                    true,
                    format!("theta_i {}", index + 1),
                )
            });
            if response.changed() {
                out.push(Msg::SetLobes(with_theta_i(tile, index, degrees)));
            }
        }
        let few = tile.theta_i.len() < 5;
        if ui
            .add_enabled(few, egui::Button::new("+").small())
            .on_hover_text("Add an angle")
            .clicked()
        {
            out.push(Msg::SetLobes(added(tile)));
        }
        let many = tile.theta_i.len() > 1;
        if ui
            .add_enabled(many, egui::Button::new("−").small())
            .on_hover_text("Remove the active angle")
            .clicked()
        {
            out.push(Msg::SetLobes(removed(tile)));
        }
        ui.separator();
        let mut channel = tile.channel;
        let menu = egui::ComboBox::from_id_salt("channel")
            .width(92.0)
            .selected_text(channel.name());
        let menu = menu.show_ui(ui, |ui| {
            for choice in CHANNELS {
                ui.selectable_value(&mut channel, choice, choice.name());
            }
        });
        ui.ctx()
            .accesskit_node_builder(menu.response.id, |node| node.set_label("Channel"));
        if channel != tile.channel {
            out.push(Msg::SetLobes(LobeTile {
                channel,
                ..tile.clone()
            }));
        }
        let mut with_cosine = tile.with_cosine;
        let hint = Command::ToggleCosine.hint(ui.ctx());
        if ui
            .checkbox(&mut with_cosine, "× cos θi")
            .on_hover_text(hint)
            .changed()
        {
            out.push(Msg::Run(Command::ToggleCosine));
        }
    });
}

fn with_theta_i(tile: &LobeTile, index: usize, degrees: f64) -> LobeTile {
    let mut tile = tile.clone();
    tile.theta_i[index] = degrees.clamp(0.0, MAX_THETA_I).to_radians();
    tile.active = index;
    tile
}

/// One more angle, in the widest gap.
fn added(tile: &LobeTile) -> LobeTile {
    let mut stops: Vec<f64> = tile
        .theta_i
        .iter()
        .map(|theta| theta.to_degrees())
        .collect();
    stops.extend([0.0, MAX_THETA_I]);
    stops.sort_by(f64::total_cmp);
    let widest = stops
        .windows(2)
        .max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    let middle = widest.map_or(45.0, |gap| (0.5 * (gap[0] + gap[1])).round());
    let mut tile = tile.clone();
    tile.theta_i.push(middle.to_radians());
    tile.active = tile.theta_i.len() - 1;
    tile
}

fn removed(tile: &LobeTile) -> LobeTile {
    let mut tile = tile.clone();
    tile.theta_i.remove(tile.active);
    tile.active = tile.active.min(tile.theta_i.len() - 1);
    tile
}

fn interact(
    ui: &egui::Ui,
    response: &egui::Response,
    state: &State,
    plot: &LobePlot,
    out: &mut Vec<Msg>,
) {
    let tile = &state.scene.lobes;
    let Some(pointer) = response.interact_pointer_pos().or(response.hover_pos()) else {
        return;
    };
    let point = (pointer - response.rect.min).into();
    let id = response.id.with("grabbed");
    let near = plot.frame.nearest_light(point, GRAB);
    if response.drag_started_by(PointerButton::Primary) {
        // The pointer may have gone far between the press and the frame that calls it a drag.
        let pressed = ui
            .input(|input| input.pointer.press_origin())
            .unwrap_or(pointer);
        let taken = plot
            .frame
            .nearest_light((pressed - response.rect.min).into(), GRAB);
        ui.data_mut(|data| data.insert_temp(id, taken));
    }
    if response.dragged_by(PointerButton::Primary) {
        if let Some(Some(index)) = ui.data(|data| data.get_temp::<Option<usize>>(id)) {
            let degrees = plot.frame.theta_i_at(point).to_degrees();
            out.push(Msg::SetLobes(with_theta_i(tile, index, degrees)));
        }
        return;
    }
    if response.double_clicked() {
        let scene = Scene::default();
        out.push(Msg::SetLobes(LobeTile {
            theta_i: scene.lobes.theta_i,
            active: scene.lobes.active,
            ..tile.clone()
        }));
    } else if response.clicked()
        && let Some(index) = near
    {
        out.push(Msg::SetLobes(LobeTile {
            active: index,
            ..tile.clone()
        }));
    }
    if !response.hovered() {
        return;
    }
    if near.is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
    }
    let probe = plot.frame.theta_o_at(point).and_then(|theta_o| {
        let theta_i = *tile.theta_i.get(tile.active)?;
        Some(Probe {
            wi: to_light(theta_i),
            wo: direction(theta_o.abs(), if theta_o < 0.0 { PI } else { 0.0 }),
        })
    });
    if probe != state.probe {
        out.push(Msg::SetProbe(probe));
    }
    if let Some(probe) = probe {
        value_tooltip(response, state, probe);
    }
}

fn value_tooltip(response: &egui::Response, state: &State, probe: Probe) {
    let (measured, model) = state.values_at(probe);
    let channel = state.scene.lobes.channel;
    response.clone().on_hover_ui_at_pointer(|ui| {
        let theta_o = probe.wo.x.atan2(probe.wo.z).to_degrees();
        ui.label(format!("θo {theta_o:.1}°, {}", channel.name()));
        let text = |value: Option<Rgb>, none: &str| {
            value.map_or(none.to_string(), |rgb| {
                crate::app::paint::plain(&number(channel.of(rgb)))
            })
        };
        ui.label(format!("measured {}", text(measured, "not measured")));
        ui.label(format!("model {}", text(model, "–")));
    });
}
