//! Linear RGB, luminance and the sRGB transfer curve.

use super::Rgb;

/// Relative luminance of linear RGB with the Rec. 709 primaries.
pub fn luminance([r, g, b]: Rgb) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// The exact sRGB curve (IEC 61966-2-1), linear [0, 1] to encoded [0, 1]; values outside are clamped.
pub fn srgb_encode(linear: f64) -> f64 {
    let x = linear.clamp(0.0, 1.0);
    if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * x.powf(1.0 / 2.4) - 0.055
    }
}

/// Inverse of [`srgb_encode`].
pub fn srgb_decode(encoded: f64) -> f64 {
    let x = encoded.clamp(0.0, 1.0);
    if x <= 0.04045 {
        x / 12.92
    } else {
        ((x + 0.055) / 1.055).powf(2.4)
    }
}

/// Linear RGB as 8-bit sRGB.
pub fn srgb_bytes(rgb: Rgb) -> [u8; 3] {
    rgb.map(|x| (255.0 * srgb_encode(x)).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_srgb_curve_has_its_published_values() {
        assert_eq!(srgb_bytes([0.0, 1.0, 0.215_860_5]), [0, 255, 128]);
        assert_eq!(srgb_bytes([-1.0, 7.0, 0.5]), [0, 255, 188]);
        for k in 0..=1000 {
            let x = f64::from(k) / 1000.0;
            assert!((srgb_decode(srgb_encode(x)) - x).abs() < 1e-7);
        }
    }

    #[test]
    fn white_has_luminance_one() {
        assert!((luminance([1.0; 3]) - 1.0).abs() < 1e-15);
    }
}
