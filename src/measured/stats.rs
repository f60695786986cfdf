//! Statistics of a whole table.

use super::table::Table;

/// Minimum, median and maximum of f_r in one channel over the valid cells, in 1/sr. NaN where no cell is valid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelStats {
    /// Smallest value.
    pub min: f64,
    /// Median; the mean of the two middle values of an even number.
    pub median: f64,
    /// Largest value.
    pub max: f64,
}

impl Table {
    /// Statistics of red, green and blue.
    pub fn channel_stats(&self) -> [ChannelStats; 3] {
        std::array::from_fn(|channel| {
            let values = self.cells().iter().map(|cell| cell[channel]);
            spread(values.filter(|f_r| !f_r.is_nan()).collect())
        })
    }
}

fn spread(mut values: Vec<f32>) -> ChannelStats {
    if values.is_empty() {
        return ChannelStats {
            min: f64::NAN,
            median: f64::NAN,
            max: f64::NAN,
        };
    }
    let half = values.len() / 2;
    let even = values.len().is_multiple_of(2);
    let (below, middle, above) = values.select_nth_unstable_by(half, f32::total_cmp);
    let upper = f64::from(*middle);
    let largest = |part: &[f32]| part.iter().copied().max_by(f32::total_cmp).map(f64::from);
    let smallest = |part: &[f32]| part.iter().copied().min_by(f32::total_cmp).map(f64::from);
    let lower = if even { largest(below) } else { None };
    ChannelStats {
        min: smallest(below).unwrap_or(upper),
        median: 0.5 * (lower.unwrap_or(upper) + upper),
        max: largest(above).unwrap_or(upper),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_of_an_even_number_is_between_the_middle_two() {
        let of = |values: &[f32]| {
            let stats = spread(values.to_vec());
            (stats.min, stats.median, stats.max)
        };
        assert_eq!(of(&[4.0, 1.0, 3.0, 2.0]), (1.0, 2.5, 4.0));
        assert_eq!(of(&[5.0, 1.0, 3.0]), (1.0, 3.0, 5.0));
        assert_eq!(of(&[2.0, 1.0]), (1.0, 1.5, 2.0));
        assert_eq!(of(&[7.0]), (7.0, 7.0, 7.0));
        assert!(spread(Vec::new()).median.is_nan());
    }
}
