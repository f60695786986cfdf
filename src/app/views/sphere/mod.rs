//! The live-shaded sphere: data, model, both split by a line, or side by side.

pub mod about;
pub mod callback;
pub mod error;
pub mod paper;
pub mod settings;

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::{Probe, same};
use crate::app::views::sphere::callback::Half;
use crate::app::views::sphere::settings::{SHOWS, Show, SphereSettings};
use crate::app::widgets::{controls, empty, probe, toolbar, zoom};
use crate::geom::HalfDiff;
use crate::geom::limits::MAX_EXPOSURE_STOPS;
use crate::geom::sight::Sight;
use crate::geom::sphere::{
    LIGHT_PRESETS, highlight_of, light_for_highlight_at, local_directions, point_of,
};
use egui::{Align2, Color32, CursorIcon, FontId, Pos2, Rect, Sense, Stroke, Vec2, pos2, vec2};

/// Largest distance in points at which the pointer takes the split line.
const GRAB: f32 = 7.0;
/// Width in points below which the two captions of a split sphere would lie over each other.
const BOTH_CAPTIONS: f32 = 132.0;
/// Largest distance from a highlight, in sphere radii, at which a drag takes that light rather than the first one.
const NEAR_HIGHLIGHT: f64 = 0.35;

/// Draws the tile.
pub fn sphere_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let tile = state.scene.views.get::<SphereSettings>();
    toolbar_ui(ui, state, tile, out);
    let (rect, response) = ui.allocate_exact_size(
        ui.available_size().max(Vec2::splat(40.0)),
        Sense::click_and_drag(),
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Sphere"));
    let Some((material, opened)) = state.current() else {
        empty::empty_ui(ui, rect, "Open a material to see it on a sphere.");
        return false;
    };
    let spheres = layout(rect, tile);
    for sphere in &spheres {
        callback::paint(ui.painter(), sphere, state, material, opened);
    }
    if let Some(split_x) = split_line(&spheres[0]) {
        draw_split(ui, &spheres[0], split_x);
    }
    for sphere in &spheres {
        caption(ui, sphere);
    }
    if let Show::Error(error) = tile.show {
        error::bar(ui, rect, &spheres[1], error, tile.view.exposure_stops);
    }
    if let Some(text) = state.loading() {
        let (at, weak) = (
            rect.center_bottom() - vec2(0.0, 2.0),
            ui.visuals().weak_text_color(),
        );
        let font = FontId::proportional(12.0);
        ui.painter()
            .text(at, Align2::CENTER_BOTTOM, text, font, weak);
    }
    marks(ui, state, tile, &spheres);
    interact(ui, &response, state, &spheres, out);
    response.contains_pointer()
}

fn toolbar_ui(ui: &mut egui::Ui, state: &State, tile: &SphereSettings, out: &mut Vec<Msg>) {
    toolbar::row_ui(ui, |bar| {
        for show in SHOWS {
            bar.group(|ui| {
                let (command, chosen) = (Command::UseShow(show), tile.show == show);
                controls::command_choice_ui(ui, command, show.name(), chosen, out);
            });
        }
        bar.section(|ui| {
            ui.menu_button("Lights", |ui| {
                for (index, preset) in LIGHT_PRESETS.iter().enumerate() {
                    let checked = Command::UseLights(index).is_checked(state).unwrap_or(false);
                    if ui
                        .selectable_label(checked, preset.name)
                        .on_hover_text(preset.help)
                        .clicked()
                    {
                        out.push(Msg::Run(Command::UseLights(index)));
                    }
                }
            });
        });
        bar.section(|ui| {
            let mut exposure = tile.view.exposure_stops;
            let label = ui.label("Exposure");
            let drag = egui::DragValue::new(&mut exposure)
                .speed(0.02)
                .range(-MAX_EXPOSURE_STOPS..=MAX_EXPOSURE_STOPS)
                .suffix(" EV")
                .fixed_decimals(1);
            let response = ui
                .add(drag)
                .labelled_by(label.id)
                .on_hover_text("Exposure in stops. Double click on the word: 0.");
            if response.changed() {
                out.push(Msg::set_view(with(tile, |tile| {
                    tile.view.exposure_stops = exposure;
                })));
            }
            if label.interact(Sense::click()).double_clicked() {
                out.push(Msg::set_view(with(tile, |tile| {
                    tile.view.exposure_stops = 0.0;
                })));
            }
        });
    });
}

/// A sphere on screen.
pub struct SphereOnScreen {
    /// The square in which it is seen.
    pub frame: Rect,
    /// The square around it, larger than the frame where it is enlarged.
    pub rect: Rect,
    /// Content of the sphere.
    pub half: Half,
}

impl SphereOnScreen {
    /// A point in units of the radius, x to the right and y up.
    fn unit(&self, point: Pos2) -> (f64, f64) {
        let offset = (point - self.rect.center()) / (0.5 * self.rect.width());
        (f64::from(offset.x), f64::from(-offset.y))
    }
}

fn layout(rect: Rect, tile: &SphereSettings) -> Vec<SphereOnScreen> {
    let square = |rect: Rect, half| {
        let side = (rect.width().min(rect.height()) - 8.0).max(16.0);
        let frame = Rect::from_center_size(rect.center(), Vec2::splat(side));
        let Sight { zoom, center } = tile.sight;
        let side = side * zoom as f32;
        let middle = 0.5 * side * vec2(center[0] as f32, -center[1] as f32);
        SphereOnScreen {
            frame,
            rect: Rect::from_center_size(frame.center() - middle, Vec2::splat(side)),
            half,
        }
    };
    match tile.show {
        Show::Measured => vec![square(rect, Half::Measured)],
        Show::Model => vec![square(rect, Half::Model)],
        Show::Split => vec![square(rect, Half::Split(tile.split))],
        Show::SideBySide => {
            let (left, right) = rect.split_left_right_at_fraction(0.5);
            vec![square(left, Half::Measured), square(right, Half::Model)]
        }
        Show::Error(error) => {
            let rect = error::beside_bar(rect);
            let (left, right) = rect.split_left_right_at_fraction(0.5);
            let split = square(left, Half::Split(tile.split));
            vec![split, square(right, Half::Error(error))]
        }
    }
}

fn split_line(sphere: &SphereOnScreen) -> Option<f32> {
    let Half::Split(split) = sphere.half else {
        return None;
    };
    let x = sphere.rect.center().x + 0.5 * sphere.rect.width() * split as f32;
    sphere.frame.x_range().contains(x).then_some(x)
}

fn draw_split(ui: &egui::Ui, sphere: &SphereOnScreen, x: f32) {
    let painter = ui.painter();
    let color = ui.visuals().strong_text_color();
    // Light on dark and dark on light: the sphere may be either, whatever the theme.
    for (width, color, opacity) in [(3.0, Color32::BLACK, 0.35), (1.0, Color32::WHITE, 0.8)] {
        let stroke = Stroke::new(width, color.gamma_multiply(opacity));
        painter.vline(x, sphere.frame.y_range(), stroke);
    }
    let handle = Rect::from_center_size(pos2(x, sphere.frame.bottom() - 14.0), vec2(7.0, 20.0));
    painter.rect(
        handle,
        3.5,
        ui.visuals().panel_fill,
        Stroke::new(1.0, color),
        egui::StrokeKind::Middle,
    );
}

fn caption(ui: &egui::Ui, sphere: &SphereOnScreen) {
    let put = |at: Pos2, align: Align2, text: &str| word(ui, at, align, text, 13.0);
    let rect = sphere.frame;
    match sphere.half {
        Half::Split(_) if rect.width() < BOTH_CAPTIONS => {}
        Half::Split(_) => {
            put(rect.left_top(), Align2::LEFT_TOP, "measured");
            put(rect.right_top(), Align2::RIGHT_TOP, "model");
        }
        Half::Measured => put(rect.left_top(), Align2::LEFT_TOP, "measured"),
        Half::Model => put(rect.left_top(), Align2::LEFT_TOP, "model"),
        Half::Error(_) => {}
    }
}

/// Writes a word in a corner of a frame, to be read over an enlarged sphere as well.
pub(crate) fn word(ui: &egui::Ui, at: Pos2, align: Align2, text: &str, size: f32) {
    let (font, visuals) = (FontId::proportional(size), ui.visuals());
    let color = visuals.weak_text_color();
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, color);
    let rect = align.anchor_size(at, galley.size());
    let ground = visuals.panel_fill.gamma_multiply(0.8);
    ui.painter()
        .rect_filled(rect.expand2(vec2(3.0, 0.0)), 3.0, ground);
    ui.painter().galley(rect.min, galley, color);
}

/// Marks of the probe under each light. A sphere under one light has one θd: elsewhere the mark is hollow.
fn marks(ui: &egui::Ui, state: &State, tile: &SphereSettings, spheres: &[SphereOnScreen]) {
    let angles = state
        .probe()
        .and_then(|probe| HalfDiff::from_directions(probe.wi, probe.wo));
    let Some(angles) = angles else {
        return;
    };
    let found: Vec<_> = tile
        .view
        .lights
        .iter()
        .filter_map(|light| point_of(angles, light))
        .collect();
    let is_exact = |theta_d: f64| same(theta_d, angles.theta_d);
    // Where one light shows the probe itself, the others have nothing to add.
    let any_exact = found.iter().any(|(_, theta_d)| is_exact(*theta_d));
    for ((x, y), theta_d) in found {
        let exact = is_exact(theta_d);
        if any_exact && !exact {
            continue;
        }
        for sphere in spheres {
            let radius = f64::from(0.5 * sphere.rect.width());
            let offset = vec2((x * radius) as f32, (-y * radius) as f32);
            let at = sphere.rect.center() + offset;
            if !sphere.frame.contains(at) {
                continue;
            }
            // Light on dark and dark on light: the picture may be either.
            for (radius, color) in [(5.0, Color32::BLACK), (4.0, Color32::WHITE)] {
                ui.painter()
                    .circle_stroke(at, radius, Stroke::new(1.0, color));
            }
            if exact {
                ui.painter().circle_filled(at, 2.0, Color32::WHITE);
            }
        }
    }
}

/// Thing that a drag which began on the tile moves, kept by egui while it lasts.
#[derive(Clone, Copy)]
enum Grabbed {
    Split,
    Light(usize),
}

fn interact(
    ui: &egui::Ui,
    response: &egui::Response,
    state: &State,
    spheres: &[SphereOnScreen],
    out: &mut Vec<Msg>,
) {
    let tile = state.scene.views.get::<SphereSettings>();
    let Some(pointer) = response.interact_pointer_pos().or(response.hover_pos()) else {
        return;
    };
    let Some(sphere) = spheres.iter().min_by(|a, b| {
        let distance = |s: &SphereOnScreen| s.frame.distance_to_pos(pointer);
        distance(a).total_cmp(&distance(b))
    }) else {
        return;
    };
    let on_split = |at: Pos2| {
        split_line(sphere)
            .is_some_and(|x| (at.x - x).abs() < GRAB && sphere.frame.y_range().contains(at.y))
    };
    let (x, y) = sphere.unit(pointer);
    let id = response.id.with("grabbed");
    if response.drag_started_by(egui::PointerButton::Primary) {
        // The pointer may have gone far between the press and the frame that calls it a drag.
        let pressed = ui
            .input(|input| input.pointer.press_origin())
            .unwrap_or(pointer);
        let (x, y) = sphere.unit(pressed);
        let grabbed = if on_split(pressed) {
            Grabbed::Split
        } else {
            Grabbed::Light(nearest_light(tile, x, y))
        };
        ui.data_mut(|data| data.insert_temp(id, grabbed));
    }
    if response.dragged_by(egui::PointerButton::Primary) {
        match ui.data(|data| data.get_temp(id)) {
            Some(Grabbed::Split) => {
                out.push(Msg::set_view(with(tile, |tile| {
                    tile.split = x.clamp(-1.0, 1.0);
                })));
            }
            Some(Grabbed::Light(light)) => out.push(Msg::set_view(with(tile, |tile| {
                if let Some(light) = tile.view.lights.get_mut(light) {
                    light.direction = light_for_highlight_at(x, y);
                }
            }))),
            None => {}
        }
    }
    if response.double_clicked() {
        out.push(Msg::set_view(SphereSettings {
            show: tile.show,
            ..SphereSettings::default()
        }));
    }
    if response.hovered() {
        if let Some(factor) = zoom::wheel(ui) {
            out.push(Msg::set_view(with(tile, |tile| {
                tile.sight = tile.sight.zoomed(factor, [x, y]);
            })));
        }
        ui.ctx().set_cursor_icon(if on_split(pointer) {
            CursorIcon::ResizeHorizontal
        } else {
            CursorIcon::Crosshair
        });
        let light = tile.view.lights.get(nearest_light(tile, x, y));
        let under = light
            .and_then(|light| local_directions(x, y, light))
            .map(|(wi, wo)| Probe { wi, wo });
        probe::hover(state, under, out);
        if let Some(probe) = under.filter(|_| response.clicked()) {
            probe::pin(state, probe, out);
        }
    }
}

/// The light whose highlight is near the point; else the first.
fn nearest_light(tile: &SphereSettings, x: f64, y: f64) -> usize {
    let distance = |index: usize| {
        let (hx, hy) = highlight_of(&tile.view.lights[index]);
        (hx - x).hypot(hy - y)
    };
    (0..tile.view.lights.len())
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
        .filter(|index| distance(*index) < NEAR_HIGHLIGHT)
        .unwrap_or(0)
}

fn with(tile: &SphereSettings, change: impl FnOnce(&mut SphereSettings)) -> SphereSettings {
    let mut tile = tile.clone();
    change(&mut tile);
    tile
}
