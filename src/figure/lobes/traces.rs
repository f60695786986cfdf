//! The numbers of a lobe plot: every curve sampled over θo for every θi.

use super::LobeSpec;
use crate::figure::subject::Subject;
use std::f64::consts::FRAC_PI_2;

/// One curve at one θi.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Position of the subject in the list that was plotted.
    pub subject: usize,
    /// Position of θi in the spec.
    pub lobe: usize,
    /// By ascending θo, from horizon to horizon.
    pub samples: Vec<Sample>,
}

/// One value of a trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Signed θo in radians.
    pub theta_o: f64,
    /// What is plotted, in 1/sr; `None` where nothing was measured.
    pub value: Option<f64>,
}

impl Trace {
    /// The values it has.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.samples.iter().filter_map(|sample| sample.value)
    }

    /// Its highest value and where that is.
    pub fn peak(&self) -> Option<(f64, f64)> {
        self.samples
            .iter()
            .filter_map(|sample| Some((sample.theta_o, sample.value?)))
            .max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The value at a signed θo, interpolated linearly; `None` in gaps and outside.
    pub fn value_at(&self, theta_o: f64) -> Option<f64> {
        let behind = self
            .samples
            .partition_point(|sample| sample.theta_o < theta_o);
        let b = self.samples.get(behind)?;
        if b.theta_o == theta_o {
            return b.value;
        }
        let a = self.samples.get(behind.checked_sub(1)?)?;
        let t = (theta_o - a.theta_o) / (b.theta_o - a.theta_o);
        Some(a.value? + t * (b.value? - a.value?))
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
                    theta_o: *theta_o,
                    value: spec.value(subject, *theta_i, *theta_o),
                });
                traces.push(Trace {
                    subject: index,
                    lobe,
                    samples: samples.collect(),
                });
            }
        }
    }
    traces
}

/// Steps of θo, in degrees.
const STEP_DEG: f64 = 0.25;
/// The finest step next to the mirror direction, and how much coarser each following one is. A lobe with
/// s = 100,000 has fallen to half its height 0.2° away, one with s = 10^7 within 0.02°.
const FINEST_DEG: f64 = 0.002;
const GROWTH: f64 = 1.15;

/// Signed θo from horizon to horizon, closer where a highlight may be, ascending.
fn angles_around(mirror: f64) -> Vec<f64> {
    let steps = (180.0 / STEP_DEG) as i32;
    let mut angles: Vec<f64> = (0..=steps)
        .map(|k| (f64::from(k) * STEP_DEG - 90.0).to_radians())
        .collect();
    angles.push(mirror);
    let mut offset_deg = FINEST_DEG;
    while offset_deg < 2.0 {
        let offset = offset_deg.to_radians();
        angles.extend([mirror - offset, mirror + offset]);
        offset_deg *= GROWTH;
    }
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

    #[test]
    fn values_between_samples_need_both_neighbours() {
        let sample = |theta_o, value| Sample { theta_o, value };
        let trace = Trace {
            subject: 0,
            lobe: 0,
            samples: vec![
                sample(0.0, Some(1.0)),
                sample(1.0, Some(3.0)),
                sample(2.0, None),
            ],
        };
        assert_eq!(trace.value_at(0.5), Some(2.0));
        assert_eq!(trace.value_at(1.0), Some(3.0));
        assert_eq!(trace.value_at(1.5), None);
        assert_eq!(trace.value_at(-0.1), None);
        assert_eq!(trace.value_at(2.1), None);
        assert_eq!(trace.peak(), Some((1.0, 3.0)));
    }
}
