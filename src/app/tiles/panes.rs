//! The kinds of tiles, as rows: name, help, and what draws them.

use super::{albedo, error_map, fits, image, landscape, lobe3d, lobes, scatter, slices, sphere};
use crate::app::state::State;
use crate::app::update::Msg;
use serde::{Deserialize, Serialize};

/// A kind of tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the rows below say what each one is")]
pub enum Pane {
    Sphere,
    Fits,
    Landscape,
    Scatter,
    Lobes,
    Slices,
    Albedo,
    Lobe3d,
    Image,
    ErrorMap,
}

/// Which half of the default layout a tile is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// With the sphere.
    Upper,
    /// With the lobes.
    Lower,
}

/// What there is to know about a kind of tile.
pub struct Row {
    /// Which one.
    pub pane: Pane,
    /// Name in ids.
    pub key: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Three lines behind its "?".
    pub help: [&'static str; 3],
    /// Where it is at first.
    pub home: Home,
    /// Draws it. Says whether the pointer is on it, so that it decides about the probe.
    pub ui: fn(&mut egui::Ui, &State, &mut Vec<Msg>) -> bool,
}

/// All kinds of tiles in the order of their tabs.
pub const PANES: &[Row] = &[
    Row {
        pane: Pane::Sphere,
        key: "sphere",
        name: "Sphere",
        help: [
            "The material on a sphere, lit from far away: data, model, or both.",
            "Drag a highlight to move its light, or the line to compare; the wheel zooms. Double click puts all back.",
            "Point at it to read angles and values in the status bar; a click pins them.",
        ],
        home: Home::Upper,
        ui: sphere::sphere_ui,
    },
    Row {
        pane: Pane::Fits,
        key: "fits",
        name: "Fits",
        help: [
            "Every fit of this material, the best first; E is the share of misplaced reflection.",
            "A click on a row shows that model.",
            "A tick draws it beside the model in the plots.",
        ],
        home: Home::Upper,
        ui: |ui, state, out| {
            fits::fits_ui(ui, state, out);
            false
        },
    },
    Row {
        pane: Pane::Landscape,
        key: "landscape",
        name: "Error landscape",
        help: [
            "The least E that the combined model has at each s and α, with ρd and ks solved there; below is Phong, above Blinn-Phong.",
            "Line: the way of the last fit from its ring. Dot: the sliders. Diamond: the best. E is estimated on some of the cells.",
            "A click takes what is under the pointer. Drag moves, the wheel zooms, double click shows all.",
        ],
        home: Home::Upper,
        ui: landscape::landscape_ui,
    },
    Row {
        pane: Pane::Scatter,
        key: "scatter",
        name: "Materials",
        help: [
            "Every material with a fit of the combined model: α over s.",
            "At α = 0 a material is Phong-like, at α = 1 Blinn-Phong-like. Open ones have a ring.",
            "Point to read a name and its numbers; a click shows that material. The wheel zooms, double click shows all.",
        ],
        home: Home::Upper,
        ui: scatter::scatter_ui,
    },
    Row {
        pane: Pane::Lobes,
        key: "lobes",
        name: "Polar lobes",
        help: [
            "f_r over the view angle in the plane of incidence: a curve per angle of incidence.",
            "Light comes from the left. Drag a handle on the rim to move it, the wheel zooms; double click puts all back.",
            "Point to read values, click to pin. A click on a name hides it, a double click shows it alone.",
        ],
        home: Home::Lower,
        ui: lobes::lobes_ui,
    },
    Row {
        pane: Pane::Slices,
        key: "slices",
        name: "Slices",
        help: [
            "f_r over one angle with the others fixed, and what is between model and measurement below.",
            "The wheel zooms the angle, over the numbers at the left or with Ctrl the values; drag to pan, double click resets.",
            "Point to read values, click to pin. \"Follow\" takes the fixed angles from the other views.",
        ],
        home: Home::Lower,
        ui: slices::slices_ui,
    },
    Row {
        pane: Pane::Albedo,
        key: "albedo",
        name: "Albedo",
        help: [
            "The share of the light from one angle that comes back, over all view directions; more than 1 is marked.",
            "Of a measurement it is the sum over what was measured; the dotted line says which share that is.",
            "Point to read values, click to pin. The wheel zooms, double click resets.",
        ],
        home: Home::Lower,
        ui: albedo::albedo_ui,
    },
    Row {
        pane: Pane::Lobe3d,
        key: "lobe3d",
        name: "3D lobe",
        help: [
            "f_r over all view directions for one angle of incidence: data as a solid, models as wire.",
            "Drag to turn it, wheel to zoom, double click puts the view back.",
            "The light is that of the probe. Point at the lobe to read values, click to pin.",
        ],
        home: Home::Lower,
        ui: lobe3d::lobe3d_ui,
    },
    Row {
        pane: Pane::Image,
        key: "image",
        name: "Image slice",
        help: [
            "f_r over half and difference angle at one φd, cell by cell: data, model, residual or ratio.",
            "Hatched was not measured, blank is below the horizon; past the dashed line light or view is beyond 80°.",
            "Point to read values, click to pin. Drag moves, the wheel zooms, double click shows all.",
        ],
        home: Home::Lower,
        ui: image::image_ui,
    },
    Row {
        pane: Pane::ErrorMap,
        key: "error-map",
        name: "Error map",
        help: [
            "Where the E of the model comes from: its share in each direction, with the weight and limit of the fit.",
            "The shares add up to all of E. Swapped light and view are the same, so each counts half.",
            "Point to read shares, click to pin. Drag moves, the wheel zooms, double click shows all.",
        ],
        home: Home::Lower,
        ui: error_map::error_map_ui,
    },
];

impl Pane {
    /// Its row.
    pub fn row(self) -> &'static Row {
        PANES
            .iter()
            .find(|row| row.pane == self)
            .unwrap_or(&PANES[0])
    }
}
