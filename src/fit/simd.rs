//! SIMD: f32 arithmetic on as many lanes as the machine has, by [`pulp`], and the two functions that the models need.

use pulp::Simd;
use std::ops::{Add, Div, Mul, Sub};
use std::sync::LazyLock;

/// Number of symmetric cells per block; rows are padded to whole blocks. A multiple of the lanes of every known
/// machine.
pub const LANES: usize = 8;

/// Computation that is compiled once for each instruction set.
pub trait Kernel {
    /// Result of the computation.
    type Output;
    /// Runs the computation with the given instruction set.
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}

/// Runs a kernel with the best instruction set of this machine.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    struct Dispatched<K>(K);
    impl<K: Kernel> pulp::WithSimd for Dispatched<K> {
        type Output = K::Output;
        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) -> K::Output {
            self.0.run(simd)
        }
    }
    ARCH.dispatch(Dispatched(kernel))
}

/// The best instruction set of this machine. Looking for it takes as long as a row of cells.
static ARCH: LazyLock<pulp::Arch> = LazyLock::new(pulp::Arch::new);

/// SIMD vector of f32: a number per lane.
#[derive(Clone, Copy)]
pub struct Lanes<S: Simd> {
    simd: S,
    value: S::f32s,
}

/// SIMD vectors of a slice whose length is a multiple of [`LANES`].
#[inline(always)]
pub fn vectors<S: Simd>(slice: &[f32]) -> &[S::f32s] {
    S::as_simd_f32s(slice).0
}

/// Takes the first elements off a slice.
#[inline(always)]
pub fn take_first<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (first, rest) = std::mem::take(slice).split_at_mut(count);
    *slice = rest;
    first
}

impl<S: Simd> Lanes<S> {
    /// Lanes of a vector in memory.
    #[inline(always)]
    pub fn new(simd: S, value: S::f32s) -> Self {
        Self { simd, value }
    }

    /// Lanes that all hold the same number.
    #[inline(always)]
    pub fn splat(simd: S, value: f32) -> Self {
        Self::new(simd, simd.splat_f32s(value))
    }

    /// Vector in memory of these lanes.
    #[inline(always)]
    pub fn vector(self) -> S::f32s {
        self.value
    }

    /// self · b + c.
    #[inline(always)]
    pub fn mul_add(self, b: Self, c: Self) -> Self {
        Self::new(
            self.simd,
            self.simd.mul_add_e_f32s(self.value, b.value, c.value),
        )
    }

    /// |self|
    #[inline(always)]
    pub fn abs(self) -> Self {
        // pulp's own is not always inlined.
        let magnitude = self.simd.splat_u32s(0x7fff_ffff);
        Self::from_bits(self.simd, self.simd.and_u32s(self.bits(), magnitude))
    }

    /// |self| with the sign of another number.
    #[inline(always)]
    pub fn with_sign_of(self, other: Self) -> Self {
        let simd = self.simd;
        let sign = simd.and_u32s(other.bits(), simd.splat_u32s(0x8000_0000));
        Self::from_bits(simd, simd.or_u32s(self.abs().bits(), sign))
    }

    /// Numbers of the lanes, one by one.
    #[inline(always)]
    pub fn lanes(&self) -> &[f32] {
        bytemuck::cast_slice(std::slice::from_ref(&self.value))
    }

    /// Larger of two numbers, per lane.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self::new(self.simd, self.simd.max_f32s(self.value, other.value))
    }

    /// Smaller of two numbers, per lane.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self::new(self.simd, self.simd.min_f32s(self.value, other.value))
    }

    /// self where `low` ≤ `high`, 0 elsewhere; not for NaN.
    #[inline(always)]
    pub fn where_le(self, low: Self, high: Self) -> Self {
        // All ones where the sign of the difference is not set: pulp's own selection is not always inlined.
        let simd = self.simd;
        let sign = simd.wrapping_dyn_shr_u32s((high - low).bits(), simd.splat_u32s(31));
        let mask = simd.sub_u32s(sign, simd.splat_u32s(1));
        Self::from_bits(simd, simd.and_u32s(self.bits(), mask))
    }

    /// self where `low` < `high`, 0 elsewhere; not for NaN.
    #[inline(always)]
    pub fn where_lt(self, low: Self, high: Self) -> Self {
        let simd = self.simd;
        let sign = simd.wrapping_dyn_shr_u32s((low - high).bits(), simd.splat_u32s(31));
        let mask = simd.sub_u32s(simd.splat_u32s(0), sign);
        Self::from_bits(simd, simd.and_u32s(self.bits(), mask))
    }

    /// Square root of each number.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self::new(self.simd, self.simd.sqrt_f32s(self.value))
    }

    /// Sum over the lanes.
    #[inline(always)]
    pub fn total(self) -> f64 {
        f64::from(self.simd.reduce_sum_f32s(self.value))
    }

    #[inline(always)]
    fn bits(self) -> S::u32s {
        self.simd.transmute_u32s_f32s(self.value)
    }

    #[inline(always)]
    fn from_bits(simd: S, bits: S::u32s) -> Self {
        Self::new(simd, simd.transmute_f32s_u32s(bits))
    }

    /// c₀ + c₁ x + c₂ x² + …, even and odd powers apart: two chains that do not wait for each other.
    #[inline(always)]
    fn polynomial<const N: usize>(self, c: [f32; N]) -> Self {
        let square = self * self;
        let powers_of_square = |parity: usize| {
            let last = N - 1 - (N - 1 + parity) % 2;
            let mut sum = Self::splat(self.simd, c[last]);
            for k in (parity..last).step_by(2).rev() {
                sum = sum.mul_add(square, Self::splat(self.simd, c[k]));
            }
            sum
        };
        powers_of_square(1).mul_add(self, powers_of_square(0))
    }

    /// ln(1 − v) for v = self in [0, 1], to 3e-7 of itself however small v is; ln of [`TINY`] at v = 1.
    #[inline(always)]
    pub fn ln_one_minus(self) -> Self {
        const SQRT_HALF: u32 = 0x3f35_04f3;
        const ONE: u32 = 0x3f80_0000;
        const MANTISSA: u32 = 0x007f_ffff;
        // 2²³: or'ed with a small whole number it is the float of that number plus 2²³.
        const TWO_23: u32 = 0x4b00_0000;
        const EXPONENT_OF_ONE: f32 = 8_388_608.0 + 127.0;
        // ln(1+f) = f − f²/2 + f³ P(f) on [√½, √2]; P fitted for the least relative error of the whole, 6e-9.
        const P: [f32; 9] = [
            -0.5,
            0.333_333_3,
            -0.250_008_23,
            0.200_012_27,
            -0.166_233_57,
            0.142_017_62,
            -0.131_601_94,
            0.127_615_5,
            -0.076_344_3,
        ];
        let simd = self.simd;
        let splat = |x: f32| Self::splat(simd, x);
        let u = (splat(1.0) - self).max(splat(TINY));
        // What rounding took from 1 − v; without it nothing is left of a v below 1e-7.
        // From ½ on 1 − v is exact, and so this is 0.
        let lost = (splat(1.0) - u) - self;
        // So that mantissas run from √½ to √2 and not from 1 to 2.
        let shifted = simd.add_u32s(u.bits(), simd.splat_u32s(ONE - SQRT_HALF));
        let exponent = simd.wrapping_dyn_shr_u32s(shifted, simd.splat_u32s(23));
        let exponent = simd.or_u32s(exponent, simd.splat_u32s(TWO_23));
        let exponent = Self::from_bits(simd, exponent) - splat(EXPONENT_OF_ONE);
        let mantissa = simd.and_u32s(shifted, simd.splat_u32s(MANTISSA));
        let mantissa = simd.add_u32s(mantissa, simd.splat_u32s(SQRT_HALF));
        let f = Self::from_bits(simd, mantissa) - splat(1.0);
        let log = (f * f).mul_add(f.polynomial(P), f);
        exponent.mul_add(splat(std::f32::consts::LN_2), log + lost)
    }

    /// e^t for t = self ≤ 0, to 3e-7 of itself; 0 below [`LOWEST`], so that no product of what follows is denormal, which
    /// would cost a hundred times as much.
    #[inline(always)]
    pub fn exp_negative(self) -> Self {
        // e^r = 1 + r + r² Q(r) on ±ln2/2, to 3e-9; all of it times UNIT, which costs nothing.
        const Q: [f32; 6] = [
            1.0,
            0.499_999_94,
            0.166_665_21,
            0.041_668_39,
            0.008_368_718,
            0.001_381_459_6,
        ];
        // Adding and taking away 1.5·2²³ rounds to a whole number, which stays behind in the low bits.
        const ROUND: f32 = 12_582_912.0;
        const LN_2_HIGH: f32 = 0.693_359_4;
        const LN_2_LOW: f32 = -2.121_944_4e-4;
        // −59 is where LOWEST rounds to: there the bits of the power of two, and so it, are 0.
        const LEAST: u32 = 59;
        const UNIT: f32 = f32::from_bits((127 + 127 - LEAST) << 23);
        let simd = self.simd;
        let splat = |x: f32| Self::splat(simd, x);
        let t = self.max(splat(LOWEST));
        let shifted = t.mul_add(splat(std::f32::consts::LOG2_E), splat(ROUND));
        let n = shifted - splat(ROUND);
        let r = n.mul_add(splat(-LN_2_LOW), n.mul_add(splat(-LN_2_HIGH), t));
        let power = r.mul_add(r.polynomial(Q.map(|q| UNIT * q)), splat(UNIT));
        let biased = simd.add_u32s(shifted.bits(), simd.splat_u32s(LEAST));
        let scale = simd.wrapping_dyn_shl_u32s(biased, simd.splat_u32s(23));
        power * Self::from_bits(simd, scale)
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.simd, self.simd.add_f32s(self.value, other.value))
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.simd, self.simd.sub_f32s(self.value, other.value))
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(self.simd, self.simd.mul_f32s(self.value, other.value))
    }
}

impl<S: Simd> Div for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self::new(self.simd, self.simd.div_f32s(self.value, other.value))
    }
}

/// Smallest base of a power: below it the lobe counts as 0.
pub const TINY: f32 = 1e-30;

/// Logarithm of what counts as 0.
pub const LOWEST: f32 = -41.0;

#[cfg(test)]
mod tests {
    use super::*;

    /// ln(1 − v) and e^−v of every number; the length is a multiple of [`LANES`].
    struct Both(Vec<f32>);
    impl Kernel for Both {
        type Output = (Vec<f32>, Vec<f32>);
        fn run<S: Simd>(self, simd: S) -> Self::Output {
            let (mut ln, mut exp) = (self.0.clone(), self.0.clone());
            let zero = Lanes::splat(simd, 0.0);
            for x in S::as_mut_simd_f32s(&mut ln).0 {
                *x = Lanes::new(simd, *x).ln_one_minus().vector();
            }
            for x in S::as_mut_simd_f32s(&mut exp).0 {
                *x = (zero - Lanes::new(simd, *x)).exp_negative().vector();
            }
            (ln, exp)
        }
    }

    fn values() -> Vec<f32> {
        // From 1e-12 to 1, then towards 1; for the exponential to 50.
        let falling = (0..100_000).map(|k| 10f64.powf(-12.0 * f64::from(k) / 1e5));
        falling
            .flat_map(|v| [v as f32, (1.0 - v) as f32, (50.0 * v) as f32, 0.0])
            .collect()
    }

    #[test]
    fn logarithm_and_exponential_are_exact_to_their_last_digits() {
        let values = values();
        for (ln, exp) in [
            dispatch(Both(values.clone())),
            Both(values.clone()).run(pulp::Scalar),
        ] {
            for ((v, ln), exp) in values.iter().zip(ln).zip(exp) {
                let v = f64::from(*v);
                let close =
                    |found: f32, exact: f64| (f64::from(found) - exact).abs() <= 3e-7 * exact.abs();
                if v <= 1.0 {
                    let exact = (-v).ln_1p().max(f64::from(TINY).ln());
                    assert!(close(ln, exact), "ln(1 - {v}) = {exact}, not {ln}");
                }
                assert!(
                    close(exp, (-v).exp()) || v > 40.0 && exp == 0.0,
                    "exp(-{v}) is not {exp}"
                );
            }
        }
    }

    #[test]
    fn the_ends_are_finite() {
        let mut values = vec![0.0; LANES];
        values[..3].copy_from_slice(&[0.0, 1.0, f32::INFINITY]);
        let (ln, exp) = dispatch(Both(values));
        assert_eq!(ln[0], 0.0);
        assert!((ln[1] - TINY.ln()).abs() < 1e-4);
        assert_eq!(exp[0], 1.0);
        assert_eq!(exp[2], 0.0);
    }
}
