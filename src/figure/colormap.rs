//! Colours for values: perceptually uniform maps, one for amounts and one for differences.
//!
//! Both are the same in light and dark windows and on paper, so that a picture keeps its meaning.

use crate::geom::Rgb;
use crate::geom::color::{srgb_bytes, srgb_decode};

/// A way from [0, 1] to colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorMap {
    /// Viridis by van der Walt, Smith and Firing (CC0), for amounts: dark violet over green to yellow.
    Sequential,
    /// Viridis from yellow to dark violet, for amounts that are good where they are small.
    Reversed,
    /// Blue over light grey to orange brown, for differences and ratios. Lightness and chroma change evenly and alike
    /// on both sides of the middle, on two straight lines in CIELAB.
    Diverging,
}

/// Lightness L* of the middle and of both ends of the diverging map.
const DIVERGING_L: (f64, f64) = (94.0, 38.0);
/// Chroma at both ends.
const DIVERGING_CHROMA: f64 = 50.0;
/// Hues in CIELAB in degrees: below the middle and above it. Told apart by colour-blind people too.
const DIVERGING_HUES_DEG: [f64; 2] = [283.0, 50.0];

impl ColorMap {
    /// The sRGB colour at a place in [0, 1]; the ends beyond them.
    pub fn color(self, at: f64) -> [u8; 3] {
        let at = if at.is_nan() { 0.0 } else { at.clamp(0.0, 1.0) };
        match self {
            Self::Sequential => colorous::VIRIDIS.eval_continuous(at).as_array(),
            Self::Reversed => colorous::VIRIDIS.eval_continuous(1.0 - at).as_array(),
            Self::Diverging => {
                let side = 2.0 * at - 1.0;
                let hue = DIVERGING_HUES_DEG[usize::from(side > 0.0)].to_radians();
                let chroma = DIVERGING_CHROMA * side.abs();
                let lightness = DIVERGING_L.0 + (DIVERGING_L.1 - DIVERGING_L.0) * side.abs();
                srgb_bytes(linear_of_lab([
                    lightness,
                    chroma * hue.cos(),
                    chroma * hue.sin(),
                ]))
            }
        }
    }
}

/// XYZ of D65, as the sRGB standard has it.
const WHITE: [f64; 3] = [0.950_456, 1.0, 1.089_058];
/// Cube root of X/Xn, Y/Yn or Z/Zn below which CIELAB is a straight line.
const KNEE: f64 = 6.0 / 29.0;

/// CIELAB (D65) of an sRGB colour: L* in [0, 100], a*, b*.
pub fn lab(color: [u8; 3]) -> [f64; 3] {
    let [r, g, b] = color.map(|x| srgb_decode(f64::from(x) / 255.0));
    let xyz = [
        0.412_456_4 * r + 0.357_576_1 * g + 0.180_437_5 * b,
        0.212_672_9 * r + 0.715_152_2 * g + 0.072_175_0 * b,
        0.019_333_9 * r + 0.119_192_0 * g + 0.950_304_1 * b,
    ];
    let f = |k: usize| {
        let t = xyz[k] / WHITE[k];
        if t > KNEE.powi(3) {
            t.cbrt()
        } else {
            t / (3.0 * KNEE * KNEE) + 4.0 / 29.0
        }
    };
    [
        116.0 * f(1) - 16.0,
        500.0 * (f(0) - f(1)),
        200.0 * (f(1) - f(2)),
    ]
}

/// Linear RGB of a CIELAB colour; outside [0, 1] where sRGB does not have it.
fn linear_of_lab([lightness, a, b]: [f64; 3]) -> Rgb {
    let y = (lightness + 16.0) / 116.0;
    let t = [y + a / 500.0, y, y - b / 200.0];
    let [x, y, z] = std::array::from_fn(|k| {
        let value = if t[k] > KNEE {
            t[k].powi(3)
        } else {
            3.0 * KNEE * KNEE * (t[k] - 4.0 / 29.0)
        };
        WHITE[k] * value
    });
    [
        3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
        -0.969_266_0 * x + 1.876_010_8 * y + 0.041_556_0 * z,
        0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: usize = 32;

    /// Lightness at even places from `from` to `to`.
    fn lightness(color: impl Fn(f64) -> [u8; 3], from: f64, to: f64) -> Vec<f64> {
        (0..=STEPS)
            .map(|k| lab(color(from + (to - from) * k as f64 / STEPS as f64))[0])
            .collect()
    }

    /// The largest and the smallest step relative to the mean one; all are 1 where the map is uniform.
    fn steps(lightness: &[f64]) -> (f64, f64) {
        let mean = (lightness[STEPS] - lightness[0]) / STEPS as f64;
        lightness
            .windows(2)
            .map(|pair| (pair[1] - pair[0]) / mean)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), step| {
                (low.min(step), high.max(step))
            })
    }

    fn is_uniform(lightness: &[f64]) -> bool {
        let (low, high) = steps(lightness);
        // Eight bits per channel leave a step of 2 an error of 0.2.
        low > 0.6 && high < 1.4
    }

    #[test]
    fn lightness_grows_evenly() {
        for map in [ColorMap::Sequential, ColorMap::Reversed] {
            let lightness = lightness(|at| map.color(at), 0.0, 1.0);
            assert!(is_uniform(&lightness), "{map:?} {:?}", steps(&lightness));
        }
        for (from, to) in [(0.5, 0.0), (0.5, 1.0)] {
            let lightness = lightness(|at| ColorMap::Diverging.color(at), from, to);
            assert!(is_uniform(&lightness), "{to} {:?}", steps(&lightness));
        }
    }

    #[test]
    fn a_rainbow_and_a_gamma_are_caught() {
        let rainbow = |at: f64| colorous::RAINBOW.eval_continuous(at).as_array();
        assert!(!is_uniform(&lightness(rainbow, 0.0, 1.0)));
        let bent = |at: f64| ColorMap::Sequential.color(at.powf(1.6));
        assert!(!is_uniform(&lightness(bent, 0.0, 1.0)));
    }

    /// The largest difference of lightness and chroma between the two sides.
    fn asymmetry(color: impl Fn(f64) -> [u8; 3]) -> f64 {
        (0..=STEPS)
            .map(|k| {
                let side = 0.5 * k as f64 / STEPS as f64;
                let [below, above] = [color(0.5 - side), color(0.5 + side)].map(lab);
                let chroma = |lab: [f64; 3]| lab[1].hypot(lab[2]);
                (below[0] - above[0])
                    .abs()
                    .max((chroma(below) - chroma(above)).abs())
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_diverging_map_is_symmetric_about_a_grey() {
        let map = |at| ColorMap::Diverging.color(at);
        assert!(asymmetry(map) < 1.0, "{}", asymmetry(map));
        let [_, a, b] = lab(map(0.5));
        assert!(a.hypot(b) < 1.0);
        // Planted: the middle is not where the sides meet.
        assert!(asymmetry(|at| map(at * 0.95)) > 3.0);
    }

    #[test]
    fn the_diverging_map_is_within_srgb() {
        for k in 0..=200 {
            let side = f64::from(k) / 100.0 - 1.0;
            let hue = DIVERGING_HUES_DEG[usize::from(side > 0.0)].to_radians();
            let chroma = DIVERGING_CHROMA * side.abs();
            let lightness = DIVERGING_L.0 + (DIVERGING_L.1 - DIVERGING_L.0) * side.abs();
            let linear = linear_of_lab([lightness, chroma * hue.cos(), chroma * hue.sin()]);
            assert!(
                linear.iter().all(|x| (-1e-4..=1.0001).contains(x)),
                "{side} {linear:?}"
            );
        }
    }

    #[test]
    fn cielab_has_its_published_values() {
        let near = |color, wanted: [f64; 3]| {
            let got = lab(color);
            (0..3).all(|k| (got[k] - wanted[k]).abs() < 0.02)
        };
        assert!(near([255; 3], [100.0, 0.0, 0.0]));
        assert!(near([255, 0, 0], [53.24, 80.09, 67.20]));
        assert!(near([0, 0, 255], [32.30, 79.19, -107.86]));
        assert!(!near([0, 0, 255], [32.30, 79.19, -107.0]));
    }
}
