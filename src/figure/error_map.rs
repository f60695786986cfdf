//! Error map, as colours: shares of E over the directions, or over θh and θd.

mod panel;

pub use panel::ErrorMapSpec;

use super::heatmap::{Cell, ColorScale, HeatField, HeatSpec, HeatSpot, HeatView, Law, Side};
use super::scale::{Axis, RadialScale, nice_limit, number};
use crate::geom::Rgb;
use serde::{Deserialize, Serialize};

/// The axes of an error map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Plane {
    /// θi to the right, θo upwards.
    #[default]
    Directions,
    /// θh to the right, θd upwards.
    HalfDiff,
}

/// Settings of an error map.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorSpec {
    /// Axes of the map.
    pub plane: Plane,
    /// Law from shares to colours.
    pub scale: RadialScale,
    /// The part in sight.
    pub view: HeatView,
    /// E over all.
    pub total: f64,
    /// E per channel.
    pub channels: Rgb,
    /// The marks of the probe.
    pub spots: Vec<HeatSpot>,
}

impl ErrorSpec {
    /// The shares of E as percent in cells. `parts` of E are in rows from the smallest angle upwards, `columns` in
    /// each; `None` where no cell counts. They are even in degrees, or the bins of the grid.
    pub fn field(&self, parts: &[Option<f64>], columns: usize) -> HeatField {
        let rows = parts.len().checked_div(columns).unwrap_or(0);
        let even = |count: usize| -> Vec<f64> {
            (0..=count)
                .map(|k| 90.0 * k as f64 / count as f64)
                .collect()
        };
        let root = |count: usize| -> Vec<f64> {
            (0..=count)
                .map(|k| 90.0 * (k as f64 / count as f64).powi(2))
                .collect()
        };
        let x = match self.plane {
            Plane::Directions => even(columns),
            Plane::HalfDiff => root(columns),
        };
        let percent = 100.0 / self.total.max(f64::MIN_POSITIVE);
        HeatField::new(x, even(rows), |column, row| {
            match parts.get(column + columns * row) {
                Some(Some(part)) => Cell::Value(percent * part),
                _ => Cell::Outside,
            }
        })
    }

    /// Spec of the heat map that shows `field`.
    pub fn heat_spec(&self, name: &str, field: &HeatField) -> HeatSpec {
        let percent = |error: f64| format!("{:.2} %", 100.0 * error);
        let channel = |k: usize| {
            if self.channels[k].is_finite() {
                format!("{:.2}", 100.0 * self.channels[k])
            } else {
                "–".to_string()
            }
        };
        let total = percent(self.total);
        let channels = format!("R {}, G {}, B {}", channel(0), channel(1), channel(2));
        let (x, y, bin) = match self.plane {
            Plane::Directions => {
                let side = |title| Side::angle(title, Law::Linear);
                (side("θ_{i}"), side("θ_{o}"), bin_size(field))
            }
            Plane::HalfDiff => (
                Side::angle("θ_{h}, square root scale", Law::SquareRoot),
                Side::angle("θ_{d}", Law::Linear),
                "cell of θ_{h}, θ_{d}".to_string(),
            ),
        };
        let largest = field.values().fold(0.0, f64::max);
        let limit = nice_limit(largest);
        HeatSpec {
            title: vec![
                format!("{name}: E = {total} ({channels})"),
                format!("E = {total} ({channels})"),
                format!("E = {total}"),
            ],
            x,
            y,
            view: self.view,
            // Four decades: what is less does not matter.
            colors: ColorScale::Amount(Axis::new(self.scale, limit, Some(1e-4 * limit))),
            bar_title: format!("share of E per {bin} [%], {}", self.scale.phrase()),
            missing: "",
            smooth: false,
            square: self.plane == Plane::Directions,
            curves: Vec::new(),
            spots: self.spots.clone(),
            nothing: "No cell counts.",
        }
    }
}

fn bin_size(field: &HeatField) -> String {
    let degrees = number(90.0 / field.columns().max(1) as f64);
    format!("{degrees}° × {degrees}°")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spec(plane: Plane) -> ErrorSpec {
        ErrorSpec {
            plane,
            scale: RadialScale::Log,
            view: HeatView::default(),
            total: 0.25,
            channels: [0.2, 0.3, f64::NAN],
            spots: Vec::new(),
        }
    }

    #[test]
    fn shares_add_up_to_a_hundred_percent() {
        let parts: Vec<Option<f64>> = (0..16)
            .map(|k| (k % 5 != 4).then_some(0.25 / 13.0))
            .collect();
        for plane in [Plane::Directions, Plane::HalfDiff] {
            let field = spec(plane).field(&parts, 4);
            assert!((field.values().sum::<f64>() - 100.0).abs() < 1e-9);
            assert_eq!(field.cell(0, 1), Cell::Outside);
            assert_eq!(field.x[4], 90.0);
            assert_eq!(field.y[1], 22.5);
        }
        assert_eq!(spec(Plane::HalfDiff).field(&parts, 4).x[1], 90.0 / 16.0);
        // Planted: another total.
        let wrong = ErrorSpec {
            total: 0.2,
            ..spec(Plane::Directions)
        };
        assert!(wrong.field(&parts, 4).values().sum::<f64>() > 120.0);
    }

    #[test]
    fn the_title_has_the_error_and_its_channels() {
        let spec = spec(Plane::Directions);
        let heat = spec.heat_spec("Nickel", &spec.field(&[Some(0.25)], 1));
        assert_eq!(heat.title[0], "Nickel: E = 25.00 % (R 20.00, G 30.00, B –)");
        assert!(heat.bar_title.contains("90° × 90°"));
    }
}
