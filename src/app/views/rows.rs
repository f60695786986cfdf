//! The table of the views: what draws each.

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::views::ViewId;
use crate::app::views::{
    albedo, error_map, fits, image, landscape, lobe3d, lobes, scatter, slices, sphere,
};

/// What draws a view.
pub struct Row {
    /// Which one.
    pub id: ViewId,
    /// Draws it. Returns whether the pointer is on it, so that it decides about the probe.
    pub ui: fn(&mut egui::Ui, &State, &mut Vec<Msg>) -> bool,
}

/// All views in the order of their tabs.
pub const ROWS: &[Row] = &[
    Row {
        id: ViewId::Sphere,
        ui: sphere::sphere_ui,
    },
    Row {
        id: ViewId::Fits,
        ui: |ui, state, out| {
            fits::fits_ui(ui, state, out);
            false
        },
    },
    Row {
        id: ViewId::Landscape,
        ui: landscape::landscape_ui,
    },
    Row {
        id: ViewId::Scatter,
        ui: scatter::scatter_ui,
    },
    Row {
        id: ViewId::Lobes,
        ui: lobes::lobes_ui,
    },
    Row {
        id: ViewId::Slices,
        ui: slices::slices_ui,
    },
    Row {
        id: ViewId::Albedo,
        ui: albedo::albedo_ui,
    },
    Row {
        id: ViewId::Lobe3d,
        ui: lobe3d::lobe3d_ui,
    },
    Row {
        id: ViewId::Image,
        ui: image::image_ui,
    },
    Row {
        id: ViewId::ErrorMap,
        ui: error_map::error_map_ui,
    },
];

impl Row {
    /// The row of a view.
    pub fn of(id: ViewId) -> Option<&'static Self> {
        ROWS.iter().find(|row| row.id == id)
    }
}
