//! The polar lobes in the plane of incidence.

pub mod about;
pub mod paper;
pub mod settings;

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::Probe;
use crate::app::state::subjects::Subjects;
use crate::app::views::lobes::settings::{LobeSettings, drawable};
use crate::app::widgets::legend::legend_ui;
use crate::app::widgets::{controls, paint, probe, toolbar, zoom};
use crate::figure::Point;
use crate::figure::lobes::{LOBE_SCALES, LobePlot};
use crate::figure::palette::Palette;
use crate::geom::limits::MAX_THETA_I_DEG;
use egui::{CursorIcon, PointerButton, Sense, Vec2};

/// Largest distance in points at which the pointer takes a light by its arrow.
const GRAB: f32 = 14.0;
/// Draws the tile.
pub fn lobes_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let tile = state.scene.views.get::<LobeSettings>();
    toolbar_ui(ui, tile, out);
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(Vec2::splat(60.0)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Polar lobes"));
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    let size = [rect.width(), rect.height()];
    let subjects = Subjects::of(state);
    let plot = LobePlot::new(&drawable(tile, state.probe()), &subjects.list, size);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    interact(ui, &response, state, &plot, out);
    legend_ui(ui, rect.min, &plot.legend, &subjects, out);
    response.contains_pointer()
}

fn toolbar_ui(ui: &mut egui::Ui, tile: &LobeSettings, out: &mut Vec<Msg>) {
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            for scale in LOBE_SCALES {
                let (command, chosen) = (Command::UseScale(scale), tile.scale == scale);
                controls::command_choice_ui(ui, command, scale.name(), chosen, out);
            }
        });
        bar.section(|ui| {
            controls::symbol_ui(ui, "θ_{i}");
            for (index, theta_i) in tile.theta_i.iter().enumerate() {
                let name = format!("theta_i {}", index + 1);
                let range = 0.0..=MAX_THETA_I_DEG;
                if let Some(angle) =
                    controls::angle_ui(ui, &name, "Angle of incidence", *theta_i, range)
                {
                    out.push(Msg::set_view(with_theta_i(tile, index, angle.to_degrees())));
                }
            }
            let few = tile.theta_i.len() < 5;
            if ui
                .add_enabled(few, egui::Button::new("+").small())
                .on_hover_text("Add an angle")
                .clicked()
            {
                out.push(Msg::set_view(added(tile)));
            }
            let many = tile.theta_i.len() > 1;
            if ui
                .add_enabled(many, egui::Button::new("−").small())
                .on_hover_text("Remove the active angle")
                .clicked()
            {
                out.push(Msg::set_view(removed(tile)));
            }
        });
        bar.section(|ui| {
            if let Some(channel) = controls::channel_ui(ui, tile.channel) {
                out.push(Msg::set_view(LobeSettings {
                    channel,
                    ..tile.clone()
                }));
            }
        });
        bar.group(|ui| {
            if let Some(cosine) = controls::cosine_ui(ui, tile.cosine) {
                out.push(Msg::set_view(LobeSettings {
                    cosine,
                    ..tile.clone()
                }));
            }
        });
        bar.group(|ui| {
            let mut on = tile.shape_only;
            let tick = ui.checkbox(&mut on, "shape only");
            let hint = Command::ToggleShapeOnly.hint(ui.ctx());
            if tick.on_hover_text(hint).changed() {
                out.push(Msg::Run(Command::ToggleShapeOnly));
            }
        });
    });
}

fn with_theta_i(tile: &LobeSettings, index: usize, degrees: f64) -> LobeSettings {
    let mut tile = tile.clone();
    tile.theta_i[index] = degrees.clamp(0.0, MAX_THETA_I_DEG).to_radians();
    tile.active = index;
    tile
}

/// One more angle, in the widest gap.
fn added(tile: &LobeSettings) -> LobeSettings {
    let mut stops: Vec<f64> = tile
        .theta_i
        .iter()
        .map(|theta| theta.to_degrees())
        .collect();
    stops.extend([0.0, MAX_THETA_I_DEG]);
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

fn removed(tile: &LobeSettings) -> LobeSettings {
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
    let tile = state.scene.views.get::<LobeSettings>();
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
            out.push(Msg::set_view(with_theta_i(tile, index, degrees)));
        }
        return;
    }
    if response.double_clicked() {
        let LobeSettings {
            theta_i, active, ..
        } = LobeSettings::default();
        out.push(Msg::set_view(LobeSettings {
            theta_i,
            active,
            limits: None,
            ..tile.clone()
        }));
    }
    if response.clicked() {
        match near {
            Some(active) if !response.double_clicked() => out.push(Msg::set_view(LobeSettings {
                active,
                ..tile.clone()
            })),
            Some(_) => {}
            // The second click of two lets go what the first has pinned.
            None => {
                if let Some(probe) = probe_at(tile, plot, point) {
                    probe::pin(state, probe, out);
                }
            }
        }
    }
    if !response.hovered() {
        return;
    }
    if near.is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
    }
    if let Some(limits) = zoom::wheel(ui)
        .map(|factor| plot.frame.axis.zoomed(0.0, factor))
        .and_then(|ends| zoom::not_negative(&plot.frame.axis, ends))
    {
        out.push(Msg::set_view(LobeSettings {
            limits: Some(limits),
            ..tile.clone()
        }));
    }
    let under = probe_at(tile, plot, point);
    probe::hover(state, under, out);
    if let Some(probe) = under {
        let theta_o = probe.signed_theta_o().to_degrees();
        let head = format!("θo {theta_o:.1}°");
        controls::values_tooltip(response, state, probe, tile.channel, &head);
    }
}

/// The active light and the view direction under the pointer.
fn probe_at(tile: &LobeSettings, plot: &LobePlot, point: Point) -> Option<Probe> {
    let theta_o = plot.frame.theta_o_at(point)?;
    Some(Probe::in_plane(*tile.theta_i.get(tile.active)?, theta_o))
}
