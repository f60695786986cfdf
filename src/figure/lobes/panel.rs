//! The lobe plot on paper.

use super::{LobePlot, LobeSpec};
use crate::figure::faults::Faults;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView, SharedAxis};
use crate::figure::scale::Axis;
use crate::figure::subject::Subject;
use crate::figure::table::{DataTable, curve_head};
use crate::geom::degrees::rounded;

impl PanelView for LobeSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.angles("theta_i", &mut self.theta_i);
        faults.limits("limits", &mut self.limits);
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        // Half a disc, its title, and the values below it.
        0.5 * width + 4.0 * font
    }

    fn curves(&self) -> usize {
        self.theta_i.len()
    }

    fn has_curves(&self) -> bool {
        true
    }

    fn shared_axis(&self) -> Option<SharedAxis> {
        Some(SharedAxis {
            scale: self.scale.law(),
            cosine: self.cosine,
            channel: self.channel,
        })
    }

    fn share_axis(&mut self, axis: Axis) {
        self.limits.get_or_insert([axis.floor, axis.limit]);
        self.scale = axis.scale.into();
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let spec = LobeSpec {
            still: true,
            ..self.clone()
        };
        let plot = LobePlot::new(&spec, input.subjects, input.size);
        PanelDrawing {
            table: if input.numbers {
                table(&plot, &spec, input.named)
            } else {
                DataTable::default()
            },
            axis: Some(plot.frame.axis),
            drawing: plot.drawing,
        }
    }
}

/// The curves of a lobe plot.
fn table(plot: &LobePlot, spec: &LobeSpec, subjects: &[Subject]) -> DataTable {
    let mut table = DataTable::new(&[
        "quantity", "channel", "curve", "kind", "theta_i", "theta_o", "value",
    ]);
    for trace in &plot.traces {
        let head = curve_head(spec.cosine, spec.channel, &subjects[trace.subject]);
        for sample in &trace.samples {
            let mut row = head.to_vec();
            row.push(rounded(spec.theta_i[trace.lobe]).into());
            row.push(rounded(sample.x).into());
            row.push(sample.value.into());
            table.rows.push(row);
        }
    }
    table
}
