//! Kernel of lobes that are a power of a base.

use super::fresnel_rows::FresnelRows;
use super::{LobeKernel, LobeShape, RowSlopes, angles_of};
use crate::brdf::LobeValues;
use crate::brdf::along_phi_d::{PowerBase, RowAngles};
use crate::brdf::params::Scale;
use crate::fit::simd::{self, Kernel, LOWEST, Lanes, take_first, vectors};
use crate::fit::symmetric_cells::{CellRow, SymmetricCells};
use crate::fit::variables::ETA_VARIABLE;
use pulp::Simd;

/// The largest f32 below 1.
const BELOW_ONE: f32 = 1.0 - 0.5 * f32::EPSILON;

/// A lobe (1 − v)^s, with v as [`PowerBase`] has it.
pub struct Power {
    lobe: LobeValues,
    base: fn(&LobeValues, &RowAngles) -> PowerBase,
    /// Exponent of the base.
    s: f64,
    /// Variables whose slopes vary along a row: the exponent's, and that of the second parameter where there is one.
    varying: &'static [usize],
    /// ∂ second parameter / ∂ its variable.
    second: f64,
    fresnel: FresnelRows,
}

impl Power {
    /// Kernel of a shape whose exponent is a multiple of its first parameter.
    pub fn new(
        shape: &LobeShape,
        exponent: f64,
        base: fn(&LobeValues, &RowAngles) -> PowerBase,
    ) -> Self {
        Self {
            lobe: shape.lobe,
            base,
            s: exponent * shape.lobe[0],
            varying: &[0, 1][..shape.model.params.len().min(2)],
            second: match shape.model.params.get(1).map(|row| row.scale) {
                Some(Scale::Log { .. }) => shape.lobe[1],
                _ => 1.0,
            },
            fresnel: FresnelRows::new(shape),
        }
    }

    #[inline(always)]
    fn row(&self, row: &CellRow) -> Row {
        let base = (self.base)(&self.lobe, angles_of(row));
        Row {
            base: PowerBase {
                slope: base.slope.map(|slope| slope * self.second),
                ..base
            },
            s: self.s,
            fresnel: self.fresnel.value[row.theta_d],
        }
    }
}

impl LobeKernel for Power {
    fn shapes(&self, cells: &SymmetricCells, rows: &[CellRow], shapes: &mut [f32]) {
        simd::dispatch(Fill {
            power: self,
            cells,
            rows,
            shapes,
            slopes: [],
        });
    }

    fn slopes(
        &self,
        cells: &SymmetricCells,
        rows: &[CellRow],
        shapes: &mut [f32],
        slopes: &mut RowSlopes,
    ) {
        for (constant, row) in slopes.constant.iter_mut().zip(rows) {
            constant[ETA_VARIABLE] = self.fresnel.slope[row.theta_d];
        }
        let [by_s, by_second, ..] = &mut slopes.varying;
        match self.varying.len() {
            2 => simd::dispatch(Fill {
                power: self,
                cells,
                rows,
                shapes,
                slopes: [by_s, by_second],
            }),
            _ => simd::dispatch(Fill {
                power: self,
                cells,
                rows,
                shapes,
                slopes: [by_s],
            }),
        }
    }

    fn varying(&self) -> &[usize] {
        self.varying
    }
}

/// A row of the lobe.
struct Row {
    base: PowerBase,
    s: f64,
    fresnel: f64,
}

impl Row {
    /// Whether the lobe is 0 in all cells, as f32 has it: the base is monotonic in cos² φd, and (1 − v)^s below e^−sv.
    #[inline(always)]
    fn is_dark(&self) -> bool {
        let PowerBase { x, blend, .. } = self.base;
        let versine = |c: f64| blend[0] * (x[0] + x[1] * c).min(1.0) + blend[1];
        self.s * versine(0.0).min(versine(1.0)) > -f64::from(LOWEST)
    }
}

/// Writes shapes and the first `SLOPES` slopes of rows.
struct Fill<'a, const SLOPES: usize> {
    power: &'a Power,
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    shapes: &'a mut [f32],
    slopes: [&'a mut [f32]; SLOPES],
}

impl<const SLOPES: usize> Kernel for Fill<'_, SLOPES> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let mut shapes = S::as_mut_simd_f32s(self.shapes).0;
        let mut slopes = self.slopes.map(|slopes| S::as_mut_simd_f32s(slopes).0);
        for row in self.rows {
            let cos2 = vectors::<S>(self.cells.cos2_of(row));
            // As long as each other: nothing is checked in the loop.
            let shapes_here = take_first(&mut shapes, cos2.len());
            let mut slopes_here = slopes
                .each_mut()
                .map(|slopes| take_first(slopes, cos2.len()));
            let row = self.power.row(row);
            if row.is_dark() {
                let zero = simd.splat_f32s(0.0);
                shapes_here.fill(zero);
                slopes_here.iter_mut().for_each(|slopes| slopes.fill(zero));
            } else {
                fill_row(simd, &row, cos2, shapes_here, &mut slopes_here);
            }
        }
    }
}

#[inline(always)]
fn fill_row<S: Simd, const SLOPES: usize>(
    simd: S,
    row: &Row,
    cos2: &[S::f32s],
    shapes: &mut [S::f32s],
    slopes: &mut [&mut [S::f32s]; SLOPES],
) {
    let splat = |x: f64| Lanes::splat(simd, x as f32);
    let PowerBase { x, blend, slope } = row.base;
    let (x, blend, slope) = (x.map(splat), blend.map(splat), slope.map(splat));
    let (s, fresnel) = (splat(row.s), splat(row.fresnel));
    let (zero, one) = (splat(0.0), splat(1.0));
    let below_one = Lanes::splat(simd, BELOW_ONE);
    for (k, (cos2, out)) in cos2.iter().zip(shapes).enumerate() {
        let cos2 = Lanes::new(simd, *cos2);
        let x = x[1].mul_add(cos2, x[0]).min(one);
        let versine = blend[0].mul_add(x, blend[1]);
        let ln = versine.ln_one_minus();
        let shape = (s * ln).exp_negative() * fresnel;
        // A base of 0 is 0 to every power; with s = 0.1 the smallest base that has a logarithm is not.
        *out = shape.where_le(versine, below_one).vector();
        if SLOPES > 0 {
            slopes[0][k] = (s * ln).vector();
        }
        if SLOPES > 1 {
            // ∂ ln(1 − v)/∂p; at a base of 0 it has no bound.
            let base = (one - versine).max(splat(1e-3));
            let by_second = slope[0].mul_add(x, slope[2].mul_add(cos2, slope[1]));
            slopes[1][k] = (zero - s * by_second / base).vector();
        }
    }
}
