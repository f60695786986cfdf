//! Values over two axes as colours: cells, a colour bar, what has no value, and marks over them.
//!
//! ```text
//! Field (edges, cells) + HeatSpec (axes, colours, view, marks) ── HeatMap::new ──▶ Drawing and HeatFrame
//! ```

mod bar;
mod colors;
mod draw;
mod frame;
mod hatch;
mod layout;
mod raster;
mod side;

pub use bar::{ColorBar, draw_key, key_width_em};
pub use colors::ColorScale;
pub use frame::{HeatFrame, HeatView};
pub use hatch::hatch;
pub use layout::fitting_title;
pub use raster::image;
pub use side::{Law, Side};

use super::drawing::Drawing;
use super::mark::ProbeMark;

/// Content of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A value, shown as a colour.
    Value(f64),
    /// No value where one should be: hatched.
    Missing,
    /// No value, as none belongs there: left blank.
    Outside,
}

impl Cell {
    /// The value; `None` where there is none.
    pub fn value(self) -> Option<f64> {
        match self {
            Self::Value(value) => Some(value),
            Self::Missing | Self::Outside => None,
        }
    }
}

/// Cells between edges, in the units of the axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeatField {
    /// Edges of the columns, ascending; one more than there are columns.
    pub x: Vec<f64>,
    /// Edges of the rows, ascending; one more than there are rows.
    pub y: Vec<f64>,
    /// Row by row, from the smallest y.
    pub cells: Vec<Cell>,
}

impl HeatField {
    /// A field with a cell for every pair of column and row.
    pub fn new(x: Vec<f64>, y: Vec<f64>, cell: impl Fn(usize, usize) -> Cell) -> Self {
        let (columns, rows) = (x.len().saturating_sub(1), y.len().saturating_sub(1));
        let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let cells = cells.map(|(column, row)| cell(column, row)).collect();
        Self { x, y, cells }
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.x.len().saturating_sub(1)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.y.len().saturating_sub(1)
    }

    /// The cell of a column and a row.
    pub fn cell(&self, column: usize, row: usize) -> Cell {
        self.cells[column + self.columns() * row]
    }

    /// Column and row of the cell that holds a place; the last ones hold their far edges too.
    pub fn find(&self, [x, y]: [f64; 2]) -> Option<(usize, usize)> {
        Some((position(&self.x, x)?, position(&self.y, y)?))
    }

    /// All values.
    pub fn values(&self) -> impl Iterator<Item = f64> + Clone {
        self.cells.iter().filter_map(|cell| cell.value())
    }
}

/// The interval of `edges` that holds `at`.
fn position(edges: &[f64], at: f64) -> Option<usize> {
    let (first, last) = (edges.first()?, edges.last()?);
    if !(*first..=*last).contains(&at) || edges.len() < 2 {
        return None;
    }
    let after = edges.partition_point(|edge| *edge <= at);
    Some(after.saturating_sub(1).min(edges.len() - 2))
}

/// A line over the cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Corners of the line, in the units of the axes.
    pub points: Vec<[f64; 2]>,
    /// Purpose of the line, which decides its look.
    pub kind: CurveKind,
    /// Written on it where there is room, in the markup of [`super::text`].
    pub label: Option<String>,
}

/// Purpose of a line over the cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// An edge of what is possible or wanted: dashed.
    Limit,
    /// A line of equal value: thin.
    Contour,
    /// Path of a search: strong.
    Path,
}

/// A place that is marked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeatSpot {
    /// The probe: a crosshair with a dot.
    Probe(ProbeMark<[f64; 2]>),
    /// The probe again, where the axes may be swapped: a dot.
    Mirrored(ProbeMark<[f64; 2]>),
    /// Place of the sliders: a dot.
    Here([f64; 2]),
    /// The best: a diamond.
    Best([f64; 2]),
    /// Beginning of a path: a ring.
    Start([f64; 2]),
}

/// Settings of a heat map besides its cells.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatSpec {
    /// Titles in the markup of [`super::text`]; the first one that fits is drawn, so the longest first.
    pub title: Vec<String>,
    /// Horizontal axis, to the right.
    pub x: Side,
    /// Upwards.
    pub y: Side,
    /// The part of both that is in sight.
    pub view: HeatView,
    /// Law from values to colours.
    pub colors: ColorScale,
    /// Quantity and unit of the colours, in the markup of [`super::text`].
    pub bar_title: String,
    /// Name of a hatched cell.
    pub missing: &'static str,
    /// Whether colours run into one another between the cells.
    pub smooth: bool,
    /// Whether both axes are as long on screen.
    pub square: bool,
    /// Lines over the cells.
    pub curves: Vec<Curve>,
    /// Marks over the lines.
    pub spots: Vec<HeatSpot>,
    /// One sentence in place of cells where there are none.
    pub nothing: &'static str,
}

/// A heat map: the picture, and where things are in it.
#[derive(Clone, Debug)]
pub struct HeatMap {
    /// The picture.
    pub drawing: Drawing,
    /// Map between values and points of the drawing.
    pub frame: HeatFrame,
}

impl HeatMap {
    /// Draws a field into `size` points.
    pub fn new(spec: &HeatSpec, field: &HeatField, size: [f32; 2]) -> Self {
        let plan = layout::HeatLayout::new(spec, field, size);
        let drawing = draw::draw(spec, field, &plan, size);
        Self {
            drawing,
            frame: plan.frame,
        }
    }
}

#[cfg(test)]
mod tests;
