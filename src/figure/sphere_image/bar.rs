//! Colour bar of a compared sphere: its ticks, unit and names.

use crate::figure::scale::number;
use crate::figure::text::RichText;
use crate::geom::sphere_error::{DIFFERENCE_LIMIT, RATIO_STOPS, SphereError};

/// Places on the bar, from 0 to 1, and what stands there. A difference is one of luminance before the exposure of
/// `stops`, as seen under the lights; a white diffuse surface that faces one of them has 1.
pub fn error_ticks(error: SphereError, stops: f64) -> Vec<(f32, RichText)> {
    match error {
        SphereError::Difference => (0..=4)
            .map(|k| {
                let place = f64::from(k) / 4.0;
                let value = place * DIFFERENCE_LIMIT * (-stops).exp2();
                let rounded = format!("{value:.2e}").parse().unwrap_or(value);
                (place as f32, RichText::parse(&number(rounded)))
            })
            .collect(),
        SphereError::Ratio => {
            let most = RATIO_STOPS as i32;
            (-most..=most)
                .map(|stop| {
                    let place = 0.5 + 0.5 * f64::from(stop) / RATIO_STOPS;
                    let factor = 2_i32.pow(stop.unsigned_abs());
                    let text = if stop < 0 {
                        format!("1/{factor}")
                    } else {
                        factor.to_string()
                    };
                    (place as f32, RichText::literal(&text))
                })
                .collect()
        }
    }
}

/// Names of the compared quantity: in full and in a word.
pub fn error_names(error: SphereError) -> [&'static str; 2] {
    match error {
        SphereError::Difference => ["|model − measured|", "difference"],
        SphereError::Ratio => ["model / measured", "ratio"],
    }
}

/// The unit of the numbers on the bar.
pub fn error_unit(error: SphereError) -> &'static str {
    match error {
        SphereError::Difference => "white = 1",
        SphereError::Ratio => "factor",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_says_radiance_before_the_exposure_and_factors() {
        let texts = |error, stops| -> Vec<String> {
            let ticks = error_ticks(error, stops).into_iter();
            ticks.map(|(_, text)| text.plain()).collect()
        };
        assert_eq!(
            texts(SphereError::Difference, 0.0),
            ["0", "0.125", "0.25", "0.375", "0.5"]
        );
        assert_eq!(texts(SphereError::Difference, 1.0)[4], "0.25");
        assert_eq!(
            texts(SphereError::Ratio, 3.0),
            ["1/4", "1/2", "1", "2", "4"]
        );
    }
}
