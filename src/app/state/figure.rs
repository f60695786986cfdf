//! Settings of figures, and the views that go into one.

use crate::app::state::views::ViewId;
use crate::export::FigureFormat;
use crate::figure::page::Style;
use serde::{Deserialize, Serialize};

/// Looks and format of figures, kept between runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FigurePrefs {
    /// Look on paper.
    pub style: Style,
    /// File format.
    pub format: FigureFormat,
    /// Panels beside each other.
    pub columns: usize,
}

impl FigurePrefs {
    /// Numbers of panels beside each other that can be set.
    pub const COLUMNS: std::ops::RangeInclusive<usize> = 1..=6;
}

impl Default for FigurePrefs {
    fn default() -> Self {
        Self {
            style: Style::default(),
            format: FigureFormat::default(),
            columns: 2,
        }
    }
}

/// Views under the pointer, and those that go into a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureViews {
    /// Under the pointer.
    pub pointed: Option<ViewId>,
    /// The last one that was.
    pub last: Option<ViewId>,
    /// Views in the figure that is being made, in its order.
    pub chosen: Vec<ViewId>,
}
