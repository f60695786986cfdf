//! The views: a folder each, with its row, its settings, its ui, what it shows in a figure and what it computes in the
//! background; and the table of their functions.

pub mod albedo;
pub mod disc;
pub mod error_map;
pub mod fits;
pub mod image;
pub mod landscape;
pub mod lobe3d;
pub mod lobes;
pub mod on_paper;
pub mod ranking;
pub mod scatter;
pub mod slices;
pub mod sphere;

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::view_id::ViewId;
use crate::app::views::on_paper::PaperView;

/// Functions of a view.
pub struct ViewRow {
    /// The view.
    pub id: ViewId,
    /// Draws the tile. Returns whether the pointer is on it, so that it decides about the probe.
    pub ui: fn(&mut egui::Ui, &State, &mut Vec<Msg>) -> bool,
    /// The view in a figure; `None` where it cannot be in one.
    pub paper: Option<PaperView>,
}

/// All views in the order of their tabs.
pub const ROWS: &[ViewRow] = &[
    ViewRow {
        id: ViewId::Sphere,
        ui: sphere::sphere_ui,
        paper: Some(sphere::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Fits,
        ui: fits::fits_ui,
        paper: None,
    },
    ViewRow {
        id: ViewId::Landscape,
        ui: landscape::landscape_ui,
        paper: Some(landscape::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Scatter,
        ui: scatter::scatter_ui,
        paper: Some(scatter::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Ranking,
        ui: ranking::ranking_ui,
        paper: Some(ranking::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Lobes,
        ui: lobes::lobes_ui,
        paper: Some(lobes::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Slices,
        ui: slices::slices_ui,
        paper: Some(slices::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Albedo,
        ui: albedo::albedo_ui,
        paper: Some(albedo::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Lobe3d,
        ui: lobe3d::lobe3d_ui,
        paper: Some(lobe3d::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Image,
        ui: image::image_ui,
        paper: Some(image::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::Disc,
        ui: disc::disc_ui,
        paper: Some(disc::paper::ON_PAPER),
    },
    ViewRow {
        id: ViewId::ErrorMap,
        ui: error_map::error_map_ui,
        paper: Some(error_map::paper::ON_PAPER),
    },
];

impl ViewRow {
    /// The row of a view.
    pub fn of(id: ViewId) -> Option<&'static Self> {
        ROWS.iter().find(|row| row.id == id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::about::OnPaper;
    use crate::app::state::views::VIEWS;

    #[test]
    fn both_tables_have_the_same_views() {
        let ids: Vec<ViewId> = VIEWS.iter().map(|about| about.id).collect();
        assert_eq!(ids, ROWS.iter().map(|row| row.id).collect::<Vec<_>>());
        for (about, row) in VIEWS.iter().zip(ROWS) {
            assert_eq!(row.paper.is_none(), about.on_paper == OnPaper::Never);
        }
    }
}
