//! The values of the options of `grazing render`: each function says in one line what is wrong and what was expected.

use crate::geom::limits::MAX_EXPOSURE_STOPS;
use crate::geom::sphere::{LIGHT_PRESETS, Light, MAX_LIGHTS};
use crate::quote::{quoted, shown};

/// The lights of a sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Lights(pub Vec<Light>);

/// The name of a preset, or angles in degrees: `THETA,PHI;THETA,PHI`.
pub fn lights(text: &str) -> Result<Lights, String> {
    let text = text.trim();
    if let Some(preset) = LIGHT_PRESETS.iter().find(|preset| preset.key == text) {
        return Ok(Lights((preset.lights)()));
    }
    let names: Vec<&str> = LIGHT_PRESETS.iter().map(|preset| preset.key).collect();
    let names = names.join(", ");
    let angle = |text: &str| {
        let angle = text.trim().parse::<f64>().ok();
        angle.filter(|angle| angle.is_finite())
    };
    let mut lights = Vec::new();
    for part in text.split(';') {
        let angles = part
            .split_once(',')
            .and_then(|(theta, phi)| Some((angle(theta)?, angle(phi)?)));
        let Some((theta_deg, phi_deg)) = angles else {
            return Err(format!(
                "{} is no light; expected {names}, or THETA,PHI[;THETA,PHI…] in degrees",
                quoted(part)
            ));
        };
        if !(0.0..=180.0).contains(&theta_deg) {
            return Err(format!(
                "THETA = {} is out of range; expected 0 to 180",
                shown(&theta_deg.to_string())
            ));
        }
        if phi_deg.abs() > 360.0 {
            return Err(format!(
                "PHI = {} is out of range; expected -360 to 360",
                shown(&phi_deg.to_string())
            ));
        }
        lights.push(Light::from_angles(
            theta_deg.to_radians(),
            phi_deg.to_radians(),
        ));
    }
    if lights.len() > MAX_LIGHTS {
        let count = lights.len();
        return Err(format!(
            "{count} lights are given; expected at most {MAX_LIGHTS}"
        ));
    }
    Ok(Lights(lights))
}

/// Exposure in stops.
pub fn exposure(text: &str) -> Result<f64, String> {
    const MOST: f64 = MAX_EXPOSURE_STOPS;
    match text.trim().parse::<f64>() {
        Ok(stops) if stops.abs() <= MOST => Ok(stops),
        Ok(stops) if !stops.is_nan() => {
            Err(format!("out of range; expected {} to {MOST} stops", -MOST))
        }
        _ => Err(format!("not a number; expected {} to {MOST} stops", -MOST)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::sphere::SphereView;

    #[test]
    fn lights_are_named_or_given_by_their_angles() {
        assert_eq!(
            lights("poster").expect("known").0,
            SphereView::default().lights
        );
        let Lights(two) = lights("90,0; 120,-90").expect("two lights");
        // To the right, and from below behind the sphere: (0, −sin 120°, cos 120°).
        let wanted = [[1.0, 0.0, 0.0], [0.0, -0.75_f64.sqrt(), -0.5]];
        for (light, wanted) in two.iter().zip(wanted) {
            let off = (light.direction - glam::DVec3::from(wanted)).length();
            assert!(off < 1e-12, "{light:?}");
        }
        assert_eq!(two.len(), 2);
        for (bad, said) in [
            ("sun", "\"sun\" is no light; expected poster, glancing"),
            ("", "is no light"),
            ("30", "is no light"),
            ("30,40,50", "is no light"),
            ("30,x", "is no light"),
            ("30,x,40", "is no light"),
            ("30,40;", "is no light"),
            ("181,0", "THETA = 181 is out of range; expected 0 to 180"),
            ("30,400", "PHI = 400 is out of range"),
            ("nan,0", "is no light"),
            (
                "0,0;0,0;0,0;0,0;0,0",
                "5 lights are given; expected at most 4",
            ),
        ] {
            let error = lights(bad).expect_err(bad);
            assert!(error.contains(said), "{bad}: {error}");
        }
    }

    #[test]
    fn exposures_are_sane_numbers() {
        assert_eq!(exposure("-1.5"), Ok(-1.5));
        for bad in ["31", "-inf", "nan", "bright", ""] {
            assert!(exposure(bad).is_err(), "{bad}");
        }
    }
}
