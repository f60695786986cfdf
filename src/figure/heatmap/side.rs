//! An axis of a heat map: values along its length, and ticks at round ones.

use crate::figure::scale::{self, Tick, number, whole};
use crate::figure::text::RichText;

/// Law by which values are spread along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Evenly.
    Linear,
    /// Square root of the value, as θh on the MERL grid. From 0 on.
    SquareRoot,
    /// Logarithm of the value. Above 0.
    Log,
}

impl Law {
    fn forward(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::SquareRoot => value.max(0.0).sqrt(),
            Self::Log => value.max(1e-300).ln(),
        }
    }

    fn back(self, length: f64) -> f64 {
        match self {
            Self::Linear => length,
            Self::SquareRoot => length * length,
            Self::Log => length.exp(),
        }
    }
}

/// An axis: what it is of, and where its values are.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// Title in the markup of [`crate::figure::text`].
    pub title: String,
    /// Law by which values are spread.
    pub law: Law,
    /// First and last value.
    pub range: (f64, f64),
    /// Whether the values are degrees.
    pub degrees: bool,
}

impl Side {
    /// An angle from 0° to 90°.
    pub fn angle(title: &str, law: Law) -> Self {
        Self {
            title: title.to_string(),
            law,
            range: (0.0, 90.0),
            degrees: true,
        }
    }

    /// The share of the axis at a value: 0 at the first, 1 at the last.
    pub fn share(&self, value: f64) -> f64 {
        let [low, high, at] = [self.range.0, self.range.1, value].map(|x| self.law.forward(x));
        (at - low) / (high - low)
    }

    /// The value at a share: the inverse of [`Side::share`].
    pub fn value(&self, share: f64) -> f64 {
        let [low, high] = [self.range.0, self.range.1].map(|x| self.law.forward(x));
        self.law.back(low + (high - low) * share)
    }

    /// Round values between two shares, their positions from 0 to 1 between these. `gap` is the share of that way
    /// that must lie between two.
    pub fn ticks(&self, (from, to): (f64, f64), gap: f64) -> Vec<Tick> {
        let (low, high) = (self.value(from), self.value(to));
        let position = |value: f64| (self.share(value) - from) / (to - from);
        let inside = |value: &f64| (-1e-9..=1.0 + 1e-9).contains(&position(*value));
        let mut kept: Vec<f64> = Vec::new();
        for class in self.classes(low, high) {
            let class: Vec<f64> = class.into_iter().filter(inside).collect();
            let far = |a: f64, b: f64| (position(a) - position(b)).abs() >= gap;
            if self.law == Law::SquareRoot {
                // From the right, where the angles are that matter; on the left they crowd.
                for value in class.into_iter().rev() {
                    if kept
                        .iter()
                        .all(|other| far(*other, value) || *other == value)
                    {
                        kept.push(value);
                    }
                }
            } else {
                // A class is there as a whole, or not at all: steps stay even.
                let mut all: Vec<f64> = kept.iter().copied().chain(class).collect();
                all.sort_by(f64::total_cmp);
                all.dedup_by(|a, b| (position(*a) - position(*b)).abs() < 1e-9);
                if all.windows(2).all(|pair| far(pair[0], pair[1])) {
                    kept = all;
                }
            }
        }
        kept.sort_by(f64::total_cmp);
        kept.dedup();
        let tick = |value: f64| Tick {
            value,
            position: position(value),
            label: self.label(value),
        };
        kept.into_iter().map(tick).collect()
    }

    /// Text of a value, as the axis writes it.
    pub fn label(&self, value: f64) -> RichText {
        let text = match self.law {
            Law::Log if !(1e-2..=2e3).contains(&value) => scale::power_of_ten(value),
            _ => number((1e6 * value).round() / 1e6),
        };
        RichText::parse(&if self.degrees {
            format!("{text}°")
        } else {
            text
        })
    }

    /// Round values, the roundest first.
    fn classes(&self, low: f64, high: f64) -> Vec<Vec<f64>> {
        match self.law {
            Law::Log => {
                let (first, last) = (whole(low.log10().floor()), whole(high.log10().ceil()));
                let decades = |every: i32| -> Vec<f64> {
                    let whole = (first..=last).filter(|k| k.rem_euclid(every) == 0);
                    whole.map(|k| 10f64.powi(k)).collect()
                };
                let between: Vec<f64> = decades(1)
                    .iter()
                    .flat_map(|decade| [2.0 * decade, 5.0 * decade])
                    .collect();
                let mut classes = vec![decades(3), decades(2), decades(1)];
                if high / low < 1e3 {
                    classes.push(between);
                }
                classes
            }
            Law::SquareRoot if high - low > 30.0 => {
                let tens = |every: i32| -> Vec<f64> {
                    let tens = (0..=9).filter(|k| k % every == 0);
                    tens.map(|k| 10.0 * f64::from(k)).collect()
                };
                let small = [5.0, 2.0, 1.0, 0.5, 0.2, 0.1].map(|x| vec![x]);
                [vec![tens(9), tens(3), tens(1)], small.to_vec()].concat()
            }
            Law::Linear | Law::SquareRoot => {
                let steps: &[f64] = if self.degrees {
                    &[90.0, 30.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1]
                } else {
                    &[1.0, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.005, 0.001]
                };
                let multiples = |step: &f64| -> Vec<f64> {
                    let (first, last) = ((low / step).floor() as i64, (high / step).ceil() as i64);
                    (first..=last).map(|k| k as f64 * step).collect()
                };
                // Not more than anyone could see.
                let few = |step: &&f64| (high - low) / **step < 400.0;
                steps.iter().filter(few).map(multiples).collect()
            }
        }
    }
}
