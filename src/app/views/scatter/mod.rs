//! The materials by α and s of their combined fits: some are Phong-like, some Blinn-Phong-like.

pub mod about;
pub mod paper;
pub mod settings;

use crate::app::msg::Msg;
use crate::app::msg::library::LibraryMsg;
use crate::app::state::State;
use crate::app::state::material::Material;
use crate::app::views::scatter::settings::{ScatterSettings, with_window};
use crate::app::widgets::formula::{number, percent};
use crate::app::widgets::zoom::Zoom;
use crate::app::widgets::{empty, paint, zoom};
use crate::brdf::{Brdf, COMBINED};
use crate::figure::RichText;
use crate::figure::palette::{Palette, Role};
use crate::figure::scatter::{ScatterDot, ScatterPlot};
use crate::files;
use egui::{CursorIcon, Sense, Vec2};
use std::path::PathBuf;

/// A material with a fit of the combined model.
struct ScatterRow {
    brdf: Brdf,
    dot: ScatterDot,
    error: f64,
    /// Shows it.
    place: MaterialPlace,
}

/// Place of a material.
enum MaterialPlace {
    /// Position among the open ones.
    Open(usize),
    /// File of the folder.
    File(PathBuf),
}

/// Materials with a fit of the combined model: the name, the fit and the colour of each.
pub fn combined_fits(state: &State) -> Vec<(String, Brdf, Role)> {
    let rows = rows(state).into_iter();
    rows.map(|row| (row.dot.name, row.brdf, row.dot.ring.unwrap_or(row.dot.fill)))
        .collect()
}

/// Draws the tile.
pub fn scatter_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) -> bool {
    let size = ui.available_size().max(Vec2::splat(60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Scatter"));
    let view = *state.scene.views.get::<ScatterSettings>();
    let rows = rows(state);
    if rows.is_empty() {
        let text =
            "Fit the combined model to some materials, or to the folder, to compare them here.";
        empty::empty_ui(ui, rect, text);
        return false;
    }
    let dots: Vec<ScatterDot> = rows.iter().map(|row| row.dot.clone()).collect();
    let plot = ScatterPlot::new(&dots, view.window, [rect.width(), rect.height()]);
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    paint::paint(ui.painter(), rect.min, &plot.drawing, &palette);
    let moved = match zoom::gesture(ui, &response, &plot.frame) {
        Some(Zoom::X(ends)) => with_window(view, ends),
        Some(Zoom::Reset) => ScatterSettings::default(),
        // α is never beyond its axis.
        Some(Zoom::Y(_)) | None => view,
    };
    if moved != view {
        out.push(Msg::set_view(moved));
    }
    let pointed = response.hover_pos().and_then(|at| {
        let at = at - rect.min;
        plot.dot_at([at.x, at.y])
    });
    if let Some(ScatterRow {
        dot, error, place, ..
    }) = pointed.and_then(|index| rows.get(index))
    {
        ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
        if response.clicked() {
            out.push(match place {
                MaterialPlace::Open(index) => Msg::Select(*index),
                MaterialPlace::File(path) => Msg::Library(LibraryMsg::Show {
                    path: path.clone(),
                    keep: false,
                }),
            });
        }
        response.on_hover_ui_at_pointer(|ui| {
            ui.strong(&dot.name);
            let text = format!(
                "α {:.2}  s {}  E {}",
                dot.alpha,
                number(dot.s),
                percent(*error)
            );
            ui.label(RichText::parse(&text).plain());
        });
    }
    false
}

/// The open materials, then the files of the folder that are not open.
fn rows(state: &State) -> Vec<ScatterRow> {
    let mut rows = Vec::new();
    let mut open = Vec::new();
    for (index, opened) in state.scene.opened.iter().enumerate() {
        let Some(material) = state.materials.get(&opened.id) else {
            continue;
        };
        let path = material.file();
        let color = path.as_ref().and_then(|path| color_of(state, path));
        open.extend(path);
        let Some((brdf, error)) = best_of(material) else {
            continue;
        };
        let series = Role::Series(index);
        rows.push(ScatterRow {
            brdf,
            dot: ScatterDot {
                name: material.name.clone(),
                s: brdf.params.lobe[0],
                alpha: brdf.params.lobe[1],
                fill: color.unwrap_or(series),
                ring: Some(series),
                shown: index == state.scene.selected,
            },
            error,
            place: MaterialPlace::Open(index),
        });
    }
    let files = state.library.folder.iter().flat_map(|folder| &folder.files);
    for file in files.filter(|file| !open.contains(&file.path)) {
        let fits = state.library.fits.get(&file.path);
        let combined =
            fits.and_then(|fits| best(fits.iter().map(|fit| (fit.brdf, fit.errors.total))));
        let Some((brdf, error)) = combined else {
            continue;
        };
        rows.push(ScatterRow {
            brdf,
            dot: ScatterDot {
                name: files::material_name(&file.path),
                s: brdf.params.lobe[0],
                alpha: brdf.params.lobe[1],
                fill: color_of(state, &file.path).unwrap_or(Role::Muted),
                ring: None,
                shown: false,
            },
            error,
            place: MaterialPlace::File(file.path.clone()),
        });
    }
    rows
}

fn best_of(material: &Material) -> Option<(Brdf, f64)> {
    best(
        material
            .fits
            .iter()
            .map(|fit| (fit.outcome.brdf, fit.outcome.errors.total)),
    )
}

/// Fit with an α and the smallest E.
fn best(fits: impl Iterator<Item = (Brdf, f64)>) -> Option<(Brdf, f64)> {
    fits.filter(|(brdf, _)| brdf.model == &COMBINED)
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The colour of the material in a file of the folder, where it has been read.
fn color_of(state: &State, path: &std::path::Path) -> Option<Role> {
    let mut files = state.library.folder.as_ref()?.files.iter();
    let file = files.find(|file| file.path == path)?;
    Some(Role::Fixed(file.examined()?.color))
}
