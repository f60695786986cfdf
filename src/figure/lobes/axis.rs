//! The axis of a lobe plot: as the spec says, or chosen such that the lobes fill their plot.
//!
//! One grazing θi makes f_r 10 to 1000 times what it is elsewhere. An axis up to that peak leaves a blob of the others,
//! so it may end before it: the lobe is clipped there, and its peak written beside the mark.

use super::spec::{LobeScale, LobeSpec};
use super::traces::Trace;
use crate::figure::scale::{Axis, RadialScale, nice_limit, whole};
use crate::figure::subject::{Look, Subject};
use crate::geom::limits::{UNRELIABLE_THETA, UNRELIABLE_THETA_DEG};
use std::f64::consts::FRAC_PI_2;

/// The least peak over the base of the curves up to which they are matte, and up to which they are glossy.
const MATTE: f64 = 4.0;
const GLOSSY: f64 = 40.0;

/// Factor by which the highest lobe may exceed the next one before it is clipped: on a linear axis, on one by the
/// cube root.
const CLIPPED: (f64, f64) = (2.5, 3.0);

/// Factor by which a lobe may rise beyond 80° for the axis to hold that too.
const GRAZING: f64 = 1.5;

/// Room beyond the highest lobe that is not clipped.
const ROOM: f64 = 1.08;

/// One axis for all curves.
pub(super) fn axis_for(spec: &LobeSpec, subjects: &[Subject], traces: &[Trace]) -> Axis {
    let profile = match spec.scale {
        LobeScale::Auto => Profile::of(spec, subjects, traces),
        _ => None,
    };
    let law = || profile.as_ref().map_or(RadialScale::Linear, Profile::scale);
    let scale = spec.scale.law().unwrap_or_else(law);
    if let Some([low, high]) = spec.limits {
        // Only a logarithm begins above 0; the limits may have been set on another scale.
        let low = if scale == RadialScale::Log { low } else { 0.0 };
        return Axis::between(scale, low, high);
    }
    if let Some(profile) = profile {
        return profile.axis(scale);
    }
    let values = || traces.iter().flat_map(Trace::values);
    let limit = nice_limit(values().fold(0.0, f64::max));
    let smallest = values().filter(|x| *x > 0.0).min_by(f64::total_cmp);
    Axis::new(scale, limit, smallest)
}

/// Heights of the curves: of the data where there are any, so that the axis keeps still while a model is moved.
struct Profile {
    /// Highest value of each lobe up to 80° from the normal, ascending; with it the highest of all.
    peaks: Vec<(f64, f64)>,
    /// Typical value: the median.
    base: f64,
    /// Low value: one in ten is below it.
    low: f64,
}

impl Profile {
    /// `None` where no curve has a positive value.
    fn of(spec: &LobeSpec, subjects: &[Subject], traces: &[Trace]) -> Option<Self> {
        let measured = |trace: &&Trace| {
            subjects[trace.subject].look == Look::Measured && trace.values().next().is_some()
        };
        let counted: Vec<&Trace> = if traces.iter().any(|trace| measured(&trace)) {
            traces.iter().filter(measured).collect()
        } else {
            traces.iter().collect()
        };
        let mut peaks: Vec<(f64, f64)> = Vec::new();
        for lobe in 0..spec.theta_i.len() {
            let of_lobe = counted.iter().filter(|trace| trace.lobe == lobe);
            let samples: Vec<_> = of_lobe.flat_map(|trace| &trace.samples).collect();
            let highest = |most: f64| {
                let near = samples.iter().filter(|sample| sample.x.abs() <= most);
                let values = near.filter_map(|sample| sample.value);
                values.filter(|value| *value > 0.0).max_by(f64::total_cmp)
            };
            peaks.extend(highest(UNRELIABLE_THETA).zip(highest(FRAC_PI_2)));
        }
        peaks.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Samples crowd around the peak: values at whole degrees count alike.
        let last = UNRELIABLE_THETA_DEG as i32;
        let mut values: Vec<f64> = (-last..=last)
            .flat_map(|deg| {
                let theta_o = f64::from(deg).to_radians();
                counted
                    .iter()
                    .filter_map(move |trace| trace.value_at(theta_o))
            })
            .filter(|value| *value > 0.0)
            .collect();
        values.sort_by(f64::total_cmp);
        if peaks.is_empty() || values.is_empty() {
            return None;
        }
        Some(Self {
            peaks,
            base: values[values.len() / 2],
            low: values[values.len() / 10],
        })
    }

    /// The scale on which the base and the lobes can both be seen.
    fn scale(&self) -> RadialScale {
        let height = self.peaks[0].0 / self.base;
        // The smallest lobe is to be a third of the radius at least.
        let spread = |scale| self.rim(scale) / self.peaks[0].0;
        if height <= MATTE && spread(RadialScale::Linear) <= 3.0 {
            RadialScale::Linear
        } else if height <= GLOSSY && spread(RadialScale::CubeRoot) <= 27.0 {
            RadialScale::CubeRoot
        } else {
            RadialScale::Log
        }
    }

    /// The highest value that is to be inside the rim.
    fn rim(&self, scale: RadialScale) -> f64 {
        let highest = self.peaks.len() - 1;
        let clipped = match scale {
            RadialScale::Linear => CLIPPED.0,
            RadialScale::CubeRoot => CLIPPED.1,
            // It has room for all.
            RadialScale::Log => return self.peaks.iter().fold(0.0, |most, peak| most.max(peak.1)),
        };
        let next = highest.checked_sub(1).map(|next| self.peaks[next]);
        let (peak, with_grazing) = next
            .filter(|next| self.peaks[highest].0 > clipped * next.0)
            .unwrap_or(self.peaks[highest]);
        if with_grazing <= GRAZING * peak {
            with_grazing
        } else {
            peak
        }
    }

    fn axis(&self, scale: RadialScale) -> Axis {
        // A power of ten below the low values, so that the base stands clear of the middle.
        let floor = match scale {
            RadialScale::Linear | RadialScale::CubeRoot => 0.0,
            RadialScale::Log => 10f64.powi(whole((self.low / 2.0).log10().floor())),
        };
        Axis::between(scale, floor, ROOM * self.rim(scale))
    }
}
