//! A measured BRDF in memory.

use super::grid::Grid;
use crate::geom::Rgb;
use std::sync::{Arc, LazyLock};

/// f_r of every cell of a [`Grid`], with its validity. Immutable; share it by `Arc`.
#[derive(Clone, Debug)]
pub struct Table {
    grid: Grid,
    /// f_r in 1/sr per cell, in the grid's order; NaN in all channels of an invalid cell, so that none reads as 0.
    cells: Vec<[f32; 3]>,
    valid: usize,
}

impl Table {
    /// Table from f_r in 1/sr per cell in the grid's order. A cell with a negative or non-finite channel becomes
    /// invalid.
    ///
    /// # Panics
    /// If the number of cells is not the grid's.
    pub fn new(grid: Grid, mut cells: Vec<[f32; 3]>) -> Self {
        assert_eq!(cells.len(), grid.len());
        let mut valid = 0;
        for cell in &mut cells {
            // Without branches, as validity changes from cell to cell. A NaN fails every comparison.
            let [r, g, b] = *cell;
            let measured = (r >= 0.0)
                & (g >= 0.0)
                & (b >= 0.0)
                & (r < f32::INFINITY)
                & (g < f32::INFINITY)
                & (b < f32::INFINITY);
            valid += usize::from(measured);
            for value in cell {
                *value = if measured { *value } else { f32::NAN };
            }
        }
        Self { grid, cells, valid }
    }

    /// Table whose cells are all invalid, for a model without data. It is made once and shared.
    pub fn unmeasured() -> Arc<Self> {
        static UNMEASURED: LazyLock<Arc<Table>> = LazyLock::new(|| {
            let grid = Grid::FOLDED;
            Arc::new(Table::new(grid, vec![[f32::NAN; 3]; grid.len()]))
        });
        Arc::clone(&UNMEASURED)
    }

    /// Grid of the table.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Number of valid cells.
    pub fn valid_count(&self) -> usize {
        self.valid
    }

    /// f_r of a cell in 1/sr, linear RGB; `None` where it is invalid.
    pub fn cell(&self, index: usize) -> Option<Rgb> {
        let cell = self.cells[index];
        (!cell[0].is_nan()).then(|| cell.map(f64::from))
    }

    /// f_r of all cells in 1/sr, in the grid's order; NaN where invalid.
    pub fn cells(&self) -> &[[f32; 3]] {
        &self.cells
    }
}
