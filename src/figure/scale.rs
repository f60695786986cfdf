//! Scales: how a value becomes a length, and which values are labelled.

/// How the radius of a polar plot grows with the value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RadialScale {
    /// In proportion.
    Linear,
    /// With the cube root: shows the base of a lobe beside its peak.
    CubeRoot,
    /// With the logarithm, from a floor of a few decades below the limit.
    Log,
}

/// All radial scales in the order offered.
pub const RADIAL_SCALES: [RadialScale; 3] =
    [RadialScale::Linear, RadialScale::CubeRoot, RadialScale::Log];

/// Decades between the centre and the limit of a logarithmic scale.
pub const DECADES: i32 = 4;

/// A labelled value.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The value.
    pub value: f64,
    /// Its label, in the markup of [`super::text`].
    pub label: String,
}

impl RadialScale {
    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "Linear",
            Self::CubeRoot => "Cube root",
            Self::Log => "Log",
        }
    }

    /// What an axis title says of it.
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::CubeRoot => "cube root",
            Self::Log => "log_{10}",
        }
    }

    /// The length of a value ≥ 0 where `limit` > 0 has length 1. Values below the floor of the logarithm have length 0.
    pub fn length(self, value: f64, limit: f64) -> f64 {
        let x = (value / limit).max(0.0);
        match self {
            Self::Linear => x,
            Self::CubeRoot => x.cbrt(),
            Self::Log if x > 0.0 => (1.0 + x.log10() / f64::from(DECADES)).max(0.0),
            Self::Log => 0.0,
        }
    }

    /// The value of a length in [0, 1]: the inverse of [`RadialScale::length`] above the floor.
    pub fn value(self, length: f64, limit: f64) -> f64 {
        limit
            * match self {
                Self::Linear => length,
                Self::CubeRoot => length.powi(3),
                Self::Log => 10f64.powf(f64::from(DECADES) * (length - 1.0)),
            }
    }

    /// A round limit at or above `peak`: the end of the axis.
    pub fn limit(self, peak: f64) -> f64 {
        let peak = if peak.is_finite() && peak > 0.0 {
            peak
        } else {
            1.0
        };
        match self {
            Self::Log => 10f64.powf(peak.log10().ceil()),
            // A little room above the tip; the rings are round values, not the rim.
            Self::Linear | Self::CubeRoot => 1.04 * peak,
        }
    }

    /// Round values inside the axis, the smallest first.
    pub fn ticks(self, limit: f64) -> Vec<Tick> {
        let values: Vec<f64> = match self {
            Self::Linear => {
                let step = nice_step(limit / 3.5);
                (1..)
                    .map(|k| f64::from(k) * step)
                    .take_while(|value| *value <= limit)
                    .collect()
            }
            Self::CubeRoot => {
                // Down from a round value near the limit by factors of about ten: radii ⅓ to 1.
                let top = nice_floor(limit);
                let mut values: Vec<f64> = [1.0, 0.3, 0.05]
                    .into_iter()
                    .map(|share| nice_floor(top * share))
                    .collect();
                values.dedup();
                values.reverse();
                values
            }
            Self::Log => {
                let top = limit.log10().round() as i32;
                (top - DECADES + 1..=top)
                    .map(|exponent| 10f64.powi(exponent))
                    .collect()
            }
        };
        values
            .into_iter()
            .map(|value| Tick {
                value,
                label: label(value, self == Self::Log),
            })
            .collect()
    }
}

/// The largest of 1, 2, 5 · 10^k at or below `x`.
fn nice_floor(x: f64) -> f64 {
    let decade = 10f64.powf(x.log10().floor());
    let mantissa = x / decade * (1.0 + 1e-9);
    decade
        * [5.0, 2.0, 1.0]
            .into_iter()
            .find(|nice| mantissa >= *nice)
            .unwrap_or(1.0)
}

/// The smallest of 1, 2, 5 · 10^k at or above `x`.
fn nice_step(x: f64) -> f64 {
    let below = nice_floor(x);
    [1.0, 2.0, 2.5, 5.0]
        .into_iter()
        .map(|factor| nice_floor(below * factor))
        .find(|step| *step >= x * (1.0 - 1e-9))
        .unwrap_or(5.0 * below)
}

/// A round value as a label: a power of ten where `as_power` or where plain digits grow long.
pub fn label(value: f64, as_power: bool) -> String {
    let exponent = value.log10().floor() as i32;
    let mantissa = value / 10f64.powi(exponent);
    if as_power && (mantissa - 1.0).abs() < 1e-9 && !(-1..=2).contains(&exponent) {
        return format!("10^{{{}}}", minus(exponent));
    }
    if (-3..5).contains(&exponent) {
        return format!("{value:.*}", (-exponent).max(0) as usize);
    }
    format!("{mantissa:.0}·10^{{{}}}", minus(exponent))
}

/// A number with a true minus sign.
fn minus(exponent: i32) -> String {
    exponent.to_string().replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_their_closed_values_and_inverses() {
        assert_eq!(RadialScale::Linear.length(5.0, 10.0), 0.5);
        assert_eq!(RadialScale::CubeRoot.length(0.125, 1.0), 0.5);
        assert!((RadialScale::Log.length(1.0, 100.0) - 0.5).abs() < 1e-15);
        assert_eq!(RadialScale::Log.length(1e-9, 1.0), 0.0);
        for scale in RADIAL_SCALES {
            assert_eq!(scale.length(0.0, 3.0), 0.0);
            assert!((scale.length(3.0, 3.0) - 1.0).abs() < 1e-15);
            for value in [0.01, 0.3, 2.9] {
                assert!((scale.value(scale.length(value, 3.0), 3.0) - value).abs() < 1e-12);
            }
        }
        assert!(
            (RadialScale::CubeRoot.length(0.5, 1.0) - RadialScale::Linear.length(0.5, 1.0)).abs()
                > 0.2
        );
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let labels = |scale: RadialScale, limit: f64| {
            scale
                .ticks(limit)
                .into_iter()
                .map(|tick| tick.label)
                .collect::<Vec<_>>()
                .join(" ")
        };
        assert_eq!(labels(RadialScale::Linear, 1.04), "0.5 1.0");
        assert_eq!(labels(RadialScale::Linear, 33.0), "10 20 30");
        assert_eq!(labels(RadialScale::CubeRoot, 33.0), "1 5 20");
        assert_eq!(labels(RadialScale::Log, 1000.0), "1 10 100 10^{3}");
        for exponent in -6..7 {
            for mantissa in [1.0, 1.7, 3.3, 9.99] {
                let peak = mantissa * 10f64.powi(exponent);
                for scale in RADIAL_SCALES {
                    let limit = scale.limit(peak);
                    let ticks = scale.ticks(limit);
                    assert!(
                        limit >= peak && ticks.len() >= 2,
                        "{scale:?} {peak} {ticks:?}"
                    );
                    assert!(ticks.iter().all(|tick| tick.value <= limit * (1.0 + 1e-9)));
                    assert!(ticks.windows(2).all(|pair| pair[0].value < pair[1].value));
                }
            }
        }
    }

    #[test]
    fn nothing_to_show_still_has_an_axis() {
        for peak in [0.0, f64::NAN, f64::INFINITY] {
            assert!(RadialScale::Linear.limit(peak).is_finite());
        }
    }
}
