//! The albedo plot on paper.

use super::{AlbedoCurve, AlbedoPlot, AlbedoPoint, AlbedoSpec, curve};
use crate::figure::cosine::CosineFactor;
use crate::figure::faults::Faults;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView, SharedAxis};
use crate::figure::scale::{Axis, RadialScale};
use crate::figure::subject::{Channel, Source, Subject};
use crate::figure::table::{DataTable, kind};
use crate::geom::degrees::rounded;
use std::cell::RefCell;
use std::f64::consts::FRAC_PI_2;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Albedo curves by their source: a page asks for each once, however many panels show it.
#[derive(Debug, Default)]
pub struct KnownAlbedos(RefCell<Vec<(Source, Arc<[AlbedoPoint]>)>>);

impl KnownAlbedos {
    /// The curve of a source. Takes seconds of a table that is new.
    pub fn of(&self, source: &Source) -> Arc<[AlbedoPoint]> {
        let mut known = self.0.borrow_mut();
        if let Some((_, points)) = known.iter().find(|(other, _)| other == source) {
            return Arc::clone(points);
        }
        let points = curve(source, || ControlFlow::Continue(())).unwrap_or_default();
        let points: Arc<[AlbedoPoint]> = points.into();
        known.push((source.clone(), Arc::clone(&points)));
        points
    }
}

impl PanelView for AlbedoSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.window("window", &mut self.window, [0.0, FRAC_PI_2]);
        faults.limits("limits", &mut self.limits);
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.6 * width + 3.0 * font
    }

    fn has_curves(&self) -> bool {
        true
    }

    fn shared_axis(&self) -> Option<SharedAxis> {
        Some(SharedAxis {
            scale: Some(RadialScale::Linear),
            cosine: CosineFactor::NONE,
            channel: self.channel,
        })
    }

    fn share_axis(&mut self, axis: Axis) {
        self.limits.get_or_insert([axis.floor, axis.limit]);
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let curves: Vec<Arc<[AlbedoPoint]>> = input
            .subjects
            .iter()
            .map(|subject| input.albedos.of(&subject.source))
            .collect();
        let seen: Vec<AlbedoCurve> = curves
            .iter()
            .map(|points| AlbedoCurve { points, old: false })
            .collect();
        let plot = AlbedoPlot::new(self, input.subjects, &seen, input.size);
        PanelDrawing {
            table: table(self.channel, input.named, &curves),
            axis: Some(plot.frame.y),
            drawing: plot.drawing,
        }
    }
}

/// Albedos of subjects, in the same order.
fn table(channel: Channel, subjects: &[Subject], curves: &[Arc<[AlbedoPoint]>]) -> DataTable {
    let mut table = DataTable::new(&[
        "quantity",
        "channel",
        "curve",
        "kind",
        "theta_i",
        "value",
        "measured_share",
    ]);
    for (subject, curve) in subjects.iter().zip(curves) {
        for point in curve.iter() {
            table.rows.push(vec![
                "albedo".into(),
                channel.name().into(),
                subject.label.as_str().into(),
                kind(subject).into(),
                rounded(point.theta_i).into(),
                channel.of(point.rgb).into(),
                point.measured.into(),
            ]);
        }
    }
    table
}
