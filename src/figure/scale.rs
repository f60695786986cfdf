//! Scales from values to lengths: linear, cube root or logarithmic, with limits and ticks at round values.

use crate::keys;
use serde::{Deserialize, Serialize};

mod ticks;

pub use ticks::{Steps, Tick, Ticks};

/// The law of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RadialScale {
    /// Length in proportion to the value.
    Linear,
    /// Length by the cube root of the value: peaks and tails in one picture, and 0 stays 0.
    #[default]
    CubeRoot,
    /// Length by the logarithm of the value above a floor, which is at length 0.
    Log,
}

/// All radial scales in the order offered.
pub const RADIAL_SCALES: [RadialScale; 3] =
    [RadialScale::Linear, RadialScale::CubeRoot, RadialScale::Log];

impl RadialScale {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "Linear",
            Self::CubeRoot => "Cube root",
            Self::Log => "Log",
        }
    }

    /// Words for the scale in an axis title, in the markup of [`super::text`].
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::CubeRoot => "cube root",
            Self::Log => "log_{10}",
        }
    }

    /// The scale whose key this is.
    pub fn by_key(key: &str) -> Option<Self> {
        keys::by_key(key)
    }
}

/// Fewest and most decades that a logarithmic axis shows.
const DECADES: (i32, i32) = (3, 6);

/// A scale with its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Law from values to lengths.
    pub scale: RadialScale,
    /// The value at length 1.
    pub limit: f64,
    /// The value at length 0, below `limit`; > 0 on a logarithmic axis.
    pub floor: f64,
}

impl Axis {
    /// An axis up to `limit`, for values of which `smallest` is the smallest positive one.
    ///
    /// A limit that is no positive number becomes 1. The floor is 0; of a logarithmic axis it is the power of ten
    /// below `smallest`, three to six decades below the limit.
    pub fn new(scale: RadialScale, limit: f64, smallest: Option<f64>) -> Self {
        Self::with_decades(scale, limit, smallest, DECADES)
    }

    /// Axis with the fewest and most decades that it shows where it is logarithmic.
    pub fn with_decades(
        scale: RadialScale,
        limit: f64,
        smallest: Option<f64>,
        (fewest, most): (i32, i32),
    ) -> Self {
        let limit = if limit.is_finite() && limit > 0.0 {
            limit.max(1e-300)
        } else {
            1.0
        };
        let floor = match scale {
            RadialScale::Linear | RadialScale::CubeRoot => 0.0,
            RadialScale::Log => {
                // The decade that the limit ends: 1 for limits in (0.1, 1].
                let top = whole((limit.log10() - 1e-9).ceil());
                let wanted = smallest.map_or(top - fewest, |x| whole((x.log10() - 1e-9).floor()));
                10f64.powi(wanted.clamp(top - most, top - fewest))
            }
        };
        Self {
            scale,
            limit,
            floor,
        }
    }

    /// An axis from `low` to `high`; where they are not ends of this scale, the nearest that are.
    pub fn between(scale: RadialScale, low: f64, high: f64) -> Self {
        let high = if high.is_finite() { high } else { 1.0 };
        let low = if low.is_finite() { low } else { 0.0 };
        let (floor, limit) = match scale {
            RadialScale::Log => {
                let limit = if high > 0.0 { high.max(1e-300) } else { 1.0 };
                let floor = if low > 0.0 { low } else { 1e-6 * limit };
                (floor, limit)
            }
            RadialScale::Linear | RadialScale::CubeRoot => (low, high),
        };
        // Closer than this the ends cannot be told from rounding.
        let least = 1e-9 * floor.abs().max(limit.abs()).max(1e-290);
        Self {
            scale,
            floor,
            limit: limit.max(floor + least),
        }
    }

    /// The axis that holds both: where their laws differ, by the one that shows more decades.
    pub fn around(self, other: Self) -> Self {
        let decades = |axis: &Self| axis.scale as usize;
        let (wide, narrow) = if decades(&other) > decades(&self) {
            (other, self)
        } else {
            (self, other)
        };
        // The floor of a linear axis says nothing of how deep a logarithm has to go.
        let floor = if wide.scale == narrow.scale {
            wide.floor.min(narrow.floor)
        } else {
            wide.floor
        };
        Self {
            scale: wide.scale,
            floor,
            limit: wide.limit.max(narrow.limit),
        }
    }

    /// Lengths in proportion to this are evenly spread; −∞ for what a logarithm has no number for.
    fn bent(&self, value: f64) -> f64 {
        match self.scale {
            RadialScale::Linear => value,
            RadialScale::CubeRoot => value.cbrt(),
            RadialScale::Log if value > 0.0 => value.log10(),
            RadialScale::Log => f64::NEG_INFINITY,
        }
    }

    /// The length of a value: 0 at the floor, 1 at the limit, outside [0, 1] beyond them; −∞ where a logarithmic axis
    /// has no place for it.
    pub fn share(&self, value: f64) -> f64 {
        let from = self.bent(self.floor);
        (self.bent(value) - from) / (self.bent(self.limit) - from)
    }

    /// Length of a value, where lengths end at 0: 0 at the floor and below.
    pub fn position(&self, value: f64) -> f64 {
        self.share(value).max(0.0)
    }

    /// The value of a length: the inverse of [`Axis::share`].
    pub fn value(&self, position: f64) -> f64 {
        let (from, to) = (self.bent(self.floor), self.bent(self.limit));
        let bent = from + (to - from) * position;
        match self.scale {
            RadialScale::Linear => bent,
            RadialScale::CubeRoot => bent.powi(3),
            RadialScale::Log => 10f64.powf(bent),
        }
    }

    /// The ends of what is seen `factor` times larger, with the value at length `around` where it was.
    pub fn zoomed(&self, around: f64, factor: f64) -> [f64; 2] {
        let (below, above) = (around / factor, (1.0 - around) / factor);
        [self.value(around - below), self.value(around + above)]
    }

    /// The ends of what is seen a length further on.
    pub fn moved(&self, by: f64) -> [f64; 2] {
        [self.value(by), self.value(1.0 + by)]
    }
}

/// The next round limit that is not below `max`: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten; 1 for `max` = 0.
pub fn nice_limit(max: f64) -> f64 {
    if !(max > 0.0 && max.is_finite()) {
        return 1.0;
    }
    let exponent = whole(max.log10().floor());
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
    let exponent = whole(value.abs().log10().floor());
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
    match whole(value.log10().round()) {
        exponent @ 0..=2 => number(scaled(1.0, exponent)),
        exponent => format!("10^{{{}}}", signed(exponent)),
    }
}

/// The exponent of a decade as a whole number, held to those that f64 has: a loop over decades ends whatever the ends of
/// an axis are.
pub(super) fn whole(exponent: f64) -> i32 {
    exponent.clamp(-324.0, 309.0) as i32
}

fn signed(exponent: i32) -> String {
    exponent.to_string().replace('-', "−")
}

/// digit · 10^exponent, rounded once for negative exponents too.
pub(super) fn scaled(digit: f64, exponent: i32) -> f64 {
    if exponent < 0 {
        digit / 10f64.powi(-exponent)
    } else {
        digit * 10f64.powi(exponent)
    }
}

#[cfg(test)]
mod tests;
