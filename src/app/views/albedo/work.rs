//! Computation of the view in the background.

use crate::app::state::cache::{Caches, Query, Update, WhenNewer};
use crate::figure::albedo::{AlbedoCurve, AlbedoPoint, angles, curve};
use crate::figure::subject::{Source, Subject};
use std::ops::ControlFlow;
use std::sync::Arc;

/// The albedos of some sources, in their order.
pub type Curves = Vec<Vec<AlbedoPoint>>;

/// The albedos of measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredAlbedo(pub Vec<Source>);

/// The albedos of models.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelAlbedo(pub Vec<Source>);

impl Query for MeasuredAlbedo {
    type Output = Curves;
    const DOING: &'static str = "summing up the albedo of the data";
    const WHEN_NEWER: WhenNewer = WhenNewer::Cancel;

    fn run(&self, report: &mut dyn FnMut(Update<Curves>) -> ControlFlow<()>) -> Option<Curves> {
        compute(&self.0, report)
    }
}

impl Query for ModelAlbedo {
    type Output = Curves;
    const DOING: &'static str = "summing up the albedo of the models";
    const WHEN_NEWER: WhenNewer = WhenNewer::FinishFirst;

    fn run(&self, report: &mut dyn FnMut(Update<Curves>) -> ControlFlow<()>) -> Option<Curves> {
        compute(&self.0, report)
    }
}

/// Says how far it is a few times a curve: every word wakes the window.
fn compute(
    sources: &[Source],
    report: &mut dyn FnMut(Update<Curves>) -> ControlFlow<()>,
) -> Option<Curves> {
    const WORDS: usize = 6;
    let total = (sources.len() * angles().len()).max(1);
    let mut done = 0;
    let mut curves = Vec::new();
    for source in sources {
        curves.push(curve(source, || {
            done += 1;
            if done % WORDS == 0 {
                report(Update::Progress(done as f32 / total as f32))
            } else {
                ControlFlow::Continue(())
            }
        })?);
    }
    Some(curves)
}

/// Queries for the albedos of these subjects: measurements and models.
pub fn queries(subjects: &[Subject]) -> (MeasuredAlbedo, ModelAlbedo) {
    let of = |measured: bool| {
        let sources = subjects.iter().map(|subject| subject.source.clone());
        sources
            .filter(|source| matches!(source, Source::Measured(..)) == measured)
            .collect()
    };
    (MeasuredAlbedo(of(true)), ModelAlbedo(of(false)))
}

/// The curve of each subject: of its own source; else an old one, of the same table or of the model that was at its
/// place; else none.
pub fn curves<'a>(caches: &'a Caches, subjects: &[Subject]) -> Vec<AlbedoCurve<'a>> {
    let measured = caches.last::<MeasuredAlbedo>();
    let measured = measured.map(|(query, made)| (&query.0[..], &made[..]));
    let models = caches.last::<ModelAlbedo>();
    let models = models.map(|(query, made)| (&query.0[..], &made[..]));
    let mut models_seen = 0;
    let mut curves = Vec::new();
    for Subject { source, .. } in subjects {
        let (known, old) = match source {
            Source::Measured(table, _) => {
                let same_table = |other: &Source| matches!(other, Source::Measured(other, _) if Arc::ptr_eq(other, table));
                let old = measured.and_then(|(sources, _)| sources.iter().position(same_table));
                (measured, old)
            }
            Source::Model(_) | Source::Function(_) => {
                models_seen += 1;
                (models, Some(models_seen - 1))
            }
        };
        curves.push(known.map_or_else(AlbedoCurve::default, |(sources, made)| {
            let own = sources.iter().position(|other| other == source);
            let points = own.or(old).and_then(|place| made.get(place));
            AlbedoCurve {
                points: points.map_or(&[], |points| points),
                old: own.is_none(),
            }
        }));
    }
    curves
}
