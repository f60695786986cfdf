//! The views as plain data: identity, name, help and place, each from its folder. [`crate::app::views`] has what draws them.

use crate::app::state::about::About;

pub use crate::app::state::view_id::ViewId;

impl ViewId {
    /// The row of this view.
    pub fn about(self) -> &'static About {
        // Every identity has a row: a test of the table of functions looks.
        let row = VIEWS.iter().find(|row| row.id == self);
        row.unwrap_or(&VIEWS[0])
    }
}

/// All views in the order of their tabs.
pub const VIEWS: &[About] = &[
    crate::app::views::sphere::about::ABOUT,
    crate::app::views::fits::about::ABOUT,
    crate::app::views::landscape::about::ABOUT,
    crate::app::views::scatter::about::ABOUT,
    crate::app::views::ranking::about::ABOUT,
    crate::app::views::lobes::about::ABOUT,
    crate::app::views::slices::about::ABOUT,
    crate::app::views::albedo::about::ABOUT,
    crate::app::views::lobe3d::about::ABOUT,
    crate::app::views::image::about::ABOUT,
    crate::app::views::disc::about::ABOUT,
    crate::app::views::error_map::about::ABOUT,
];
