//! Sampled curves: values over x, with gaps.

/// One value of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Angle in radians.
    pub x: f64,
    /// Plotted value; `None` where there is none.
    pub value: Option<f64>,
}

/// The values that a curve has.
pub fn values(samples: &[Sample]) -> impl Iterator<Item = f64> {
    samples.iter().filter_map(|sample| sample.value)
}

/// Angle in radians of the highest sample, and its value.
pub fn peak(samples: &[Sample]) -> Option<(f64, f64)> {
    samples
        .iter()
        .filter_map(|sample| Some((sample.x, sample.value?)))
        .max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The value at x of a curve by ascending x, interpolated linearly; `None` in gaps and outside.
pub fn value_at(samples: &[Sample], x: f64) -> Option<f64> {
    let behind = samples.partition_point(|sample| sample.x < x);
    let b = samples.get(behind)?;
    if b.x == x {
        return b.value;
    }
    let a = samples.get(behind.checked_sub(1)?)?;
    let t = (x - a.x) / (b.x - a.x);
    Some(a.value? + t * (b.value? - a.value?))
}

/// The finest step next to the mirror direction, and how much coarser each following one is. A lobe with
/// s = 100,000 has fallen to half its height 0.2° away, one with s = 10^7 within 0.02°.
const FINEST_DEG: f64 = 0.002;
const GROWTH: f64 = 1.15;

/// Distance from a peak within which samples stand closer, in degrees.
const PEAK_DEG: f64 = 2.0;

/// Angles in radians around one where a highlight may be, and that one itself; not in order.
pub(super) fn around_peak(peak: f64) -> impl Iterator<Item = f64> {
    let offsets = std::iter::successors(Some(FINEST_DEG), |offset| Some(offset * GROWTH));
    let sides = offsets
        .take_while(|offset| *offset < PEAK_DEG)
        .flat_map(move |offset| [peak - offset.to_radians(), peak + offset.to_radians()]);
    std::iter::once(peak).chain(sides)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_between_samples_need_both_neighbours() {
        let sample = |x, value| Sample { x, value };
        let samples = [
            sample(0.0, Some(1.0)),
            sample(1.0, Some(3.0)),
            sample(2.0, None),
        ];
        assert_eq!(value_at(&samples, 0.5), Some(2.0));
        assert_eq!(value_at(&samples, 1.0), Some(3.0));
        assert_eq!(value_at(&samples, 1.5), None);
        assert_eq!(value_at(&samples, -0.1), None);
        assert_eq!(value_at(&samples, 2.1), None);
        assert_eq!(peak(&samples), Some((1.0, 3.0)));
        assert_eq!(values(&samples).sum::<f64>(), 4.0);
    }
}
