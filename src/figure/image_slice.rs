//! The image slice: f_r over θh and θd at one φd, cell by cell of the MERL grid [Burley12].
//!
//! Measured values are shown as they stand in the table, so a cell has one value: at the middle of its θh and θd and at
//! the chosen φd.

mod panel;

use super::cosine::CosineFactor;
use super::heatmap::{
    Cell, ColorScale, Curve, CurveKind, HeatField, HeatSpec, HeatSpot, HeatView, Law, Side,
};
use super::mark::ProbeMark;
use super::scale::RadialScale;
use super::shown::{Shown, ValueRange};
use super::subject::{Channel, Source};
use crate::geom::limits::{UNRELIABLE_THETA, UNRELIABLE_THETA_DEG};
use crate::geom::{HalfDiff, Rgb, degrees};
use crate::measured::Grid;
use crate::measured::grid::{THETA_D_BINS, THETA_H_BINS};
use serde::{Deserialize, Serialize};

/// Settings of an image slice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ImageSpec {
    /// Data, model or their difference.
    pub shown: Shown,
    /// φd in radians.
    #[serde(with = "degrees")]
    pub phi_d: f64,
    /// Whether θh is spread by its square root, so that all cells are of one size.
    pub root: bool,
    /// Law from values to colours; ratios are always by their logarithm.
    pub scale: RadialScale,
    /// Colour channel that is shown.
    pub channel: Channel,
    /// Cosines that f_r is multiplied by.
    #[serde(rename = "with_cosine")]
    pub cosine: CosineFactor,
    /// The ends of the colours of data and model, in 1/sr; from the data without.
    pub limits: Option<[f64; 2]>,
    /// The part in sight.
    pub view: HeatView,
    /// θh and θd of the probe in degrees.
    #[serde(skip)]
    pub probe: Option<ProbeMark<[f64; 2]>>,
}

impl Default for ImageSpec {
    fn default() -> Self {
        Self {
            shown: Shown::Measured,
            phi_d: std::f64::consts::FRAC_PI_2,
            root: true,
            scale: RadialScale::Log,
            channel: Channel::Luminance,
            cosine: CosineFactor::NONE,
            limits: None,
            view: HeatView::default(),
            probe: None,
        }
    }
}

/// f_r of half and difference angles; the cell as it is in the table for what was measured.
fn f_r(source: &Source, angles: HalfDiff) -> Option<Rgb> {
    match source {
        Source::Measured(table, lookup) => table.lookup_angles(angles, *lookup),
        Source::Model(brdf) => Some(brdf.eval(&angles.cosines())),
        Source::Function(function) => {
            let (wi, wo) = angles.to_directions();
            function(wi, wo)
        }
    }
}

impl ImageSpec {
    /// The angles that a cell of the picture stands for: the middle of its bins of θh and θd, at φd.
    pub fn angles(&self, theta_h: usize, theta_d: usize) -> HalfDiff {
        HalfDiff {
            phi_d: self.phi_d,
            ..Grid::FOLDED.center(theta_h, theta_d, 0)
        }
    }

    /// Cell at some angles: its value, or that it has none.
    pub fn cell(
        &self,
        measured: Option<&Source>,
        model: Option<&Source>,
        angles: HalfDiff,
    ) -> Cell {
        let cosines = angles.cosines();
        if !cosines.above_horizon() {
            return Cell::Outside;
        }
        let cosine = self.cosine.of(cosines.cos_theta_i, cosines.cos_theta_o);
        let of = |source: Option<&Source>| {
            let value = cosine * self.channel.of(f_r(source?, angles)?);
            value.is_finite().then_some(value)
        };
        let value = self.shown.value(|| of(measured), || of(model));
        value.map_or(Cell::Missing, Cell::Value)
    }

    /// All cells. Axes in degrees.
    pub fn field(&self, measured: Option<&Source>, model: Option<&Source>) -> HeatField {
        let root = |k: usize| (k as f64 / THETA_H_BINS as f64).powi(2) * 90.0;
        HeatField::new(
            (0..=THETA_H_BINS).map(root).collect(),
            (0..=THETA_D_BINS).map(|k| k as f64).collect(),
            |theta_h, theta_d| self.cell(measured, model, self.angles(theta_h, theta_d)),
        )
    }

    /// All cells, and those that their colours are made for: the data's where the model is shown over data, so that both
    /// have the same colours; else the cells themselves.
    pub fn fields(
        &self,
        measured: Option<&Source>,
        model: Option<&Source>,
    ) -> (HeatField, HeatField) {
        let field = self.field(measured, model);
        let reference = match (self.shown, measured) {
            (Shown::Model, Some(_)) => {
                let of_data = Self {
                    shown: Shown::Measured,
                    ..self.clone()
                };
                of_data.field(measured, None)
            }
            _ => field.clone(),
        };
        (field, reference)
    }

    /// Spec of the heat map that shows `field`. `reference` has the values that the colours are made for: the data's, so
    /// that data and model have the same colours.
    pub fn heat_spec(&self, name: &str, field: &HeatField, reference: &HeatField) -> HeatSpec {
        let what = format!("f_{{r}}{}", self.cosine.markup());
        let channel = self.channel.name();
        // A ratio has no unit.
        let unit = match self.shown {
            Shown::Measured | Shown::Model | Shown::Residual => " [sr^{−1}]",
            Shown::Ratio => "",
        };
        let degrees = (10.0 * self.phi_d.to_degrees()).round() / 10.0;
        let phrase = self.shown.phrase();
        let law = if self.root {
            Law::SquareRoot
        } else {
            Law::Linear
        };
        HeatSpec {
            title: vec![
                format!("{name}, {phrase}: {what}{unit}, {channel}, φ_{{d}} = {degrees}°"),
                format!("{name}, {phrase}, {channel}, φ_{{d}} = {degrees}°"),
                format!("{name}, {phrase}, φ_{{d}} = {degrees}°"),
                format!("{phrase}, φ_{{d}} = {degrees}°"),
            ],
            x: Side::angle(
                if self.root {
                    "θ_{h}, square root scale"
                } else {
                    "θ_{h}"
                },
                law,
            ),
            y: Side::angle("θ_{d}", Law::Linear),
            view: self.view,
            colors: self.colors(field, reference),
            bar_title: self.shown.bar_title(self.cosine, self.channel, self.scale),
            missing: "not measured",
            smooth: false,
            square: false,
            curves: vec![Curve {
                points: self.grazing(UNRELIABLE_THETA),
                kind: CurveKind::Limit,
                label: Some(format!("{UNRELIABLE_THETA_DEG}°")),
            }],
            spots: self.probe.map(HeatSpot::Probe).into_iter().collect(),
            nothing: "No value at this φd.",
        }
    }

    fn colors(&self, field: &HeatField, reference: &HeatField) -> ColorScale {
        let limits = self.limits.filter(|_| self.shown.is_amount());
        let range = |field: &HeatField| ValueRange::of(self.shown, field.values());
        let [values, reference] = [field, reference].map(range);
        self.shown.colors(self.scale, limits, &values, &reference)
    }

    /// Line on which the more grazing one of light and view is at the angle `theta`, in degrees of (θh, θd):
    /// cos θh cos θd − sin θh sin θd |cos φd| = cos.
    fn grazing(&self, theta: f64) -> Vec<[f64; 2]> {
        let across = self.phi_d.cos().abs();
        // Closer towards θh = 0, where it runs level and the square root spreads it.
        let of = |k: i32| {
            let theta_d = theta * (1.0 - (f64::from(k) / 180.0).powi(2));
            let (a, b) = (theta_d.cos(), theta_d.sin() * across);
            let share = theta.cos() / a.hypot(b);
            let theta_h = share.min(1.0).acos() - b.atan2(a);
            let theta_h = theta_h.max(0.0);
            [theta_h.to_degrees(), theta_d.to_degrees()]
        };
        (0..=180).map(of).collect()
    }
}

#[cfg(test)]
mod tests;
