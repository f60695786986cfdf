//! Round values on an axis: rings of a polar plot, and marks along a straight axis.

use super::{Axis, RadialScale, number, power_of_ten, scaled, whole};
use crate::figure::text::RichText;

/// A value that is marked on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The value.
    pub value: f64,
    /// Length along the axis, in [0, 1].
    pub position: f64,
    /// Text of the tick.
    pub label: RichText,
}

/// Marks from one end of a straight axis to the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ticks {
    /// Ticks with a number, ascending.
    pub major: Vec<Tick>,
    /// Lengths of those between them.
    pub minor: Vec<f64>,
}

/// Kind of round steps between the ticks of a linear axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// 1, 2 or 5 times a power of ten.
    Decimal,
    /// Decimal steps, or those that divide a right angle: 15, 30, 45, 90 degrees.
    Degrees,
    /// Decimal steps of 1 and more: of things that are counted.
    Whole,
}

/// A step of a linear axis, how many parts minor marks divide it into, and how many decimals tell its multiples apart.
struct TickStep {
    size: f64,
    parts: i32,
    decimals: usize,
}

impl Steps {
    /// The smallest step that is not below `least`.
    fn at_least(self, least: f64) -> TickStep {
        if self == Self::Degrees && least > 10.0 {
            for (size, parts) in [(15.0, 3), (30.0, 3), (45.0, 3), (90.0, 3), (180.0, 2)] {
                if size >= least * (1.0 - 1e-9) {
                    return TickStep {
                        size,
                        parts,
                        decimals: 0,
                    };
                }
            }
        }
        let least = if self == Self::Whole {
            least.max(1.0)
        } else {
            least
        };
        let exponent = whole(least.log10().floor());
        let (digit, parts) = [(1.0, 5), (2.0, 4), (5.0, 5)]
            .into_iter()
            .find(|(digit, _)| scaled(*digit, exponent) >= least * (1.0 - 1e-9))
            .unwrap_or((10.0, 5));
        let size = scaled(digit, exponent);
        let exponent = if digit == 10.0 {
            exponent + 1
        } else {
            exponent
        };
        TickStep {
            size,
            parts,
            decimals: (-exponent).max(0) as usize,
        }
    }
}

/// Tolerance for a mark that rounding moves off the end of an axis.
const ROUNDING: f64 = 1e-9;
/// A decade of this length in points has marks at 2, 3, … 9.
const ROOMY_DECADE: f64 = 22.0;

/// Rings of a polar plot.
impl Axis {
    /// About `count` round values in (floor, limit], ascending: 1, 2, 5 times powers of ten, or the powers alone
    /// on a logarithmic axis.
    pub fn ticks(&self, count: usize) -> Vec<Tick> {
        let count = count.max(1);
        let values = match self.scale {
            RadialScale::Linear => even_values(self.limit, count),
            RadialScale::CubeRoot => self.spread_values(0.8 / count as f64),
            RadialScale::Log => self.decades(count),
        };
        values
            .into_iter()
            .map(|value| Tick {
                value,
                position: self.position(value),
                label: RichText::parse(&match self.scale {
                    RadialScale::Log => power_of_ten(value),
                    _ => number(value),
                }),
            })
            .collect()
    }

    /// 1-2-5 values at least `gap` of length apart, from the limit downwards.
    fn spread_values(&self, gap: f64) -> Vec<f64> {
        let mut values = Vec::new();
        let mut last = f64::INFINITY;
        let top = whole(self.limit.log10().ceil());
        for exponent in (top - 4..=top).rev() {
            for digit in [5.0, 2.0, 1.0] {
                let value = scaled(digit, exponent);
                let position = self.position(value);
                if position <= 1.0 + 1e-9 && last - position >= gap && position >= gap {
                    values.push(value);
                    last = position;
                }
            }
        }
        values.reverse();
        values
    }

    /// Powers of ten, every first, second or third.
    fn decades(&self, count: usize) -> Vec<f64> {
        let bottom = whole(self.floor.log10().round()) + 1;
        let top = whole((self.limit.log10() + 1e-9).floor());
        let step = ((top - bottom + 1).max(1) as usize).div_ceil(count);
        // Downwards, so that the largest one is always there.
        let mut values: Vec<f64> = (bottom..=top)
            .rev()
            .step_by(step)
            .map(|exponent| scaled(1.0, exponent))
            .collect();
        values.reverse();
        values
    }
}

/// Marks along a straight axis.
impl Axis {
    /// Marks of an axis of `length` points, with numbers at least about `gap` points apart.
    pub fn marks(&self, length: f32, gap: f32, steps: Steps) -> Ticks {
        let count = f64::from((length / gap.max(1.0)).max(1.0));
        match self.scale {
            RadialScale::Linear => self.even_marks(count, steps),
            RadialScale::CubeRoot => {
                let marks = self.cubic_marks(count);
                self.enough(marks, count, steps)
            }
            RadialScale::Log => {
                let marks = self.decade_marks(count, f64::from(length));
                self.enough(marks, count, steps)
            }
        }
    }

    /// A part of a bent axis that has no round number in it is nearly straight.
    fn enough(&self, marks: Ticks, count: f64, steps: Steps) -> Ticks {
        if marks.major.len() >= 2 {
            marks
        } else {
            let even = self.even_marks(count, steps);
            if even.major.len() > marks.major.len() {
                even
            } else {
                marks
            }
        }
    }

    fn within(&self, value: f64) -> Option<f64> {
        let share = self.share(value);
        (-ROUNDING..=1.0 + ROUNDING)
            .contains(&share)
            .then(|| share.clamp(0.0, 1.0))
    }

    fn even_marks(&self, count: f64, steps: Steps) -> Ticks {
        let step = steps.at_least((self.limit - self.floor) / count);
        let part = step.size / f64::from(step.parts);
        let mut marks = Ticks::default();
        let first = (self.floor / part - 1e-6).ceil();
        // More would be a mistake in the steps.
        for k in 0..400 {
            let multiple = first + f64::from(k);
            if multiple * part > self.limit + 1e-6 * part {
                break;
            }
            let Some(position) = self.within(multiple * part) else {
                continue;
            };
            if multiple.rem_euclid(f64::from(step.parts)) > 0.5 {
                marks.minor.push(position);
                continue;
            }
            let value = (multiple / f64::from(step.parts)).round() * step.size;
            let text = if step.decimals > 5 || value.abs() >= 1e5 {
                number(value)
            } else {
                format!("{value:.*}", step.decimals)
            };
            let text = match text.strip_prefix('-') {
                Some(digits) => format!("−{digits}"),
                None => text,
            };
            marks.major.push(Tick {
                value,
                position,
                label: RichText::parse(if value == 0.0 { "0" } else { &text }),
            });
        }
        marks
    }

    /// 0 and 1-2-5 values on both sides of it, from the ends inwards.
    fn cubic_marks(&self, count: f64) -> Ticks {
        let gap = 1.0 / count;
        let top = whole(self.limit.abs().max(self.floor.abs()).log10().ceil());
        let mut values = vec![0.0];
        for exponent in (top - 4..=top).rev() {
            for digit in [5.0, 2.0, 1.0] {
                let value = scaled(digit, exponent);
                values.extend([value, -value]);
            }
        }
        let mut major: Vec<Tick> = Vec::new();
        for value in values {
            let Some(position) = self.within(value) else {
                continue;
            };
            let near = |tick: &Tick| (tick.position - position).abs() < gap;
            if !major.iter().any(near) {
                major.push(Tick {
                    value,
                    position,
                    label: RichText::parse(&number(value)),
                });
            }
        }
        major.sort_by(|a, b| a.position.total_cmp(&b.position));
        Ticks {
            major,
            minor: Vec::new(),
        }
    }

    fn decade_marks(&self, count: f64, length: f64) -> Ticks {
        let (low, high) = (self.floor.log10(), self.limit.log10());
        let decades = (high - low).max(1e-9);
        let (bottom, top) = (
            whole((low - ROUNDING).ceil()),
            whole((high + ROUNDING).floor()),
        );
        let mut marks = Ticks::default();
        let mut add_major = |value: f64, text: String| {
            if let Some(position) = self.within(value) {
                let label = RichText::parse(&text);
                marks.major.push(Tick {
                    value,
                    position,
                    label,
                });
            }
        };
        let digits: &[f64] = if top - bottom >= 2 {
            let step = ((decades / count).ceil() as usize).max(1);
            for exponent in (bottom..=top).rev().step_by(step) {
                let value = scaled(1.0, exponent);
                add_major(value, power_of_ten(value));
            }
            &[]
        } else if count >= 3.3 * decades {
            &[1.0, 2.0, 5.0]
        } else if count >= 2.0 * decades {
            &[1.0, 3.0]
        } else {
            &[1.0]
        };
        for exponent in bottom - 1..=top {
            for digit in digits {
                let value = scaled(*digit, exponent);
                add_major(value, number(value));
            }
        }
        marks
            .major
            .sort_by(|a, b| a.position.total_cmp(&b.position));
        let roomy = length / decades >= ROOMY_DECADE;
        let between: &[f64] = if roomy {
            &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
        } else {
            &[1.0]
        };
        for exponent in bottom - 1..=top {
            for digit in between {
                let Some(position) = self.within(scaled(*digit, exponent)) else {
                    continue;
                };
                let same = |tick: &Tick| (tick.position - position).abs() < ROUNDING;
                if !marks.major.iter().any(same) {
                    marks.minor.push(position);
                }
            }
        }
        marks
    }
}

/// Multiples of the smallest step of 1, 2 or 5 times a power of ten that needs no more than `count`.
fn even_values(limit: f64, count: usize) -> Vec<f64> {
    let least = limit / count as f64;
    let exponent = whole(least.log10().floor());
    let digit = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|digit| scaled(*digit, exponent) >= least * (1.0 - 1e-9))
        .unwrap_or(10.0);
    (1..=count)
        .map(|k| scaled(digit * k as f64, exponent))
        .take_while(|value| *value <= limit * (1.0 + 1e-9))
        .collect()
}
