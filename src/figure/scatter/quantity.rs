//! Quantities along the axes of the plot of materials: the parameters of a model, and E.

use crate::brdf::params::Scale;
use crate::brdf::{Brdf, Model, Param, ParamId, all_params};
use crate::figure::scale::{Axis, RadialScale};
use crate::geom::color::luminance;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A quantity along an axis. JSON: the key of the parameter, or `error`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A parameter; of a colour the luminance.
    Param(ParamId),
    /// E of the fit in percent.
    Error,
}

/// Words and numbers of a quantity of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuantityRow {
    /// Symbol, in the markup of [`crate::figure::text`].
    pub symbol: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Unit; empty where there is none.
    pub unit: &'static str,
    /// Column of the numbers.
    pub column: &'static str,
    /// Law from values to lengths.
    pub scale: RadialScale,
    /// Usual values, (smallest, largest); above 0 on a logarithmic axis.
    range: (f64, f64),
    /// Possible values, (smallest, largest).
    domain: (f64, f64),
}

/// Row of E.
pub(super) const ERROR: QuantityRow = QuantityRow {
    symbol: "E",
    name: "error of the fit",
    unit: "%",
    column: "percent_e",
    scale: RadialScale::Log,
    range: (0.1, 100.0),
    domain: (0.0, f64::INFINITY),
};

/// Fewest decades of a logarithmic axis, and those of one without values.
const DECADES: (f64, f64) = (2.0, 3.0);
/// Ends of a logarithmic axis closer than this factor show nothing more.
const CLOSEST: f64 = 1.05;
/// Ends of a linear axis closer than this share of the usual values show nothing more.
const NARROWEST: f64 = 1e-3;
/// Room beyond an interval that has all possible values, as a share of it.
const ROOM: f64 = 0.1;

impl Quantity {
    /// Quantities of a model in the order offered.
    pub fn all(model: &Model) -> Vec<Self> {
        let rows = model.rows().map(|row| Self::Param(row.id));
        rows.chain([Self::Error]).collect()
    }

    /// Quantities along x and y where none are chosen: the first two parameters of the lobe, η in place of a second.
    pub fn first(model: &Model) -> [Self; 2] {
        let param = |k: usize, other| Self::Param(model.params.get(k).map_or(other, |row| row.id));
        [param(0, ParamId::K_S), param(1, ParamId::ETA)]
    }

    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Param(id) => id.key(),
            Self::Error => "error",
        }
    }

    /// The row; `None` where the model does not have the quantity.
    pub fn row(self, model: &Model) -> Option<QuantityRow> {
        match self {
            Self::Param(id) => model.param(id).map(QuantityRow::of),
            Self::Error => Some(ERROR),
        }
    }

    /// Value of a model with its E, as a share; `None` where there is none.
    pub fn value(self, brdf: &Brdf, error: Option<f64>) -> Option<f64> {
        match self {
            Self::Param(id) => match brdf.get(id) {
                [one] => Some(*one),
                [r, g, b] => Some(luminance([*r, *g, *b])),
                _ => None,
            },
            Self::Error => error.map(|error| 100.0 * error),
        }
    }
}

impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.key())
    }
}

impl<'de> Deserialize<'de> for Quantity {
    /// Any parameter is read; whether the model has it is looked at with the model.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let key = String::deserialize(deserializer)?;
        let mut known: Vec<Self> = all_params().map(|row| Self::Param(row.id)).collect();
        known.push(Self::Error);
        let found = known.iter().find(|quantity| quantity.key() == key);
        found.copied().ok_or_else(|| {
            let keys: Vec<String> = known.iter().map(|one| format!("`{}`", one.key())).collect();
            serde::de::Error::custom(format!(
                "unknown variant `{key}`, expected one of {}",
                keys.join(", ")
            ))
        })
    }
}

impl QuantityRow {
    fn of(row: &'static Param) -> Self {
        let (low, high) = row.range;
        let (scale, low) = match row.scale {
            Scale::Linear => (RadialScale::Linear, low),
            Scale::Log { smallest_exponent } if low <= 0.0 => {
                (RadialScale::Log, 10f64.powi(smallest_exponent))
            }
            Scale::Log { .. } => (RadialScale::Log, low),
        };
        Self {
            symbol: row.symbol,
            name: row.name,
            unit: row.unit,
            column: row.key(),
            scale,
            range: (low, high),
            domain: row.domain,
        }
    }

    /// Symbol with its unit.
    pub fn label(&self) -> String {
        if self.unit.is_empty() {
            self.symbol.into()
        } else {
            format!("{} [{}]", self.symbol, self.unit)
        }
    }

    /// Ends of an interval that has all possible values, with room beyond; `None` where there is no such interval.
    fn closed(&self) -> Option<[f64; 2]> {
        let (low, high) = self.range;
        let room = ROOM * (high - low);
        (self.scale != RadialScale::Log && self.range == self.domain)
            .then_some([low - room, high + room])
    }

    /// The axis between `ends`, or around all values.
    pub fn axis(&self, ends: Option<[f64; 2]>, values: impl Iterator<Item = f64>) -> Axis {
        let ends = ends.or_else(|| self.closed());
        let [low, high] = ends.unwrap_or_else(|| self.around(values));
        Axis::between(self.scale, low, high)
    }

    /// Ends with some room beyond all values.
    fn around(&self, values: impl Iterator<Item = f64>) -> [f64; 2] {
        let log = self.scale == RadialScale::Log;
        let bent = |value: f64| if log { value.log10() } else { value };
        let (low, high) = values
            .map(bent)
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        let (first, last) = (bent(self.range.0), bent(self.range.1));
        let unit = if log { 1.0 } else { last - first };
        let (low, high, half) = if low > high {
            let half = 0.5 * if log { DECADES.1 } else { unit };
            (first, last, half)
        } else {
            let least = if log { 0.5 * DECADES.0 } else { 0.05 * unit };
            let half = (0.5 * (high - low) * 1.12 + if log { 0.1 } else { 0.01 * unit }).max(least);
            (low, high, half)
        };
        let middle = 0.5 * (low + high);
        [middle - half, middle + half].map(|end| if log { 10f64.powf(end) } else { end })
    }

    /// Farthest ends of an axis: what is beyond them is no value.
    fn limits(&self) -> [f64; 2] {
        let (low, high) = self.range;
        match (self.scale, self.closed()) {
            (RadialScale::Log, _) => [low / 100.0, high * 1e3],
            (_, Some(closed)) => closed,
            _ => {
                let room = high - low;
                [self.domain.0 - room, self.domain.1 + room]
            }
        }
    }

    /// Whether an axis can have these ends.
    pub fn are_ends(&self, [low, high]: [f64; 2]) -> bool {
        let [first, last] = self.limits();
        let apart = if self.scale == RadialScale::Log {
            high >= CLOSEST * low
        } else {
            high - low >= NARROWEST * (self.range.1 - self.range.0)
        };
        low >= first && high <= last && apart
    }

    /// Ends that [`QuantityRow::are_ends`] takes, in words.
    pub fn expected_ends(&self) -> String {
        let [low, high] = self.limits();
        let apart = if self.scale == RadialScale::Log {
            format!("at least {CLOSEST} times the first")
        } else {
            let least = NARROWEST * (self.range.1 - self.range.0);
            format!("larger by at least {least}")
        };
        format!("two values from {low:?} to {high:?}, the second {apart}, or null")
    }

    /// Ends after a gesture that asks for `ends`, moved inside an interval that has all possible values; `now` where they
    /// cannot be shown.
    pub fn moved(&self, now: Option<[f64; 2]>, ends: [f64; 2]) -> Option<[f64; 2]> {
        let ends = match self.closed() {
            None => ends,
            Some([first, last]) => {
                let width = ends[1] - ends[0];
                if width >= (last - first) * (1.0 - 1e-6) {
                    return None;
                }
                let low = ends[0].clamp(first, (last - width).max(first));
                [low, (low + width).min(last)]
            }
        };
        if self.are_ends(ends) { Some(ends) } else { now }
    }
}
