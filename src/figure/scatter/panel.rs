//! The materials on paper.

use super::plot::{ScatterDot, ScatterPlot};
use super::quantity::Quantity;
use super::spec::ScatterSpec;
use crate::figure::faults::{Faults, list};
use crate::figure::palette::Role;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::subject::Source;
use crate::figure::table::DataTable;

/// Values of E: those of a fit, and of models that are far off.
const ERRORS: [f64; 2] = [0.0, 1e12];

impl PanelView for ScatterSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        let model = self.model;
        for (key, quantity) in [("x", &mut self.x), ("y", &mut self.y)] {
            if let Some(unknown) = quantity.filter(|quantity| quantity.row(model).is_none()) {
                let keys: Vec<&str> = Quantity::all(model).iter().map(|one| one.key()).collect();
                let expected = format!("one of {}, which {} has", keys.join(", "), model.key);
                faults.add(key, format_args!("{:?}", unknown.key()), expected);
                *quantity = None;
            }
        }
        let [x, y] = self.rows();
        for (key, window, row) in [
            ("window", &mut self.window, x),
            ("y_window", &mut self.y_window, y),
        ] {
            if let Some(ends) = window.filter(|ends| !row.are_ends(*ends)) {
                faults.add(key, list(&ends), row.expected_ends());
                *window = None;
            }
        }
        faults.inside("errors", |faults| {
            for (position, error) in self.errors.iter_mut().enumerate() {
                faults.number(&position.to_string(), error, ERRORS);
            }
        });
    }

    fn check_subjects(&self, count: usize, faults: &mut Faults) {
        if self.shows_error() && self.errors.len() != count {
            let expected = format!("{count}, the E of each subject of the panel as a share");
            faults.inside("errors", |faults| {
                faults.add("length", self.errors.len(), expected);
            });
        }
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.6 * width + 3.0 * font
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let subjects = input.subjects.iter().enumerate();
        let dots: Vec<ScatterDot> = subjects
            .filter_map(|(position, subject)| {
                let Source::Model(brdf) = &subject.source else {
                    return None;
                };
                let [x, y] = self.values(brdf, self.errors.get(position).copied())?;
                Some(ScatterDot {
                    name: subject.label.clone(),
                    x,
                    y,
                    fill: Role::Series(subject.series),
                    ring: None,
                    shown: false,
                })
            })
            .collect();
        PanelDrawing {
            table: self.table(&dots),
            axis: None,
            drawing: ScatterPlot::new(&dots, self, input.size).drawing,
        }
    }
}

impl ScatterSpec {
    /// Materials by the two quantities.
    fn table(&self, dots: &[ScatterDot]) -> DataTable {
        let [x, y] = self.rows();
        let mut table = DataTable::new(&["material", x.column, y.column]);
        for dot in dots {
            let name = dot.name.as_str().into();
            table.rows.push(vec![name, dot.x.into(), dot.y.into()]);
        }
        table
    }
}
