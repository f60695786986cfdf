//! How values become lengths: linear, cube root or logarithmic, with limits and ticks at round values.

use super::text::RichText;

/// The law of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RadialScale {
    /// Length in proportion to the value.
    Linear,
    /// To its cube root: peaks and tails in one picture, and 0 stays 0.
    #[default]
    CubeRoot,
    /// To its logarithm above a floor, which is at length 0.
    Log,
}

/// All radial scales in the order offered.
pub const RADIAL_SCALES: [RadialScale; 3] =
    [RadialScale::Linear, RadialScale::CubeRoot, RadialScale::Log];

impl RadialScale {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::CubeRoot => "cube-root",
            Self::Log => "log",
        }
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "Linear",
            Self::CubeRoot => "Cube root",
            Self::Log => "Log",
        }
    }

    /// What an axis title says of it, in the markup of [`super::text`].
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::CubeRoot => "cube root",
            Self::Log => "log_{10}",
        }
    }

    /// The scale whose key this is.
    pub fn by_key(key: &str) -> Option<Self> {
        RADIAL_SCALES.into_iter().find(|scale| scale.key() == key)
    }
}

/// Fewest and most decades that a logarithmic axis shows.
const DECADES: (i32, i32) = (3, 6);

/// A scale with its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Its law.
    pub scale: RadialScale,
    /// The value at length 1, > 0.
    pub limit: f64,
    /// The value at length 0: a power of ten on a logarithmic axis, 0 on the others.
    pub floor: f64,
}

/// A value that is marked on an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The value.
    pub value: f64,
    /// Its length, in (0, 1].
    pub position: f64,
    /// How it is written.
    pub label: RichText,
}

impl Axis {
    /// An axis up to `limit`, for values of which `smallest` is the smallest positive one.
    ///
    /// A limit that is no positive number becomes 1. The floor of a logarithmic axis is the power of ten below
    /// `smallest`, three to six decades below the limit.
    pub fn new(scale: RadialScale, limit: f64, smallest: Option<f64>) -> Self {
        let limit = if limit.is_finite() && limit > 0.0 {
            limit.max(1e-300)
        } else {
            1.0
        };
        let floor = match scale {
            RadialScale::Linear | RadialScale::CubeRoot => 0.0,
            RadialScale::Log => {
                // The decade that the limit ends: 1 for limits in (0.1, 1].
                let top = (limit.log10() - 1e-9).ceil() as i32;
                let wanted =
                    smallest.map_or(top - DECADES.0, |x| (x.log10() - 1e-9).floor() as i32);
                10f64.powi(wanted.clamp(top - DECADES.1, top - DECADES.0))
            }
        };
        Self {
            scale,
            limit,
            floor,
        }
    }

    /// The length of a value: 0 at the floor and below, 1 at the limit, more above it.
    pub fn position(&self, value: f64) -> f64 {
        match self.scale {
            RadialScale::Linear => (value / self.limit).max(0.0),
            RadialScale::CubeRoot => (value / self.limit).max(0.0).cbrt(),
            RadialScale::Log if value <= self.floor => 0.0,
            RadialScale::Log => (value / self.floor).log10() / (self.limit / self.floor).log10(),
        }
    }

    /// The value of a length: the inverse of [`Axis::position`] above the floor.
    pub fn value(&self, position: f64) -> f64 {
        match self.scale {
            RadialScale::Linear => self.limit * position,
            RadialScale::CubeRoot => self.limit * position.powi(3),
            RadialScale::Log => self.floor * (self.limit / self.floor).powf(position),
        }
    }

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
        let top = self.limit.log10().ceil() as i32;
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
        let bottom = self.floor.log10().round() as i32 + 1;
        let top = (self.limit.log10() + 1e-9).floor() as i32;
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

/// The next round limit that is not below `max`: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten; 1 for `max` = 0.
pub fn nice_limit(max: f64) -> f64 {
    if !(max > 0.0 && max.is_finite()) {
        return 1.0;
    }
    let exponent = max.log10().floor() as i32;
    let mantissa = max / 10f64.powi(exponent);
    let digit = [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]
        .into_iter()
        .find(|digit| mantissa <= digit * (1.0 + 1e-9));
    match digit {
        Some(digit) => scaled(digit, exponent),
        None => scaled(1.0, exponent + 1),
    }
}

/// A number as markup with up to four digits: `0.25`, `1200`, `3·10^{6}`.
pub fn number(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let exponent = value.abs().log10().floor() as i32;
    if (-3..=4).contains(&exponent) {
        return trimmed(&format!("{value:.*}", (3 - exponent).max(0) as usize));
    }
    let mantissa = trimmed(&format!("{:.3}", value / 10f64.powi(exponent)));
    format!("{mantissa}·10^{{{}}}", signed(exponent))
}

fn trimmed(digits: &str) -> String {
    let digits = if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    };
    digits.replace('-', "−")
}

/// A power of ten as markup: plain from 1 to 100.
pub fn power_of_ten(value: f64) -> String {
    match value.log10().round() as i32 {
        exponent @ 0..=2 => number(scaled(1.0, exponent)),
        exponent => format!("10^{{{}}}", signed(exponent)),
    }
}

fn signed(exponent: i32) -> String {
    exponent.to_string().replace('-', "−")
}

/// digit · 10^exponent, rounded once for negative exponents too.
fn scaled(digit: f64, exponent: i32) -> f64 {
    if exponent < 0 {
        digit / 10f64.powi(-exponent)
    } else {
        digit * 10f64.powi(exponent)
    }
}

/// Multiples of the smallest step of 1, 2 or 5 times a power of ten that needs no more than `count`.
fn even_values(limit: f64, count: usize) -> Vec<f64> {
    let least = limit / count as f64;
    let exponent = least.log10().floor() as i32;
    let digit = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|digit| scaled(*digit, exponent) >= least * (1.0 - 1e-9))
        .unwrap_or(10.0);
    (1..=count)
        .map(|k| scaled(digit * k as f64, exponent))
        .take_while(|value| *value <= limit * (1.0 + 1e-9))
        .collect()
}

#[cfg(test)]
mod tests;
