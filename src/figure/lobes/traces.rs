//! The numbers of a lobe plot: every curve sampled over θo for every θi.

use super::spec::LobeSpec;
use crate::figure::samples::{self, Sample};
use crate::figure::subject::Subject;
use crate::geom::limits::UNRELIABLE_THETA;
use std::f64::consts::FRAC_PI_2;

/// One curve at one θi.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Position of the subject in the list that was plotted.
    pub subject: usize,
    /// Position of θi in the spec.
    pub lobe: usize,
    /// Samples by ascending signed θo, from horizon to horizon; values in 1/sr, or in shares of their maximum.
    pub samples: Vec<Sample>,
}

impl Trace {
    /// The values it has.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        samples::values(&self.samples)
    }

    /// Signed θo in radians of the highest value, and that value.
    pub fn peak(&self) -> Option<(f64, f64)> {
        samples::peak(&self.samples)
    }

    /// The value at a signed θo, interpolated linearly; `None` in gaps and outside.
    pub fn value_at(&self, theta_o: f64) -> Option<f64> {
        samples::value_at(&self.samples, theta_o)
    }
}

/// All curves that are shown, for all θi.
pub(super) fn trace_all(spec: &LobeSpec, subjects: &[Subject]) -> Vec<Trace> {
    let mut traces = Vec::new();
    for (lobe, theta_i) in spec.theta_i.iter().enumerate() {
        let angles = angles_around(*theta_i);
        for (index, subject) in subjects.iter().enumerate() {
            if !subject.hidden {
                let samples = angles.iter().map(|theta_o| Sample {
                    x: *theta_o,
                    value: spec.value(subject, *theta_i, *theta_o),
                });
                let mut samples: Vec<Sample> = samples.collect();
                if spec.shape_only {
                    to_shares(&mut samples);
                }
                traces.push(Trace {
                    subject: index,
                    lobe,
                    samples,
                });
            }
        }
    }
    traces
}

/// Divides a curve by its highest value, up to 80° from the normal where it has one there.
fn to_shares(samples: &mut [Sample]) {
    let highest = |most: f64| {
        let near = samples.iter().filter(|sample| sample.x.abs() <= most);
        near.filter_map(|sample| sample.value)
            .filter(|value| *value > 0.0)
            .max_by(f64::total_cmp)
    };
    let Some(highest) = highest(UNRELIABLE_THETA).or_else(|| highest(FRAC_PI_2)) else {
        return;
    };
    for value in samples
        .iter_mut()
        .filter_map(|sample| sample.value.as_mut())
    {
        *value /= highest;
    }
}

/// Steps of θo, in degrees.
const STEP_DEG: f64 = 0.25;
/// Signed θo from horizon to horizon, closer where a highlight may be, ascending.
fn angles_around(mirror: f64) -> Vec<f64> {
    let steps = (180.0 / STEP_DEG) as i32;
    let mut angles: Vec<f64> = (0..=steps)
        .map(|k| (f64::from(k) * STEP_DEG - 90.0).to_radians())
        .collect();
    angles.extend(samples::around_peak(mirror));
    angles.retain(|theta_o| theta_o.abs() <= FRAC_PI_2);
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    angles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_dense_at_the_mirror_direction_and_few() {
        for mirror_deg in [0.0_f64, 37.3, 89.5] {
            let mirror = mirror_deg.to_radians();
            let angles = angles_around(mirror);
            assert!(angles.len() <= 1000, "{}", angles.len());
            assert!(angles.is_sorted() && angles.contains(&mirror));
            let half_width = (2.0 * 2f64.ln() / 1e5).sqrt();
            let within = |a: &&f64| (**a - mirror).abs() < half_width;
            assert!(angles.iter().filter(within).count() >= 30);
        }
    }
}
