//! Data and model in one picture: either of them, their difference or their ratio, and the colours for it.

use super::cosine::CosineFactor;
use super::heatmap::ColorScale;
use super::scale::{Axis, RadialScale, nice_limit};
use super::subject::Channel;
use crate::keys;
use serde::{Deserialize, Serialize};

/// The part of a pair of data and model that a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shown {
    /// The data.
    #[default]
    Measured,
    /// The model, wherever light and view are above the horizon.
    Model,
    /// Model − measured.
    Residual,
    /// Model over measured.
    Ratio,
}

/// Quantities in the order offered.
pub const SHOWN: [Shown; 4] = [Shown::Measured, Shown::Model, Shown::Residual, Shown::Ratio];

impl Shown {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Measured => "Measured",
            Self::Model => "Model",
            Self::Residual => "Residual",
            Self::Ratio => "Ratio",
        }
    }

    /// One sentence for a tooltip.
    pub fn help(self) -> &'static str {
        match self {
            Self::Measured => "The data",
            Self::Model => "The model, with the colours of the data",
            Self::Residual => "Model − measured: blue where the model is too dark",
            Self::Ratio => "Model / measured: blue where the model is too dark",
        }
    }

    /// Words for the quantity in a title.
    pub fn phrase(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::Model => "model",
            Self::Residual => "model − measured",
            Self::Ratio => "model / measured",
        }
    }

    /// Whether it is f_r itself, which has no negative values and may share an axis.
    pub fn is_amount(self) -> bool {
        matches!(self, Self::Measured | Self::Model)
    }

    /// The quantity as it stands in a table.
    pub fn quantity(self, cosine: CosineFactor) -> &'static str {
        if self.is_amount() {
            cosine.quantity()
        } else {
            self.phrase()
        }
    }

    /// The value from those of data and model; `None` where one that it takes is missing, and for a ratio to nothing.
    pub fn value(
        self,
        measured: impl FnOnce() -> Option<f64>,
        model: impl FnOnce() -> Option<f64>,
    ) -> Option<f64> {
        match self {
            Self::Measured => measured(),
            Self::Model => model(),
            Self::Residual => measured().zip(model()).map(|(data, model)| model - data),
            Self::Ratio => measured()
                .filter(|data| *data > 0.0)
                .zip(model())
                .map(|(data, model)| model / data),
        }
    }

    /// The title of the colour bar, in the markup of [`super::text`].
    pub fn bar_title(self, cosine: CosineFactor, channel: Channel, scale: RadialScale) -> String {
        let what = format!("f_{{r}}{}", cosine.markup());
        let (channel, scale) = (channel.name(), scale.phrase());
        match self {
            Self::Measured | Self::Model => {
                format!("{what} [sr^{{−1}}], {channel}, {scale}")
            }
            Self::Residual => format!("Δ{what} [sr^{{−1}}], {channel}, {scale}"),
            // A ratio has no unit.
            Self::Ratio => format!("ratio of {what}, {channel}, log"),
        }
    }

    /// The colours of `values`. `reference` has those that the colours of data and model are made for: the data's, so
    /// that both have the same colours. `limits` are the smallest and the largest amount; of a difference the second
    /// is the largest either way, of a ratio the largest factor.
    pub fn colors(
        self,
        scale: RadialScale,
        limits: Option<[f64; 2]>,
        values: &ValueRange,
        reference: &ValueRange,
    ) -> ColorScale {
        match (self, limits) {
            (Self::Measured | Self::Model, Some([low, high])) => {
                ColorScale::Amount(Axis::between(scale, low, high))
            }
            (Self::Measured | Self::Model, None) => ColorScale::Amount(Axis::new(
                scale,
                nice_limit(reference.largest),
                reference.smallest_positive,
            )),
            (Self::Residual, limits) => {
                let limit =
                    limits.map_or_else(|| nice_limit(values.largest_magnitude), |ends| ends[1]);
                // Four decades on each side.
                ColorScale::Signed(Axis::new(scale, limit, Some(1e-4 * limit)))
            }
            (Self::Ratio, limits) => {
                let factor = limits.map_or_else(|| values.octaves.exp2(), |ends| ends[1]);
                ColorScale::Ratio(factor.max(1.001))
            }
        }
    }
}

/// The ends of some values, as colours need them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ValueRange {
    /// The largest value, at least 0.
    pub largest: f64,
    /// The smallest one above 0.
    pub smallest_positive: Option<f64>,
    /// The largest distance from 0.
    pub largest_magnitude: f64,
    /// Number of doublings or halvings that nearly all ratios are within, from 1 to 10; 1 for what is no ratio.
    pub octaves: f64,
}

impl ValueRange {
    /// The ends of values that are shown as `shown`.
    pub fn of(shown: Shown, values: impl Iterator<Item = f64> + Clone) -> Self {
        let positive = values.clone().filter(|value| *value > 0.0);
        Self {
            largest: values.clone().fold(0.0, f64::max),
            smallest_positive: positive.min_by(f64::total_cmp),
            largest_magnitude: values.clone().map(f64::abs).fold(0.0, f64::max),
            octaves: match shown {
                Shown::Ratio => octaves(values),
                Shown::Measured | Shown::Model | Shown::Residual => 1.0,
            },
        }
    }
}

fn octaves(ratios: impl Iterator<Item = f64>) -> f64 {
    let mut logs: Vec<f64> = ratios
        .map(|ratio| ratio.ln().abs())
        .filter(|log| log.is_finite())
        .collect();
    // A few at the horizon would leave the others grey.
    let at = logs.len() * 98 / 100;
    let most = if logs.is_empty() {
        0.0
    } else {
        *logs.select_nth_unstable_by(at, f64::total_cmp).1
    };
    (most / std::f64::consts::LN_2).ceil().clamp(1.0, 10.0)
}
