//! The disc on paper.

use super::{DiscField, DiscPlot, DiscSpec};
use crate::figure::faults::Faults;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView, SharedAxis};
use crate::figure::scale::Axis;
use crate::figure::subject::Source;
use crate::figure::table::DataTable;
use crate::geom::direction;
use crate::geom::directions::wrap;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Most cells on a side of the picture.
const MOST: usize = 1024;
/// Degrees between rows of the table in θo, and in φo.
const TABLE_DEG: [usize; 2] = [1, 3];

impl PanelView for DiscSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.angle("theta_i", &mut self.theta_i, [0.0, FRAC_PI_2]);
        // Every azimuth is one of a turn.
        self.phi_i = wrap(self.phi_i, TAU);
        faults.limits("limits", &mut self.limits);
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.8 * width + 3.0 * font
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
        // The disc is as large as the panel lets it, whatever stands in it.
        let blank = self.field(None, None, 1);
        let frame = DiscPlot::new(self, input.name, &blank, input.size).frame;
        let side = DiscField::side(2.0 * frame.radius * input.density, MOST);
        let field = self.field(measured, model, side);
        let plot = DiscPlot::new(self, input.name, &field, input.size);
        let marks = plot.marks(self);
        let mut drawing = plot.drawing;
        drawing.items.extend(marks.items);
        PanelDrawing {
            drawing,
            table: table(self, measured, model),
            axis: field.colors(self).amount_axis(),
        }
    }
}

/// The values at every degree of θo and every third one of φo; where there is none, `value` is empty.
fn table(spec: &DiscSpec, measured: Option<&Source>, model: Option<&Source>) -> DataTable {
    let mut table = DataTable::new(&[
        "quantity", "channel", "theta_i", "phi_i", "theta_o", "phi_o", "value",
    ]);
    let light = [spec.theta_i, spec.phi_i].map(crate::geom::degrees::rounded);
    for theta_o in (0..=90).step_by(TABLE_DEG[0]) {
        // At the pole every φo is the same direction.
        let around = if theta_o == 0 { 1 } else { 360 };
        for phi_o in (0..around).step_by(TABLE_DEG[1]) {
            let [theta, phi] = [theta_o, phi_o].map(|degrees| (degrees as f64).to_radians());
            let wo = direction(theta, phi);
            let wo = wo.with_z(wo.z.max(0.0));
            table.rows.push(vec![
                spec.shown.quantity(spec.cosine).into(),
                spec.channel.name().into(),
                light[0].into(),
                light[1].into(),
                (theta_o as f64).into(),
                (phi_o as f64).into(),
                spec.value(measured, model, wo).into(),
            ]);
        }
    }
    table
}
