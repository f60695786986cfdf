//! Kernels of lobes that are a number of the row times a function of the cosines of θi and θo: one that no parameter
//! changes, or masking and shadowing with the lobe's roughness.

use super::differences::{log_slope, moved};
use super::fresnel_rows::FresnelRows;
use super::{LobeKernel, LobeShape, RowSlopes, angles_of, cosines_at};
use crate::brdf::along_phi_d::{Azimuth, RowAngles, Smith};
use crate::brdf::{LobeValues, Model};
use crate::fit::simd::{self, Kernel, Lanes, take_first, vectors};
use crate::fit::symmetric_cells::{CellRow, SymmetricCells};
use crate::fit::variables::{ETA_VARIABLE, VARIABLES};
use pulp::Simd;

/// Kernel of a shape whose lobe varies along φd as a factor that no parameter changes.
pub fn factor(shape: &LobeShape, azimuth: Azimuth) -> Box<dyn LobeKernel> {
    match azimuth {
        Azimuth::Constant => Box::new(Rows::new(shape, Constant)),
        Azimuth::InverseRoot => Box::new(Rows::new(shape, InverseRoot)),
        Azimuth::InverseProduct => Box::new(Rows::new(shape, InverseProduct)),
        Azimuth::InverseLarger => Box::new(Rows::new(shape, InverseLarger)),
        Azimuth::VGroove => Box::new(Rows::new(shape, VGroove)),
    }
}

/// Kernel of a shape whose lobe varies along φd as masking and shadowing with its roughness, the first parameter.
pub fn smith(shape: &LobeShape, smith: Smith) -> Box<dyn LobeKernel> {
    match smith {
        Smith::Ggx => Box::new(Rows::new(shape, Ggx)),
        Smith::Beckmann => Box::new(Rows::new(shape, Beckmann)),
    }
}

/// A factor of a lobe, a function of cos θi, cos θo, θh, θd and at most the lobe's first parameter.
trait Factor: Copy + Send + Sync {
    /// Whether the first parameter changes it.
    const VARIES: bool;

    /// Value at the cells of a vector, and its slope ∂ ln factor / ∂ ln p for the first parameter p.
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2];
}

/// Numbers of a row, each spread over all lanes.
struct FactorRow<S: Simd> {
    simd: S,
    /// cos θi cos θo = `product[0] + product[1] c`.
    product: [Lanes<S>; 2],
    /// cos θi, cos θo = `middle` ∓ `half` √c.
    middle: Lanes<S>,
    half: Lanes<S>,
    /// 2 cos θh / cos θd
    groove: Lanes<S>,
    /// cos² θi + cos² θo = `squares` − 2 cos θi cos θo
    squares: Lanes<S>,
    /// The first parameter.
    p: Lanes<S>,
}

impl<S: Simd> FactorRow<S> {
    #[inline(always)]
    fn new(simd: S, angles: &RowAngles, p: f64) -> Self {
        let splat = |x: f64| Lanes::splat(simd, x as f32);
        let [along, across] = angles.product();
        Self {
            simd,
            product: [splat(along), splat(-across)],
            middle: splat(along.sqrt()),
            half: splat(across.sqrt()),
            groove: splat(2.0 * (angles.cos2_h / angles.cos2_d).sqrt()),
            squares: splat(4.0 * along),
            p: splat(p),
        }
    }

    #[inline(always)]
    fn splat(&self, x: f32) -> Lanes<S> {
        Lanes::splat(self.simd, x)
    }

    /// cos θi cos θo, above 0 as the formulas divide by it.
    #[inline(always)]
    fn product(&self, cos2: Lanes<S>) -> Lanes<S> {
        self.product[1]
            .mul_add(cos2, self.product[0])
            .max(self.splat(LEAST_PRODUCT))
    }

    /// cos θi, above 0, and cos θo, the larger of the two.
    #[inline(always)]
    fn cosines(&self, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        let half = self.half * cos2.sqrt();
        [
            (self.middle - half).max(self.splat(LEAST_COSINE)),
            self.middle + half,
        ]
    }
}

/// Least cosine that a formula divides by, as in the lobes themselves.
const LEAST_COSINE: f32 = 1e-6;
const LEAST_PRODUCT: f32 = 1e-12;

#[derive(Clone, Copy)]
struct Constant;

impl Factor for Constant {
    const VARIES: bool = false;
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, _: Lanes<S>) -> [Lanes<S>; 2] {
        [row.splat(1.0), row.splat(0.0)]
    }
}

#[derive(Clone, Copy)]
struct InverseRoot;

impl Factor for InverseRoot {
    const VARIES: bool = false;
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        [row.splat(1.0) / row.product(cos2).sqrt(), row.splat(0.0)]
    }
}

#[derive(Clone, Copy)]
struct InverseProduct;

impl Factor for InverseProduct {
    const VARIES: bool = false;
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        [row.splat(1.0) / row.product(cos2), row.splat(0.0)]
    }
}

#[derive(Clone, Copy)]
struct InverseLarger;

impl Factor for InverseLarger {
    const VARIES: bool = false;
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        [row.splat(1.0) / row.cosines(cos2)[1], row.splat(0.0)]
    }
}

#[derive(Clone, Copy)]
struct VGroove;

impl Factor for VGroove {
    const VARIES: bool = false;
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        let open = row.splat(1.0) / row.product(cos2);
        let masked = row.groove / row.cosines(cos2)[1];
        [open.min(masked), row.splat(0.0)]
    }
}

#[derive(Clone, Copy)]
struct Ggx;

impl Factor for Ggx {
    const VARIES: bool = true;
    /// With r = √(a² + (1−a²) cos²θ), G₁/cos θ is 2 / (cos θ + r); the product of both sums is symmetric in θi and θo
    /// and so a function of their cosines' product P and sum of squares M: P + T + Q with Q = ri ro and
    /// T = cos θi ro + cos θo ri.
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        let splat = |x: f32| row.splat(x);
        let (one, two) = (splat(1.0), splat(2.0));
        let p = row.product(cos2);
        let m = row.squares - two * p;
        let u = row.p * row.p;
        let v = one - u;
        let p2 = p * p;
        let q = (u * u + v * (u * m + v * p2)).sqrt();
        let t = (u * m + two * (v * p2 + p * q)).sqrt();
        let sum = p + t + q;
        // Slopes in ln a, where u moves by 2u.
        let q_slope = u * (two * u + (one - two * u) * m - two * v * p2) / q;
        let t_slope = (u * (m - two * p2) + p * q_slope) / t;
        [splat(4.0) / sum, splat(0.0) - (q_slope + t_slope) / sum]
    }
}

#[derive(Clone, Copy)]
struct Beckmann;

impl Factor for Beckmann {
    const VARIES: bool = true;
    /// [Walter07] after eq. 27: with b = 1/(a tan θ) below 1.6, G₁ is (3.535 b + 2.181 b²) / (1 + 2.276 b + 2.577 b²).
    #[inline(always)]
    fn at<S: Simd>(self, row: &FactorRow<S>, cos2: Lanes<S>) -> [Lanes<S>; 2] {
        let splat = |x: f32| row.splat(x);
        let (zero, one) = (splat(0.0), splat(1.0));
        let [mut factor, mut slope] = [one, zero];
        for cos in row.cosines(cos2) {
            let sin = (one - cos * cos).max(splat(1e-12)).sqrt();
            // b / cos θ
            let steep = one / (row.p * sin);
            let b = steep * cos;
            let above = splat(2.181).mul_add(b, splat(3.535));
            let below = b.mul_add(splat(2.577).mul_add(b, splat(2.276)), one);
            let masked = steep * above / below;
            let masked_slope = b * (splat(2.577 * 2.0).mul_add(b, splat(2.276)) / below)
                - splat(2.0 * 2.181).mul_add(b, splat(3.535)) / above;
            let limit = splat(1.6);
            let open = one / cos;
            factor = factor * (masked.where_lt(b, limit) + open.where_le(limit, b));
            slope = slope + masked_slope.where_lt(b, limit);
        }
        [factor, slope]
    }
}

/// A lobe that is a number of the row times a factor.
struct Rows<F> {
    factor: F,
    model: &'static Model,
    lobe: LobeValues,
    /// The lobe's parameters a little below and above, one after the other moved, by a step in its variable.
    moved: Vec<[LobeValues; 2]>,
    fresnel: FresnelRows,
}

impl<F: Factor> Rows<F> {
    fn new(shape: &LobeShape, factor: F) -> Self {
        let moved = (0..shape.model.params.len()).map(|k| moved(shape.model, &shape.lobe, k));
        Self {
            factor,
            model: shape.model,
            lobe: shape.lobe,
            moved: moved.collect(),
            fresnel: FresnelRows::new(shape),
        }
    }

    /// Number of the row, R_F included: the lobe over the factor at φd = 90°, where no cosine is 0. And the factor's slope
    /// there.
    fn of_row(&self, row: &CellRow) -> [f64; 2] {
        let lobe = (self.model.lobe)(&self.lobe, &cosines_at(row, 0.0));
        if lobe <= DARK {
            return [0.0; 2];
        }
        let scalar = FactorRow::new(pulp::Scalar, angles_of(row), self.lobe[0]);
        let at_reference = self.factor.at(&scalar, Lanes::splat(pulp::Scalar, 0.0));
        let [factor, slope] = at_reference.map(Lanes::total);
        [self.fresnel.value[row.theta_d] * lobe / factor, slope]
    }

    /// Slopes that are the same in all cells of a row with this number.
    fn constant(&self, row: &CellRow, [number, factor_slope]: [f64; 2]) -> [f64; VARIABLES] {
        let mut slopes = [0.0; VARIABLES];
        // Where the lobe is 0 its slope is of no account.
        if number > 0.0 {
            let cosines = cosines_at(row, 0.0);
            for (slope, moved) in slopes.iter_mut().zip(&self.moved) {
                let change = log_slope(moved.map(|lobe| (self.model.lobe)(&lobe, &cosines)));
                *slope = if change.is_finite() { change } else { 0.0 };
            }
            if F::VARIES {
                slopes[0] -= factor_slope;
            }
            slopes[ETA_VARIABLE] = self.fresnel.slope[row.theta_d];
        }
        slopes
    }
}

/// Values of a lobe up to this count as 0: the foot of a needle, far below what f32 adds to anything.
const DARK: f64 = 1e-25;

impl<F: Factor> LobeKernel for Rows<F> {
    fn shapes(&self, cells: &SymmetricCells, rows: &[CellRow], shapes: &mut [f32]) {
        simd::dispatch(Fill {
            lobe: self,
            cells,
            rows,
            shapes,
            constant: &mut [],
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
        let constant = &mut slopes.constant;
        if F::VARIES {
            simd::dispatch(Fill {
                lobe: self,
                cells,
                rows,
                shapes,
                constant,
                slopes: [&mut slopes.varying[0]],
            });
        } else {
            simd::dispatch(Fill {
                lobe: self,
                cells,
                rows,
                shapes,
                constant,
                slopes: [],
            });
        }
    }

    fn varying(&self) -> &[usize] {
        if F::VARIES { &[0] } else { &[] }
    }
}

/// Writes the shapes of rows, the slopes that are the same in all cells of a row where there is room for them, and the
/// factor's slopes where `SLOPES` is 1.
struct Fill<'a, F, const SLOPES: usize> {
    lobe: &'a Rows<F>,
    cells: &'a SymmetricCells,
    rows: &'a [CellRow],
    shapes: &'a mut [f32],
    constant: &'a mut [[f64; VARIABLES]],
    slopes: [&'a mut [f32]; SLOPES],
}

impl<F: Factor, const SLOPES: usize> Kernel for Fill<'_, F, SLOPES> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let mut constant = self.constant.iter_mut();
        let mut shapes = S::as_mut_simd_f32s(self.shapes).0;
        let mut slopes = self.slopes.map(|slopes| S::as_mut_simd_f32s(slopes).0);
        for row in self.rows {
            let of_row = self.lobe.of_row(row);
            if let Some(constant) = constant.next() {
                *constant = self.lobe.constant(row, of_row);
            }
            let cos2 = vectors::<S>(self.cells.cos2_of(row));
            // As long as each other: nothing is checked in the loop.
            let shapes_here = take_first(&mut shapes, cos2.len());
            let mut slopes_here = slopes
                .each_mut()
                .map(|slopes| take_first(slopes, cos2.len()));
            if of_row[0] <= 0.0 {
                let zero = simd.splat_f32s(0.0);
                shapes_here.fill(zero);
                slopes_here.iter_mut().for_each(|slopes| slopes.fill(zero));
                continue;
            }
            let row = FactorRow::new(simd, angles_of(row), self.lobe.lobe[0]);
            let number = row.splat(of_row[0] as f32);
            for (k, (cos2, out)) in cos2.iter().zip(shapes_here).enumerate() {
                let [factor, slope] = self.lobe.factor.at(&row, Lanes::new(simd, *cos2));
                *out = (number * factor).vector();
                if SLOPES > 0 {
                    slopes_here[0][k] = slope.vector();
                }
            }
        }
    }
}
