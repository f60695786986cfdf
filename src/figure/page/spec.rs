//! Spec of a page: rows of panels, each a view of some subjects.

use super::style::Style;
use crate::figure::ViewSpec;
use crate::figure::faults::Faults;
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

/// Smallest and largest height of a row in millimetres.
const HEIGHTS: [f64; 2] = [5.0, 2000.0];

/// Most curves in a figure: each takes some ten thousand bytes while it is drawn.
const MOST_CURVES: usize = 10_000;

/// Brings a page of panels of so many subjects to the nearest that can be drawn. One without panels stays so.
pub fn sanitize(rows: &mut [RowSpec], style: &mut Style, subjects: usize, faults: &mut Faults) {
    if rows.iter().all(|row| row.panels.is_empty()) {
        let expected = "at least one: the figure has no panels";
        faults.inside("rows", |faults| faults.add("panels", 0, expected));
    }
    let panels = rows.iter().flat_map(|row| &row.panels);
    let curves = panels.map(|panel| panel.subjects.len() * panel.view.panel().curves());
    let curves: usize = curves.sum();
    if curves > MOST_CURVES {
        let expected = format!("at most {MOST_CURVES} in a figure: subjects × angles of incidence");
        faults.inside("rows", |faults| faults.add("curves", curves, expected));
    }
    faults.inside("rows", |faults| {
        for (position, row) in rows.iter_mut().enumerate() {
            faults.inside(position.to_string(), |faults| {
                row.sanitize(subjects, faults);
            });
        }
    });
    faults.inside("style", |faults| style.sanitize(faults));
}

impl RowSpec {
    fn sanitize(&mut self, subjects: usize, faults: &mut Faults) {
        if let Some(height) = &mut self.height_mm {
            faults.number("height_mm", height, HEIGHTS);
        }
        faults.inside("panels", |faults| {
            for (position, panel) in self.panels.iter_mut().enumerate() {
                faults.inside(position.to_string(), |faults| {
                    panel.sanitize(subjects, faults);
                });
            }
        });
    }
}

impl PanelSpec {
    fn sanitize(&mut self, subjects: usize, faults: &mut Faults) {
        faults.inside("subjects", |faults| {
            for (position, subject) in self.subjects.iter().enumerate() {
                if *subject >= subjects {
                    let expected = format!("one of the {subjects} subjects, counted from 0");
                    faults.add(&position.to_string(), subject, expected);
                }
            }
        });
        self.subjects.retain(|subject| *subject < subjects);
        faults.inside("view", |faults| {
            let key = self.view.key();
            faults.inside(key, |faults| {
                let view = self.view.panel_mut();
                view.sanitize(faults);
                view.check_subjects(self.subjects.len(), faults);
            });
        });
    }
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
