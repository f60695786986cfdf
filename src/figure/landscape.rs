//! The best E over (s, α) as colours with lines of equal E, the way of a fit over it, and where the sliders stand.

mod panel;
pub mod terrain;

pub use panel::LandscapePanel;
pub use terrain::Terrain;

use super::contour::contours;
use super::heatmap::{ColorScale, Curve, CurveKind, HeatSpec, HeatSpot, HeatView, Law, Side};
use super::scale::{number, whole};
use crate::brdf::{COMBINED, Param};

/// Settings of a landscape besides its terrain.
#[derive(Clone, Debug, PartialEq)]
pub struct LandscapeSpec {
    /// Words for η in the title, such as "η = 1.5", in the markup of [`super::text`].
    pub eta: String,
    /// The part in sight.
    pub view: HeatView,
    /// (s, α) of a fit, from its start to its end.
    pub path: Vec<[f64; 2]>,
    /// (s, α) at which the sliders stand.
    pub here: Option<[f64; 2]>,
    /// (s, α) of the best model and its E in percent, on all cells.
    pub best: Option<([f64; 2], f64)>,
}

/// Rows of the parameters along x and y: those of the combined model.
pub fn axes() -> [&'static Param; 2] {
    [&COMBINED.params[0], &COMBINED.params[1]]
}

/// Title of the vertical axis: the symbol, and the models at its ends.
fn y_title(row: &Param) -> String {
    let ends = COMBINED.contains.iter().filter_map(|inner| {
        let value = inner.fixed.first()?;
        Some(format!("{} {}", number(*value), inner.model.name))
    });
    let ends: Vec<String> = ends.collect();
    format!("{} ({})", row.symbol, ends.join(", "))
}

/// E of the lines, relative to the smallest one.
const LEVELS: [f64; 9] = [1.02, 1.05, 1.1, 1.2, 1.4, 1.7, 2.5, 5.0, 10.0];
/// The largest E that has a colour of its own, relative to the smallest one.
const WORST: f64 = 20.0;

/// Lines of equal E.
fn contour_lines(terrain: &Terrain) -> Vec<Curve> {
    let Some((low, high)) = terrain.ends() else {
        return Vec::new();
    };
    let ln_s: Vec<f64> = terrain.s.iter().map(|s| s.ln()).collect();
    let mut curves = Vec::new();
    for factor in LEVELS.iter().filter(|factor| low * **factor < high) {
        let level = low * factor;
        for line in contours(&ln_s, &terrain.alpha, &terrain.percent, level) {
            curves.push(Curve {
                points: line.into_iter().map(|[x, y]| [x.exp(), y]).collect(),
                kind: CurveKind::Contour,
                label: Some(format!("{} %", number(rounded(level)))),
            });
        }
    }
    curves
}

/// Three digits.
fn rounded(value: f64) -> f64 {
    let unit = 10f64.powi(whole(value.abs().log10().floor()) - 2);
    (value / unit).round() * unit
}

impl LandscapeSpec {
    /// Spec of the heat map that shows a terrain.
    pub fn heat_spec(&self, name: &str, terrain: &Terrain) -> HeatSpec {
        let (low, high) = terrain.ends().unwrap_or((1.0, 10.0));
        let ends = |axis: &[f64], missing: (f64, f64)| match axis {
            [first, .., last] => (*first, *last),
            _ => missing,
        };
        let [x, y] = axes();
        let best = match self.best {
            Some((_, percent)) => format!("least {} %", number(rounded(percent))),
            None => "in the making".to_string(),
        };
        let mut curves = contour_lines(terrain);
        if self.path.len() > 1 {
            curves.push(Curve {
                points: self.path.clone(),
                kind: CurveKind::Path,
                label: None,
            });
        }
        let mut spots: Vec<HeatSpot> = Vec::new();
        spots.extend(self.path.first().map(|at| HeatSpot::Start(*at)));
        spots.extend(self.best.map(|(at, _)| HeatSpot::Best(at)));
        spots.extend(self.here.map(HeatSpot::Here));
        HeatSpec {
            title: vec![
                format!(
                    "{name}: best E with ρ_{{d}}, k_{{s}} solved, {}; {best}",
                    self.eta
                ),
                format!("Best E with ρ_{{d}}, k_{{s}} solved, {}; {best}", self.eta),
                format!("Best E, {}; {best}", self.eta),
                format!("Best E; {best}"),
            ],
            x: Side {
                title: x.symbol.into(),
                law: Law::Log,
                range: ends(&terrain.s, (0.1, 1e5)),
                degrees: false,
            },
            y: Side {
                title: y_title(y),
                law: Law::Linear,
                range: ends(&terrain.alpha, y.range),
                degrees: false,
            },
            view: self.view,
            colors: ColorScale::Between(low, high.min(WORST * low).max(1.01 * low)),
            bar_title: "E, estimate [%], log".into(),
            missing: "",
            smooth: true,
            square: false,
            curves,
            spots,
            nothing: "In the making.",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A valley in ln s, tilted in α.
    fn terrain() -> Terrain {
        let s: Vec<f64> = (0..17)
            .map(|k| 10f64.powf(-1.0 + f64::from(k) * 6.0 / 16.0))
            .collect();
        let alpha: Vec<f64> = (0..9).map(|k| f64::from(k) / 8.0).collect();
        let percent = alpha
            .iter()
            .flat_map(|alpha| s.iter().map(move |s| value(*s, *alpha)))
            .collect();
        Terrain { s, alpha, percent }
    }

    fn value(s: f64, alpha: f64) -> f64 {
        5.0 + 3.0 * (s.ln() - 4.0).abs() + 2.0 * alpha
    }

    #[test]
    fn cells_have_the_values_between_the_nodes() {
        let field = terrain().field();
        assert_eq!((field.columns(), field.rows()), (64, 32));
        for (column, row) in [(3, 4), (20, 0), (63, 31)] {
            let s = (field.x[column] * field.x[column + 1]).sqrt();
            let alpha = 0.5 * (field.y[row] + field.y[row + 1]);
            let found = field.cell(column, row).value().expect("a value");
            assert!((found - value(s, alpha)).abs() < 1e-9, "{column} {row}");
            // Planted: a cell further on.
            assert!((found - value(1.1 * s, alpha)).abs() > 0.1);
        }
        let broken = Terrain {
            percent: vec![1.0],
            ..terrain()
        };
        assert_eq!(broken.field(), crate::figure::heatmap::HeatField::default());
    }

    #[test]
    fn contours_are_where_they_say() {
        let curves = contour_lines(&terrain());
        assert!(!curves.is_empty());
        for curve in &curves {
            let label = curve.label.as_deref().expect("a label");
            let percent: f64 = label.trim_end_matches(" %").parse().expect("a number");
            for [s, alpha] in &curve.points {
                // The bend of the valley is between two nodes.
                if (s.ln() - 4.0).abs() > 0.9 {
                    assert!(
                        (value(*s, *alpha) / percent - 1.0).abs() < 0.01,
                        "{label} {s}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_flat_or_missing_terrain_is_drawn_too() {
        let spec = LandscapeSpec {
            eta: "η = 1.5".into(),
            view: HeatView::default(),
            path: vec![[1.0, 0.5], [1e9, 2.0]],
            here: Some([50.0, 0.5]),
            best: None,
        };
        let flat = Terrain {
            percent: vec![3.0; 17 * 9],
            ..terrain()
        };
        let none = Terrain {
            s: Vec::new(),
            alpha: Vec::new(),
            percent: Vec::new(),
        };
        for terrain in [flat, none] {
            let heat = spec.heat_spec("x", &terrain);
            let map = crate::figure::heatmap::HeatMap::new(&heat, &terrain.field(), [300.0, 200.0]);
            assert!(!map.drawing.items.is_empty());
        }
    }
}
