//! Tables made cell by cell.

use grazing::geom::{Cosines, Rgb};
use grazing::measured::{Grid, Table};

/// A table of what a closure says of (index, cosines) above the horizon; `None` is invalid.
pub fn table(grid: Grid, f_r: impl Fn(usize, &Cosines) -> Option<Rgb>) -> Table {
    let cell = |index| {
        let (h, d, phi) = grid.bins(index);
        let cosines = grid.center(h, d, phi).cosines();
        let above = cosines.cos_theta_i > 0.0 && cosines.cos_theta_o > 0.0;
        let value = above.then(|| f_r(index, &cosines)).flatten();
        value.map_or([-1.0; 3], |value| value.map(|x| x as f32))
    };
    Table::new(grid, (0..grid.len()).map(cell).collect())
}
