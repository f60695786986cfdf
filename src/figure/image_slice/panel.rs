//! The image slice on paper.

use super::ImageSpec;
use crate::figure::faults::Faults;
use crate::figure::heatmap::{Cell, HeatField as Cells, HeatMap};
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView, SharedAxis};
use crate::figure::scale::Axis;
use crate::figure::table::DataTable;
use crate::geom::degrees::rounded;
use std::f64::consts::PI;

impl PanelView for ImageSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.angle("phi_d", &mut self.phi_d, [0.0, PI]);
        faults.limits("limits", &mut self.limits);
        faults.inside("view", |faults| self.view.sanitize(faults));
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.65 * width + 4.0 * font
    }

    fn shared_axis(&self) -> Option<SharedAxis> {
        self.shown.is_amount().then_some(SharedAxis {
            scale: Some(self.scale),
            cosine: self.cosine,
            channel: self.channel,
        })
    }

    fn share_axis(&mut self, axis: Axis) {
        self.limits.get_or_insert([axis.floor, axis.limit]);
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let (measured, model) = (input.source(true), input.source(false));
        let (field, reference) = self.fields(measured, model);
        let heat = self.heat_spec(input.name, &field, &reference);
        PanelDrawing {
            table: table(self, &field),
            axis: heat.colors.amount_axis(),
            drawing: HeatMap::new(&heat, &field, input.size).drawing,
        }
    }
}

/// The cells of an image slice that are above the horizon; a value that was not measured is empty.
fn table(spec: &ImageSpec, cells: &Cells) -> DataTable {
    let mut table = DataTable::new(&[
        "quantity", "channel", "theta_h", "theta_d", "phi_d", "value",
    ]);
    let what = spec.shown.quantity(spec.cosine);
    for row in 0..cells.rows() {
        for column in 0..cells.columns() {
            let cell = cells.cell(column, row);
            if cell == Cell::Outside {
                continue;
            }
            let angles = spec.angles(column, row);
            table.rows.push(vec![
                what.into(),
                spec.channel.name().into(),
                rounded(angles.theta_h).into(),
                rounded(angles.theta_d).into(),
                rounded(angles.phi_d).into(),
                cell.value().into(),
            ]);
        }
    }
    table
}
