//! The numbers of a plot of slices: every curve sampled within the window, and the residuals between them.

use super::spec::{Over, Residual, SliceSpec};
use crate::figure::samples::{Sample, around_peak};
use crate::figure::subject::{Look, Subject};

/// One slice of one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceTrace {
    /// Position of the subject in the list that was plotted.
    pub subject: usize,
    /// Position of θi in the spec; 0 where only one slice is.
    pub slice: usize,
    /// Samples by ascending angle in radians; values in 1/sr.
    pub samples: Vec<Sample>,
}

/// Residual between a model and its measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct ResidualTrace {
    /// Position of the measurement in the list that was plotted.
    pub measured: usize,
    /// Position of the model.
    pub model: usize,
    /// Position of θi in the spec; 0 where only one slice is.
    pub slice: usize,
    /// Samples by ascending angle in radians; values in 1/sr, or a ratio.
    pub samples: Vec<Sample>,
}

/// Most samples that are spread evenly; more are closer than a point of any screen.
const MOST: usize = 4000;

/// The curves that are shown: a sample per point of `width`, more where a highlight may be.
pub(super) fn trace_all(spec: &SliceSpec, subjects: &[Subject], width: f32) -> Vec<SliceTrace> {
    let mut traces = Vec::new();
    for slice in 0..spec.slices() {
        let angles = angles(spec, slice, width);
        for (index, subject) in subjects.iter().enumerate() {
            if !subject.hidden {
                let samples = angles.iter().map(|x| Sample {
                    x: *x,
                    value: spec.value(subject, slice, *x),
                });
                traces.push(SliceTrace {
                    subject: index,
                    slice,
                    samples: samples.collect(),
                });
            }
        }
    }
    traces
}

fn angles(spec: &SliceSpec, slice: usize, width: f32) -> Vec<f64> {
    let [low, high] = spec.seen();
    let steps = (width.ceil() as usize).clamp(2, MOST);
    let mut angles: Vec<f64> = (0..=steps)
        .map(|k| low + (high - low) * k as f64 / steps as f64)
        .collect();
    let peak = match spec.over {
        Over::ThetaO => spec.theta_i.get(slice).copied(),
        Over::ThetaH => Some(0.0),
        Over::ThetaD | Over::PhiD => None,
    };
    if let Some(peak) = peak {
        angles.extend(around_peak(peak).filter(|x| (low..=high).contains(x)));
    }
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    angles
}

/// Models against the measurements they are over; one in a colour of its own against that of the first subject.
pub(super) fn residuals(
    spec: &SliceSpec,
    subjects: &[Subject],
    traces: &[SliceTrace],
) -> Vec<ResidualTrace> {
    if spec.residual == Residual::None {
        return Vec::new();
    }
    let mut residuals = Vec::new();
    for model in traces {
        let Some(measured) = measured_of(subjects, model.subject) else {
            continue;
        };
        let same = |other: &&SliceTrace| (other.subject, other.slice) == (measured, model.slice);
        let Some(data) = traces.iter().find(same) else {
            continue;
        };
        let samples = model
            .samples
            .iter()
            .zip(&data.samples)
            .map(|(model, data)| {
                let pair = model.value.zip(data.value);
                let value = pair.and_then(|(model, measured)| between(spec, model, measured));
                Sample { x: model.x, value }
            });
        residuals.push(ResidualTrace {
            measured,
            model: model.subject,
            slice: model.slice,
            samples: samples.collect(),
        });
    }
    residuals
}

fn between(spec: &SliceSpec, model: f64, measured: f64) -> Option<f64> {
    match spec.residual {
        Residual::None => None,
        Residual::Difference => Some(model - measured),
        Residual::Ratio => (measured > 0.0).then(|| model / measured),
    }
}

fn measured_of(subjects: &[Subject], model: usize) -> Option<usize> {
    let series = match subjects[model].look {
        Look::Measured => return None,
        Look::Model => subjects[model].series,
        Look::Dashed | Look::Beside { .. } => subjects.first()?.series,
    };
    subjects
        .iter()
        .position(|other| other.look == Look::Measured && other.series == series)
}
