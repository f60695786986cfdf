//! Slices on paper.

use super::{Over, Residual, SlicePlot, SliceSpec};
use crate::figure::faults::Faults;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView, SharedAxis};
use crate::figure::scale::Axis;
use crate::figure::subject::Subject;
use crate::figure::table::{DataTable, TableField, curve_head};
use crate::geom::degrees::rounded;
use std::f64::consts::{FRAC_PI_2, TAU};

impl PanelView for SliceSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.angles("theta_i", &mut self.theta_i);
        faults.angle("theta_h", &mut self.theta_h, [0.0, FRAC_PI_2]);
        faults.angle("theta_d", &mut self.theta_d, [0.0, FRAC_PI_2]);
        faults.angle("phi_d", &mut self.phi_d, [0.0, TAU]);
        faults.window("window", &mut self.window, self.over.range());
        faults.limits("limits", &mut self.limits);
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        match self.residual {
            Residual::None => 0.6 * width + 3.0 * font,
            _ => 0.8 * width + 4.0 * font,
        }
    }

    fn curves(&self) -> usize {
        self.slices()
    }

    fn has_curves(&self) -> bool {
        true
    }

    fn shared_axis(&self) -> Option<SharedAxis> {
        Some(SharedAxis {
            scale: Some(self.scale),
            cosine: self.cosine,
            channel: self.channel,
        })
    }

    fn share_axis(&mut self, axis: Axis) {
        self.limits.get_or_insert([axis.floor, axis.limit]);
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let plot = SlicePlot::new(self, input.subjects, input.size);
        PanelDrawing {
            table: if input.numbers {
                table(&plot, self, input.named)
            } else {
                DataTable::default()
            },
            axis: Some(plot.frame.y),
            drawing: plot.drawing,
        }
    }
}

/// The curves of a plot of slices, and the residuals below them.
fn table(plot: &SlicePlot, spec: &SliceSpec, subjects: &[Subject]) -> DataTable {
    let mut table = DataTable::new(&[
        "quantity", "channel", "curve", "kind", "theta_i", "theta_o", "theta_h", "theta_d",
        "phi_d", "value",
    ]);
    let angles = |slice: usize, x: f64| -> [TableField; 5] {
        let (x, fixed) = (TableField::from(rounded(x)), |angle: f64| {
            TableField::from(rounded(angle))
        });
        match spec.over {
            Over::ThetaO => {
                let theta_i = fixed(spec.theta_i[slice]);
                [
                    theta_i,
                    x,
                    TableField::Empty,
                    TableField::Empty,
                    TableField::Empty,
                ]
            }
            Over::ThetaH => [
                TableField::Empty,
                TableField::Empty,
                x,
                fixed(spec.theta_d),
                fixed(spec.phi_d),
            ],
            Over::ThetaD => [
                TableField::Empty,
                TableField::Empty,
                fixed(spec.theta_h),
                x,
                fixed(spec.phi_d),
            ],
            Over::PhiD => [
                TableField::Empty,
                TableField::Empty,
                fixed(spec.theta_h),
                fixed(spec.theta_d),
                x,
            ],
        }
    };
    for trace in &plot.traces {
        let head = curve_head(spec.cosine, spec.channel, &subjects[trace.subject]);
        for sample in &trace.samples {
            let mut row = head.to_vec();
            row.extend(angles(trace.slice, sample.x));
            row.push(sample.value.into());
            table.rows.push(row);
        }
    }
    for trace in &plot.residuals {
        let mut head = curve_head(spec.cosine, spec.channel, &subjects[trace.model]);
        head[0] = match spec.residual {
            Residual::Ratio => "model / measured".into(),
            Residual::None | Residual::Difference => "model − measured".into(),
        };
        for sample in &trace.samples {
            let mut row = head.to_vec();
            row.extend(angles(trace.slice, sample.x));
            row.push(sample.value.into());
            table.rows.push(row);
        }
    }
    table
}
