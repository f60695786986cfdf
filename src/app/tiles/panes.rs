//! The kinds of tiles, as rows: name, help, and what draws them.

use super::{albedo, fits, lobes, slices, sphere};
use crate::app::state::State;
use crate::app::update::Msg;
use serde::{Deserialize, Serialize};

/// A kind of tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the rows below say what each one is")]
pub enum Pane {
    Sphere,
    Fits,
    Lobes,
    Slices,
    Albedo,
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
pub const PANES: [Row; 5] = [
    Row {
        pane: Pane::Sphere,
        key: "sphere",
        name: "Sphere",
        help: [
            "The material on a sphere, lit from far away: data, model, or both.",
            "Drag a highlight to move its light, or the line to compare; double click puts both back.",
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
        pane: Pane::Lobes,
        key: "lobes",
        name: "Polar lobes",
        help: [
            "f_r over the view angle in the plane of incidence: a curve per angle of incidence.",
            "Light comes from the left. Drag a handle on the rim to move it; double click puts all back.",
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
