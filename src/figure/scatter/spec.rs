//! The spec of the plot of materials: whose fits, by which quantities, between which ends.

use super::quantity::{ERROR, Quantity, QuantityRow};
use crate::brdf::json::model_key;
use crate::brdf::{Brdf, COMBINED, Model};
use serde::{Deserialize, Serialize};

/// The plot of materials on paper: the fits of one model by two of its quantities, in the colours of their series.
///
/// JSON has what differs from the combined model by its first two parameters, so that figures from before there was a choice
/// stay as they are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ScatterSpec {
    /// Ends of the horizontal axis; around all dots without.
    pub window: Option<[f64; 2]>,
    /// Ends of the vertical axis; around all dots, or all possible values, without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y_window: Option<[f64; 2]>,
    /// Model whose fits are shown.
    #[serde(with = "model_key", skip_serializing_if = "is_first")]
    pub model: &'static Model,
    /// Quantity along x; the first parameter of the lobe without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x: Option<Quantity>,
    /// Quantity along y; the second parameter of the lobe, or η, without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<Quantity>,
    /// E of each subject as a share, in their order, where an axis shows it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<f64>,
}

impl Default for ScatterSpec {
    fn default() -> Self {
        Self {
            window: None,
            y_window: None,
            model: &COMBINED,
            x: None,
            y: None,
            errors: Vec::new(),
        }
    }
}

fn is_first(model: &&'static Model) -> bool {
    *model == ScatterSpec::default().model
}

impl ScatterSpec {
    /// Quantities along x and y.
    pub fn quantities(&self) -> [Quantity; 2] {
        let [x, y] = Quantity::first(self.model);
        [self.x.unwrap_or(x), self.y.unwrap_or(y)]
    }

    /// Rows of the quantities along x and y: those that the model has first in place of others.
    pub fn rows(&self) -> [QuantityRow; 2] {
        let [x, y] = self.quantities();
        let first = Quantity::first(self.model);
        [(x, first[0]), (y, first[1])].map(|(wanted, first)| {
            let row = wanted.row(self.model).or_else(|| first.row(self.model));
            row.unwrap_or(ERROR)
        })
    }

    /// Whether an axis shows E.
    pub fn shows_error(&self) -> bool {
        self.quantities().contains(&Quantity::Error)
    }

    /// Values of a model with its E along x and y; `None` where it is neither the shown model nor one that this contains.
    pub fn values(&self, brdf: &Brdf, error: Option<f64>) -> Option<[f64; 2]> {
        let mut shown = *brdf;
        if brdf.model != self.model {
            let contained = self.model.containing(brdf.model)?;
            shown.model = self.model;
            shown.params.lobe = contained.outer(&brdf.params.lobe);
        }
        // What has no value has no place, and keeps its name in the table.
        let value = |quantity: Quantity| quantity.value(&shown, error).unwrap_or(f64::NAN);
        Some(self.quantities().map(value))
    }
}
