//! Error of the model's sphere against the measured one, as a position on a colour map. Twin: `sphere_error` in
//! `gpu/sphere.wgsl`.

use super::Rgb;
use super::color::luminance;
use serde::{Deserialize, Serialize};

/// Measure of error at a point of the sphere; of the luminance of the exposed picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SphereError {
    /// |model − measured|.
    Difference,
    /// log2(model / measured).
    Ratio,
}

/// Difference at the upper end of the colour map, in units of white on the exposed picture.
pub const DIFFERENCE_LIMIT: f64 = 0.5;

/// Absolute value of log2(model / measured) at both ends of the colour map.
pub const RATIO_STOPS: f64 = 2.0;

/// Luminance on the exposed picture below which a point counts as unlit.
pub const NO_LIGHT: f64 = 1e-9;

impl SphereError {
    /// Position on the colour map, in [0, 1], of two radiances on the exposed picture, linear RGB; `None` where neither
    /// is lit.
    pub fn place(self, measured: Rgb, model: Rgb) -> Option<f64> {
        let (measured, model) = (luminance(measured), luminance(model));
        if measured.max(model) < NO_LIGHT {
            return None;
        }
        let place = match self {
            Self::Difference => (model - measured).abs() / DIFFERENCE_LIMIT,
            Self::Ratio => {
                let stops = (model.max(NO_LIGHT) / measured.max(NO_LIGHT)).log2();
                0.5 + 0.5 * stops / RATIO_STOPS
            }
        };
        Some(place.clamp(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_middle_of_the_map_are_where_they_are_said_to_be() {
        let grey = |x: f64| [x; 3];
        let difference = |a, b| SphereError::Difference.place(grey(a), grey(b));
        assert_eq!(difference(0.3, 0.3), Some(0.0));
        let half = difference(0.5, 0.25).expect("lit");
        assert!((half - 0.5).abs() < 1e-12);
        assert_eq!(difference(0.1, 7.0), Some(1.0));
        let ratio = |a, b| SphereError::Ratio.place(grey(a), grey(b)).expect("lit");
        assert!((ratio(0.2, 0.2) - 0.5).abs() < 1e-12);
        assert!((ratio(0.2, 0.4) - 0.75).abs() < 1e-12);
        assert!((ratio(0.4, 0.1) - 0.0).abs() < 1e-12);
        assert_eq!(ratio(0.0, 0.4), 1.0);
        assert_eq!(SphereError::Ratio.place(grey(0.0), grey(0.0)), None);
    }
}
