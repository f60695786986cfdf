//! Colour scale: from values to places on a colour map, and the ticks of the colour bar.

use crate::figure::colormap::ColorMap;
use crate::figure::scale::{Axis, RadialScale, Tick, number, whole};
use crate::figure::text::RichText;

/// Law from values to places on a colour map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColorScale {
    /// Amounts from 0, or from a floor, on.
    Amount(Axis),
    /// Differences: the axis on both sides of the middle. On a logarithmic one what is below the floor is the middle.
    Signed(Axis),
    /// Ratios, by their logarithm: 1 in the middle, this factor at one end and its inverse at the other.
    Ratio(f64),
    /// Amounts above 0 by their logarithm between two values, the small ones bright.
    Between(f64, f64),
}

impl ColorScale {
    /// Colour map of the scale.
    pub fn map(&self) -> ColorMap {
        match self {
            Self::Amount(_) => ColorMap::Sequential,
            Self::Signed(_) | Self::Ratio(_) => ColorMap::Diverging,
            Self::Between(..) => ColorMap::Reversed,
        }
    }

    /// The place of a value on the map, from 0 to 1; values beyond the ends are at these.
    pub fn position(&self, value: f64) -> f64 {
        let position = match self {
            Self::Amount(axis) => axis.position(value),
            Self::Signed(axis) => 0.5 + 0.5 * axis.position(value.abs()).copysign(value),
            Self::Ratio(factor) => 0.5 + 0.5 * value.max(0.0).ln() / factor.ln(),
            Self::Between(low, high) => (value / low).ln() / (high / low).ln(),
        };
        position.clamp(0.0, 1.0)
    }

    /// Axis of amounts, which several pictures can share; `None` for differences and ratios.
    pub fn amount_axis(&self) -> Option<Axis> {
        match self {
            Self::Amount(axis) => Some(*axis),
            Self::Signed(_) | Self::Ratio(_) | Self::Between(..) => None,
        }
    }

    /// About `count` ticks with their places on the map.
    pub fn ticks(&self, count: usize) -> Vec<Tick> {
        match self {
            Self::Amount(axis) => axis.ticks(count),
            Self::Signed(axis) => signed_ticks(axis, (count / 2).max(1)),
            Self::Ratio(factor) => self.ratio_ticks(*factor, count),
            Self::Between(low, high) => self.between_ticks(*low, *high, count),
        }
    }

    fn ratio_ticks(&self, factor: f64, count: usize) -> Vec<Tick> {
        let base: f64 = if factor > 40.0 { 10.0 } else { 2.0 };
        let most = whole((factor.ln() / base.ln() + 1e-9).floor());
        let step = ((2 * most + 1) as usize).div_ceil(count.max(3)).max(1);
        // From the middle outwards, so that 1 is always there.
        (0..=most)
            .step_by(step)
            .flat_map(|k| [-k, k])
            .collect::<std::collections::BTreeSet<i32>>()
            .into_iter()
            .map(|k| self.tick(base.powi(k)))
            .collect()
    }

    fn between_ticks(&self, low: f64, high: f64, count: usize) -> Vec<Tick> {
        let gap = 0.7 / count.max(1) as f64;
        let (first, last) = (whole(low.log10().floor()), whole(high.log10().ceil()));
        let mut kept: Vec<Tick> = Vec::new();
        let digits: [&[f64]; 4] = [&[1.0], &[2.0, 5.0], &[3.0, 7.0], &[1.5, 2.5, 4.0, 6.0, 8.0]];
        for class in digits {
            for exponent in first..=last {
                for digit in class {
                    let value = digit * 10f64.powi(exponent);
                    let tick = self.tick(value);
                    let far = |other: &Tick| (other.position - tick.position).abs() >= gap;
                    if (low..=high).contains(&value) && kept.iter().all(far) {
                        kept.push(tick);
                    }
                }
            }
        }
        kept.sort_by(|a, b| a.position.total_cmp(&b.position));
        kept
    }

    fn tick(&self, value: f64) -> Tick {
        Tick {
            value,
            position: self.position(value),
            label: RichText::parse(&number((1e9 * value).round() / 1e9)),
        }
    }
}

/// Ticks of both halves of a signed scale, with its middle.
fn signed_ticks(axis: &Axis, count: usize) -> Vec<Tick> {
    let half = axis.ticks(count);
    let middle = match axis.scale {
        RadialScale::Log => RichText::parse(&format!("±{}", number(axis.floor))),
        RadialScale::Linear | RadialScale::CubeRoot => RichText::literal("0"),
    };
    let mut ticks: Vec<Tick> = half
        .iter()
        .rev()
        .map(|tick| {
            let mut label = tick.label.clone();
            if let Some(first) = label.runs.first_mut() {
                first.text.insert(0, '−');
            }
            Tick {
                value: -tick.value,
                position: 0.5 - 0.5 * tick.position,
                label,
            }
        })
        .collect();
    ticks.push(Tick {
        value: 0.0,
        position: 0.5,
        label: middle,
    });
    ticks.extend(half.into_iter().map(|tick| Tick {
        position: 0.5 + 0.5 * tick.position,
        ..tick
    }));
    ticks
}
