//! The kinds of tiles, as rows: name, help, and what draws them.

use super::{fits, lobes, scatter, sphere};
use crate::app::state::State;
use crate::app::update::Msg;
use serde::{Deserialize, Serialize};

/// A kind of tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the rows below say what each one is")]
pub enum Pane {
    Sphere,
    Fits,
    Scatter,
    Lobes,
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
pub const PANES: [Row; 4] = [
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
        pane: Pane::Scatter,
        key: "scatter",
        name: "Materials",
        help: [
            "Every material with a fit of the combined model: α over s.",
            "At α = 0 a material is Phong-like, at α = 1 Blinn-Phong-like. Open ones have a coloured rim.",
            "Point to read a name and its numbers; a click shows that material.",
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
            "Light comes from the left. Drag a handle on the rim to move it; double click puts all back.",
            "Point to read values, click to pin. A click on a name hides it, a double click shows it alone.",
        ],
        home: Home::Lower,
        ui: lobes::lobes_ui,
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
