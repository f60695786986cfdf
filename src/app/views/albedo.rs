//! What the albedo plot is set to show, and the jobs that compute its curves.
//!
//! Measurements and models are apart: a slider changes the model in milliseconds, a table takes seconds.

use crate::app::derived::{Derived, Slot, Step, Wish};
use crate::figure::albedo::{AlbedoCurve, AlbedoPoint, AlbedoSpec, angles, curve};
use crate::figure::subject::{Source, Subject};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::sync::Arc;

/// What the albedo plot shows.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct AlbedoView {
    /// Its `probe` is left out: it is filled in while drawing.
    pub spec: AlbedoSpec,
}

/// The albedos of some sources, in their order.
pub type Curves = Vec<Vec<AlbedoPoint>>;

/// The albedos of measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredAlbedo(pub Vec<Source>);

/// The albedos of models.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelAlbedo(pub Vec<Source>);

impl Wish for MeasuredAlbedo {
    type Made = Curves;
    const ENDS_FIRST: bool = false;

    fn slot(derived: &mut Derived) -> &mut Slot<Self> {
        &mut derived.measured_albedo
    }

    fn make(&self, follow: &mut dyn FnMut(Step<Curves>) -> ControlFlow<()>) -> Option<Curves> {
        make(&self.0, follow)
    }
}

impl Wish for ModelAlbedo {
    type Made = Curves;
    const ENDS_FIRST: bool = true;

    fn slot(derived: &mut Derived) -> &mut Slot<Self> {
        &mut derived.model_albedo
    }

    fn make(&self, follow: &mut dyn FnMut(Step<Curves>) -> ControlFlow<()>) -> Option<Curves> {
        make(&self.0, follow)
    }
}

/// Says how far it is a few times a curve: every word wakes the window.
fn make(
    sources: &[Source],
    follow: &mut dyn FnMut(Step<Curves>) -> ControlFlow<()>,
) -> Option<Curves> {
    const WORDS: usize = 6;
    let total = (sources.len() * angles().len()).max(1);
    let mut done = 0;
    let mut curves = Vec::new();
    for source in sources {
        curves.push(curve(source, || {
            done += 1;
            if done % WORDS == 0 {
                follow(Step::Progress(done as f32 / total as f32))
            } else {
                ControlFlow::Continue(())
            }
        })?);
    }
    Some(curves)
}

/// What is wished for of these subjects: measurements and models.
pub fn wishes(subjects: &[Subject]) -> (MeasuredAlbedo, ModelAlbedo) {
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
pub fn curves<'a>(derived: &'a Derived, subjects: &[Subject]) -> Vec<AlbedoCurve<'a>> {
    let measured = derived.measured_albedo.last();
    let measured = measured.map(|(wish, made)| (&wish.0[..], &made[..]));
    let models = derived.model_albedo.last();
    let models = models.map(|(wish, made)| (&wish.0[..], &made[..]));
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
