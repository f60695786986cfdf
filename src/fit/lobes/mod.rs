//! Specular shape R_F · lobe of a variant on rows of cells, with its slopes in the variables of the search.
//!
//! Cells of a row share θh and θd, so that a lobe is a number of the row times a function of cos² φd. What function that
//! is the model says, as [`AlongPhiD`]; a kernel per kind makes use of it. Where nothing is known the lobe itself is
//! evaluated cell by cell.

mod cellwise;
mod differences;
mod factor;
mod fresnel_rows;
mod power;

use super::options::Variant;
use super::symmetric_cells::{CellRow, ROW_CELLS, ROWS_PER_SUM, SymmetricCells};
use super::variables::{ETA_VARIABLE, SearchPoint, VARIABLES, value};
use crate::brdf::along_phi_d::{AlongPhiD, RowAngles};
use crate::brdf::params::ETA;
use crate::brdf::{Fresnel, LobeValues, Model};
use crate::geom::{Cosine, Cosines};
use crate::measured::Grid;
use crate::measured::grid::{THETA_D_BINS, THETA_H_BINS};
use std::sync::LazyLock;

/// A specular shape, ready for passes over rows of cells. It takes many rows at a time, as a row is as short as the way
/// to it.
pub trait LobeKernel: Send + Sync {
    /// Writes the shape at the cells of rows, one after the other; `shapes` is as long as all of them, in whole blocks.
    fn shapes(&self, cells: &SymmetricCells, rows: &[CellRow], shapes: &mut [f32]);

    /// Writes the shape at the cells of at most [`ROWS_PER_SUM`] rows, and its slopes.
    fn slopes(
        &self,
        cells: &SymmetricCells,
        rows: &[CellRow],
        shapes: &mut [f32],
        slopes: &mut RowSlopes,
    );

    /// Variables whose slopes vary along a row.
    fn varying(&self) -> &[usize];
}

/// Slopes ∂ ln shape / ∂ variable along rows: the sum of a part that is the same in all cells of a row and one that
/// varies.
pub struct RowSlopes {
    /// Slopes per row and variable that are the same in all cells.
    pub constant: [[f64; VARIABLES]; ROWS_PER_SUM],
    /// Slopes per cell, row after row; the k-th for the k-th variable of [`LobeKernel::varying`].
    pub varying: [[f32; CELLS_PER_SUM]; VARIABLES - 1],
}

/// Largest number of cells in as many rows as a pass takes at a time.
pub const CELLS_PER_SUM: usize = ROWS_PER_SUM * ROW_CELLS;

impl Default for RowSlopes {
    fn default() -> Self {
        Self {
            constant: [[0.0; VARIABLES]; ROWS_PER_SUM],
            varying: [[0.0; CELLS_PER_SUM]; VARIABLES - 1],
        }
    }
}

/// Parameters of a specular shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeShape {
    /// Reflection model.
    pub model: &'static Model,
    /// Fresnel factor.
    pub fresnel: Fresnel,
    /// Values of the lobe's parameters.
    pub lobe: LobeValues,
    /// Relative index of refraction η.
    pub eta: f64,
}

impl LobeShape {
    /// Shape of a variant at a point of the search.
    pub fn at(variant: Variant, point: &SearchPoint) -> Self {
        let mut lobe = LobeValues::default();
        for (k, row) in variant.model.params.iter().enumerate() {
            lobe[k] = value(row, point[k]);
        }
        Self {
            model: variant.model,
            fresnel: variant.fresnel,
            lobe,
            eta: value(&ETA, point[ETA_VARIABLE]),
        }
    }

    /// Kernel of the shape: that of the model's kind.
    pub fn kernel(&self) -> Box<dyn LobeKernel> {
        match self.model.along_phi_d {
            AlongPhiD::Unknown => self.cellwise(),
            AlongPhiD::Power { exponent, base } => {
                Box::new(power::Power::new(self, exponent, base))
            }
            AlongPhiD::Factor(azimuth) => factor::factor(self, azimuth),
            AlongPhiD::Smith(smith) => factor::smith(self, smith),
        }
    }

    /// Kernel that evaluates the model's lobe at every cell in f64.
    pub fn cellwise(&self) -> Box<dyn LobeKernel> {
        Box::new(cellwise::Cellwise::new(self))
    }

    /// R_F at normal incidence times the height of the lobe: what a specular amplitude is measured by when the shape
    /// changes.
    pub fn height(&self) -> f64 {
        let mirrored = |cos: f64| {
            let one = Cosine {
                cos: 1.0,
                versine: 0.0,
            };
            let cosines = Cosines {
                cos_theta_i: cos,
                cos_theta_o: cos,
                wr_wo: one,
                wh_n: one,
                wi_wh: Cosine {
                    cos,
                    versine: 1.0 - cos,
                },
            };
            (self.model.lobe)(&self.lobe, &cosines)
        };
        // Seen from above and near the horizon: there are lobes that are dark in one of them.
        let lobe = mirrored(1.0).max(mirrored(GRAZING_COSINE));
        self.fresnel.reflectance(1.0, self.eta) * lobe.max(1e-30)
    }
}

/// Cosine of the grazing angle at which the height of a lobe is looked at.
const GRAZING_COSINE: f64 = 0.17;

/// Functions of the angles of the grid's bins.
struct GridAngles {
    /// Squares per (θh, θd), θd fastest.
    rows: Vec<RowAngles>,
    /// Cosine per bin of θh.
    theta_h: [Cosine; THETA_H_BINS],
    /// Cosine per bin of θd.
    theta_d: [Cosine; THETA_D_BINS],
}

static ANGLES: LazyLock<GridAngles> = LazyLock::new(|| {
    let grid = Grid::FOLDED;
    let theta_h = |h: usize| grid.center(h, 0, 0).theta_h;
    let theta_d = |d: usize| grid.center(0, d, 0).theta_d;
    GridAngles {
        rows: (0..THETA_H_BINS * THETA_D_BINS)
            .map(|k| RowAngles::new(theta_h(k / THETA_D_BINS), theta_d(k % THETA_D_BINS)))
            .collect(),
        theta_h: std::array::from_fn(|h| Cosine::of(theta_h(h))),
        theta_d: std::array::from_fn(|d| Cosine::of(theta_d(d))),
    }
});

/// Squares of the sines and cosines of a row's angles.
fn angles_of(row: &CellRow) -> &'static RowAngles {
    &ANGLES.rows[row.theta_h * THETA_D_BINS + row.theta_d]
}

/// Cosines of the directions at a cell of a row, from c = cos² φd.
fn cosines_at(row: &CellRow, c: f64) -> Cosines {
    let angles = angles_of(row);
    let [along, across] = angles.product();
    let mirror = angles.mirror_versine();
    let (middle, half) = (along.sqrt(), (across * c).sqrt());
    let versine = mirror[0] + mirror[1] * c;
    Cosines {
        cos_theta_i: middle - half,
        cos_theta_o: middle + half,
        wr_wo: Cosine {
            cos: (1.0 - versine).max(0.0),
            versine: versine.min(1.0),
        },
        wh_n: ANGLES.theta_h[row.theta_h],
        wi_wh: ANGLES.theta_d[row.theta_d],
    }
}
