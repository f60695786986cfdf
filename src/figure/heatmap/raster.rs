//! The cells as a picture.

use super::{Cell, ColorScale, HeatField, HeatFrame, position};
use crate::figure::drawing::{Item, Picture};

/// Shades of a map that are told apart.
const SHADES: usize = 1024;
/// Pixels per point where cells are not of the same size.
const FINE: f32 = 2.0;
/// Pixels in a row at most: every graphics adapter has these.
const MOST: usize = 2048;

/// The cells in sight, clear where they have no value; `None` where there are no cells.
pub fn image(
    field: &HeatField,
    colors: &ColorScale,
    frame: &HeatFrame,
    smooth: bool,
) -> Option<Item> {
    let [width, height] = frame.size();
    let columns = samples(&field.x, width, frame.view.x, |x| frame.x.share(x));
    let rows = samples(&field.y, height, frame.view.y, |y| frame.y.share(y));
    if columns.is_empty() || rows.is_empty() || field.cells.is_empty() {
        return None;
    }
    let map = colors.map();
    let shades: Vec<[u8; 3]> = (0..SHADES)
        .map(|k| map.color(k as f64 / (SHADES - 1) as f64))
        .collect();
    let of_cells: Vec<[u8; 4]> = field
        .cells
        .iter()
        .map(|cell| match cell {
            Cell::Value(value) => {
                let shade = colors.position(*value) * (SHADES - 1) as f64;
                let [r, g, b] = shades[shade.round() as usize];
                [r, g, b, 255]
            }
            Cell::Missing | Cell::Outside => [0; 4],
        })
        .collect();
    let mut rgba = Vec::with_capacity(4 * columns.len() * rows.len());
    for row in rows.iter().rev() {
        for column in &columns {
            let cell = match (column, row) {
                (Some(column), Some(row)) => of_cells[column + field.columns() * row],
                _ => [0; 4],
            };
            rgba.extend(cell);
        }
    }
    Some(Item::Image(Picture {
        min: frame.min,
        max: frame.max,
        width: columns.len(),
        height: rows.len(),
        rgba: rgba.into(),
        smooth,
    }))
}

/// Position of the cell that each pixel shows: one pixel per cell where all are in sight and of the same size.
fn samples(
    edges: &[f64],
    length: f32,
    (from, to): (f64, f64),
    share: impl Fn(f64) -> f64,
) -> Vec<Option<usize>> {
    let count = edges.len().saturating_sub(1);
    if count == 0 {
        return Vec::new();
    }
    let shares: Vec<f64> = edges.iter().map(|edge| share(*edge)).collect();
    let even = |k: usize| (shares[k] - k as f64 / count as f64).abs() < 1e-6;
    if (from, to) == (0.0, 1.0) && (0..=count).all(even) {
        return (0..count).map(Some).collect();
    }
    let pixels = ((FINE * length) as usize).clamp(1, MOST);
    (0..pixels)
        .map(|k| {
            let at = from + (to - from) * (k as f64 + 0.5) / pixels as f64;
            position(&shares, at)
        })
        .collect()
}
