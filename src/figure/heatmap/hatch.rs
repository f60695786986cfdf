//! Diagonal lines over the cells that miss a value, cut at their outlines.

use super::{Cell, HeatField, HeatFrame};
use crate::figure::drawing::{Drawing, Point};
use crate::figure::palette::Ink;

/// Distance of the lines in points, across.
const SPACING: f32 = 5.0;
/// Shorter pieces are specks.
const SHORTEST: f32 = 0.7;

/// Hatches the missing cells in sight.
pub fn hatch(drawing: &mut Drawing, field: &HeatField, frame: &HeatFrame, ink: Ink) {
    if !field.cells.contains(&Cell::Missing) {
        return;
    }
    let columns: Vec<f32> = field
        .x
        .iter()
        .map(|x| frame.point([*x, frame.y.range.0])[0])
        .collect();
    let rows: Vec<f32> = field
        .y
        .iter()
        .map(|y| frame.point([frame.x.range.0, *y])[1])
        .collect();
    let [width, height] = frame.size();
    let step = SPACING * std::f32::consts::SQRT_2;
    // Lines go up to the right; `at` is where one meets the left edge, downwards from the upper corner.
    let mut at = 0.5 * step;
    while at < width + height {
        let from = frame.min[0] + (at - height).max(0.0);
        let to = frame.min[0] + at.min(width);
        let y_of = |x: f32| frame.min[1] + at - (x - frame.min[0]);
        for piece in pieces(field, &columns, &rows, (from, to), y_of) {
            drawing.line(piece, 1.0, ink);
        }
        at += step;
    }
}

/// The pieces of one line over missing cells. Edges of columns ascend, edges of rows descend on screen.
fn pieces(
    field: &HeatField,
    columns: &[f32],
    rows: &[f32],
    (from, to): (f32, f32),
    y_of: impl Fn(f32) -> f32,
) -> Vec<Vec<Point>> {
    let mut pieces = Vec::new();
    let mut begun: Option<f32> = None;
    let (mut x, mut column, mut row) = (from, 0, 0);
    let end = |begun: &mut Option<f32>, pieces: &mut Vec<Vec<Point>>, x: f32| {
        if let Some(start) = begun.take().filter(|start| x - start >= SHORTEST) {
            pieces.push(vec![[start, y_of(start)], [x, y_of(x)]]);
        }
    };
    while x < to {
        while column < columns.len() && columns[column] <= x {
            column += 1;
        }
        while row < rows.len() && rows[row] >= y_of(x) {
            row += 1;
        }
        let inside = (1..columns.len()).contains(&column) && (1..rows.len()).contains(&row);
        let missing = inside && field.cell(column - 1, row - 1) == Cell::Missing;
        match (missing, begun) {
            (true, None) => begun = Some(x),
            (false, Some(_)) => end(&mut begun, &mut pieces, x),
            _ => {}
        }
        let next_column = columns.get(column).copied().unwrap_or(to);
        let next_row = rows.get(row).map_or(to, |y| x + (y_of(x) - y));
        // A step at least, whatever rounding says.
        x = next_column.min(next_row).max(x + 0.01);
    }
    end(&mut begun, &mut pieces, to);
    pieces
}
