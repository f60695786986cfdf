//! The least E over a grid of s and α.

use crate::figure::heatmap::{Cell, HeatField};

/// E in percent at the nodes of a grid over s and α.
#[derive(Clone, Debug, PartialEq)]
pub struct Terrain {
    /// Exponents of the combined model, ascending, evenly in the logarithm.
    pub s: Vec<f64>,
    /// Ascending, evenly.
    pub alpha: Vec<f64>,
    /// A value per exponent for every α.
    pub percent: Vec<f64>,
}

/// Cells between two nodes, so that colours change evenly.
const FINER: usize = 4;

impl Terrain {
    /// The smallest and the largest value.
    pub fn ends(&self) -> Option<(f64, f64)> {
        let values = || self.percent.iter().copied().filter(|x| x.is_finite());
        let (low, high) = (
            values().min_by(f64::total_cmp)?,
            values().max_by(f64::total_cmp)?,
        );
        Some((low.max(1e-6), high.max(1e-6)))
    }

    /// Cells whose values are between those of the nodes.
    pub fn field(&self) -> HeatField {
        let (columns, rows) = (self.s.len(), self.alpha.len());
        if columns < 2 || rows < 2 || self.percent.len() != columns * rows {
            return HeatField::default();
        }
        let ln_s: Vec<f64> = self.s.iter().map(|s| s.ln()).collect();
        let x = finer(&ln_s).into_iter().map(f64::exp).collect();
        let at = |i: usize, j: usize| self.percent[i + columns * j];
        // The middle of a cell between its nodes.
        let split = |k: usize| {
            (
                k / FINER,
                (k % FINER) as f64 / FINER as f64 + 0.5 / FINER as f64,
            )
        };
        HeatField::new(x, finer(&self.alpha), |column, row| {
            let ((i, u), (j, v)) = (split(column), split(row));
            let along = |j: usize| (1.0 - u) * at(i, j) + u * at(i + 1, j);
            Cell::Value((1.0 - v) * along(j) + v * along(j + 1))
        })
    }
}

fn finer(nodes: &[f64]) -> Vec<f64> {
    let mut edges: Vec<f64> = nodes
        .windows(2)
        .flat_map(|pair| {
            let step = (pair[1] - pair[0]) / FINER as f64;
            (0..FINER).map(move |k| pair[0] + step * k as f64)
        })
        .collect();
    edges.extend(nodes.last());
    edges
}
