//! Spec of a page: rows of panels, each a view of some subjects.

use super::style::Style;
use crate::figure::ViewSpec;
use serde::{Deserialize, Serialize};

/// A page of panels.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PageSpec {
    /// Rows from above to below.
    pub rows: Vec<RowSpec>,
    /// Look of the page on paper.
    #[serde(default)]
    pub style: Style,
}

/// Panels beside each other, all of the same width.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RowSpec {
    /// Written at the left, upwards.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Height of the panels in millimetres; from their kinds without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height_mm: Option<f64>,
    /// Panels from left to right.
    pub panels: Vec<PanelSpec>,
}

/// One view of some subjects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PanelSpec {
    /// Written above it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heading: Option<String>,
    /// Positions in the figure's list of subjects, in the order in which they are drawn and named. A sphere, an image
    /// slice and an error map take the first measurement and the first model; a landscape takes the measurement.
    pub subjects: Vec<usize>,
    /// View that the panel shows, with its settings.
    pub view: ViewSpec,
}
