//! The lobes in space: turned by the hand, for the probe's light.

pub mod about;
pub mod callback;
pub mod paper;
pub mod settings;

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::Probe;
use crate::app::state::subjects::Subjects;
use crate::app::views::lobe3d::settings::Lobe3dSettings;
use crate::app::widgets::legend::legend_ui;
use crate::app::widgets::{controls, paint, probe, toolbar};
use crate::figure::lobe3d::{Camera, Detail, Lobes, Overlay, Shape, pick};
use crate::figure::palette::Palette;
use crate::figure::scale::RADIAL_SCALES;
use crate::geom::limits::{MAX_THETA_I, MAX_THETA_I_DEG};
use egui::{CursorIcon, PointerButton, Sense, Vec2};
use glam::{DQuat, DVec3};
use std::f64::consts::PI;
use std::sync::Arc;

/// Larger by this factor, as a power of e, per point that the wheel scrolls.
const ZOOM_PER_POINT: f32 = 0.004;

/// Draws the tile.
pub fn lobe3d_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let view = state.scene.views.get::<Lobe3dSettings>();
    // A probe from elsewhere may have its light anywhere around the normal.
    let probed = state.probe().map(upright);
    let theta_i = probed.map_or(view.theta_i, Probe::theta_i).min(MAX_THETA_I);
    toolbar_ui(ui, view, probed.map(|_| theta_i), out);
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(Vec2::splat(60.0)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "3D lobe"));
    let subjects = Subjects::of(state);
    let shape = Shape {
        theta_i,
        scale: view.scale,
        cosine: view.cosine,
        channel: view.channel,
        detail: Detail::of([rect.width(), rect.height()], view.camera.zoom),
    };
    let lobes = lobes_of(ui, shape, &subjects);
    let wo = probed.map(|probe| probe.wo);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    let overlay = Overlay::new(&lobes, view.camera, wo, [rect.width(), rect.height()]);
    callback::paint(ui, rect, &lobes, wo, &overlay.projection, &palette);
    paint::paint(ui.painter(), rect.min, &overlay.drawing, &palette);
    interact(ui, &response, state, &lobes, &overlay, out);
    legend_ui(ui, rect.min, &overlay.legend, &subjects, out);
    response.contains_pointer()
}

/// Probe turned around the normal such that the light comes from the left.
fn upright(probe: Probe) -> Probe {
    let flat = probe.wi.truncate();
    if flat.length() < 1e-9 {
        return probe;
    }
    let turn = DQuat::from_rotation_z(PI - flat.y.atan2(flat.x));
    Probe {
        wi: turn * probe.wi,
        wo: turn * probe.wo,
    }
}

/// The lobes, made again where an input has changed. egui keeps them from frame to frame.
fn lobes_of(ui: &egui::Ui, shape: Shape, subjects: &Subjects) -> Arc<Lobes> {
    let id = ui.scope_id().with("lobes");
    let before: Option<Arc<Lobes>> = ui.data(|data| data.get_temp(id));
    if let Some(before) = &before
        && before.are_of(&shape, &subjects.list)
    {
        return Arc::clone(before);
    }
    let lobes = Arc::new(Lobes::new(shape, &subjects.list, before.as_deref()));
    ui.data_mut(|data| data.insert_temp(id, Arc::clone(&lobes)));
    lobes
}

fn toolbar_ui(ui: &mut egui::Ui, view: &Lobe3dSettings, probed: Option<f64>, out: &mut Vec<Msg>) {
    let mut changed = *view;
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            for scale in RADIAL_SCALES {
                let help = "How values become lengths";
                if ui
                    .selectable_label(view.scale == scale, scale.name())
                    .on_hover_text(help)
                    .clicked()
                {
                    changed.scale = scale;
                }
            }
        });
        bar.section(|ui| {
            controls::symbol_ui(ui, "θ_{i}");
            let help = if probed.is_some() {
                "Angle of incidence: the probe's"
            } else {
                "Angle of incidence"
            };
            ui.add_enabled_ui(probed.is_none(), |ui| {
                let angle = probed.unwrap_or(view.theta_i);
                let range = 0.0..=MAX_THETA_I_DEG;
                if let Some(angle) = controls::angle_ui(ui, "theta_i", help, angle, range) {
                    changed.theta_i = angle;
                }
            });
        });
        bar.section(|ui| {
            if let Some(channel) = controls::channel_ui(ui, view.channel) {
                changed.channel = channel;
            }
        });
        bar.group(|ui| {
            if let Some(cosine) = controls::cosine_ui(ui, view.cosine) {
                changed.cosine = cosine;
            }
        });
    });
    if changed != *view {
        out.push(Msg::set_view(changed));
    }
}

fn interact(
    ui: &egui::Ui,
    response: &egui::Response,
    state: &State,
    lobes: &Lobes,
    overlay: &Overlay,
    out: &mut Vec<Msg>,
) {
    let view = state.scene.views.get::<Lobe3dSettings>();
    let origin = response.rect.min;
    let on_canvas = |at: egui::Pos2| [at.x - origin.x, at.y - origin.y];
    let mut camera = view.camera;
    if response.dragged_by(PointerButton::Primary)
        && let Some(pointer) = response.interact_pointer_pos()
    {
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        let (to, from) = (
            on_canvas(pointer),
            on_canvas(pointer - response.drag_delta()),
        );
        camera = overlay.projection.dragged(from, to);
    }
    if response.double_clicked() {
        camera = Camera::default();
    }
    if let Some(pointer) = response.hover_pos().filter(|_| response.hovered()) {
        let point = on_canvas(pointer);
        let factor = ui.input(|input| {
            input.zoom_delta() * (ZOOM_PER_POINT * input.smooth_scroll_delta().y).exp()
        });
        if factor != 1.0 {
            camera = overlay.projection.zoomed(f64::from(factor), point);
        }
        let under = probe_at(lobes, overlay, point);
        probe::hover(state, under, out);
        if let Some(probe) = under.filter(|_| response.clicked()) {
            probe::pin(state, probe, out);
        }
    }
    if camera != view.camera {
        out.push(Msg::set_view(Lobe3dSettings { camera, ..*view }));
    }
}

/// The light of the lobes and the direction of the nearest point of a lobe under the pointer.
fn probe_at(lobes: &Lobes, overlay: &Overlay, point: [f32; 2]) -> Option<Probe> {
    let wo: DVec3 = pick(lobes.meshes(), &overlay.projection, point)?;
    Some(Probe { wi: lobes.wi(), wo })
}
