//! The materials on paper.

use super::{ScatterDot, ScatterPlot};
use crate::figure::faults::{Faults, list};
use crate::figure::palette::Role;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::subject::Source;
use crate::figure::table::DataTable;
use serde::{Deserialize, Serialize};

/// Ends that are farther out or nearer to each other show nothing more.
const ENDS: [f64; 2] = [1e-4, 1e8];
const CLOSEST: f64 = 1.05;

/// The plot of materials on paper: the models by s and α of the combined model, in the colours of their series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ScatterSpec {
    /// Ends of the axis of s; around all dots without.
    pub window: Option<[f64; 2]>,
}

impl ScatterSpec {
    /// Whether the axis of s can have these ends.
    pub fn are_ends([low, high]: [f64; 2]) -> bool {
        low >= ENDS[0] && high <= ENDS[1] && high >= CLOSEST * low
    }
}

impl PanelView for ScatterSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        if let Some(ends) = self.window.filter(|ends| !Self::are_ends(*ends)) {
            let [low, high] = ENDS;
            let expected = format!(
                "two values from {low:?} to {high:?}, the second at least {CLOSEST} times the first, or null"
            );
            faults.add("window", list(&ends), expected);
            self.window = None;
        }
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.6 * width + 3.0 * font
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let dots: Vec<ScatterDot> = input
            .subjects
            .iter()
            .filter_map(|subject| {
                let Source::Model(brdf) = &subject.source else {
                    return None;
                };
                Some(ScatterDot {
                    name: subject.label.clone(),
                    s: brdf.params.lobe[0],
                    alpha: brdf.params.lobe[1],
                    fill: Role::Series(subject.series),
                    ring: None,
                    shown: false,
                })
            })
            .collect();
        PanelDrawing {
            table: table(&dots),
            axis: None,
            drawing: ScatterPlot::new(&dots, self.window, input.size).drawing,
        }
    }
}

/// Materials by s and α.
fn table(dots: &[ScatterDot]) -> DataTable {
    let mut table = DataTable::new(&["material", "s", "alpha"]);
    for dot in dots {
        let name = dot.name.as_str().into();
        table.rows.push(vec![name, dot.s.into(), dot.alpha.into()]);
    }
    table
}
