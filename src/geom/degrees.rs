//! Serde adapter for angles: degrees in files, radians in memory. For `#[serde(with = "degrees")]`.
//!
//! Degrees are rounded to 10⁻⁹, so that 30° is written as 30 and read back as the radians of 30°. What is read from a
//! file is written back the same.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::ops::RangeInclusive;

/// Degrees from radians, rounded to 10⁻⁹ as in files.
pub fn rounded(radians: f64) -> f64 {
    (radians.to_degrees() * 1e9).round() / 1e9
}

/// Serializes angles in radians as degrees.
///
/// # Errors
/// Errors of the serializer.
pub fn serialize<T: HasAngles + Serialize, S: Serializer>(
    radians: &T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    radians.each(&rounded).serialize(serializer)
}

/// Deserializes angles in degrees as radians.
///
/// # Errors
/// Errors of the deserializer; angles that are not finite or outside of −3600° to 3600°.
pub fn deserialize<'de, T: HasAngles + Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    const SANE: RangeInclusive<f64> = -3600.0..=3600.0;
    let degrees = T::deserialize(deserializer)?;
    let mut strange = None;
    degrees.visit(&mut |angle| {
        if !SANE.contains(&angle) {
            strange = Some(angle);
        }
    });
    match strange {
        Some(angle) => Err(serde::de::Error::custom(format!(
            "an angle of {angle}°; expected −3600 to 3600"
        ))),
        None => Ok(degrees.each(&f64::to_radians)),
    }
}

/// A value that holds angles: one, a pair, a list, or none.
pub trait HasAngles: Sized {
    /// A copy with `change` applied to every angle.
    fn each(&self, change: &impl Fn(f64) -> f64) -> Self;

    /// Calls `look` with every angle in turn.
    fn visit(&self, look: &mut impl FnMut(f64));
}

impl HasAngles for f64 {
    fn each(&self, change: &impl Fn(f64) -> f64) -> Self {
        change(*self)
    }

    fn visit(&self, look: &mut impl FnMut(f64)) {
        look(*self);
    }
}

impl HasAngles for [f64; 2] {
    fn each(&self, change: &impl Fn(f64) -> f64) -> Self {
        self.map(change)
    }

    fn visit(&self, look: &mut impl FnMut(f64)) {
        self.iter().copied().for_each(look);
    }
}

impl HasAngles for Vec<f64> {
    fn each(&self, change: &impl Fn(f64) -> f64) -> Self {
        self.iter().copied().map(change).collect()
    }

    fn visit(&self, look: &mut impl FnMut(f64)) {
        self.iter().copied().for_each(look);
    }
}

impl<T: HasAngles> HasAngles for Option<T> {
    fn each(&self, change: &impl Fn(f64) -> f64) -> Self {
        self.as_ref().map(|angles| angles.each(change))
    }

    fn visit(&self, look: &mut impl FnMut(f64)) {
        if let Some(angles) = self {
            angles.visit(look);
        }
    }
}

#[cfg(test)]
mod tests {
    use serde::{Deserialize, Serialize};

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Angles {
        #[serde(with = "super")]
        one: f64,
        #[serde(with = "super")]
        many: Vec<f64>,
        #[serde(with = "super")]
        ends: Option<[f64; 2]>,
    }

    #[test]
    fn round_degrees_are_written_round_and_read_back_the_same() {
        for deg in 0..=90 {
            let angles = Angles {
                one: f64::from(deg).to_radians(),
                many: vec![-f64::from(deg).to_radians(), 0.1234],
                ends: Some([0.0, f64::from(deg).to_radians()]),
            };
            let text = serde_json::to_string(&angles).expect("is written");
            assert!(text.starts_with(&format!(r#"{{"one":{deg}.0,"#)), "{text}");
            let read: Angles = serde_json::from_str(&text).expect("is read");
            assert_eq!(read.one, angles.one);
            assert_eq!(read.ends, angles.ends);
            assert!((read.many[1] - 0.1234).abs() < 1e-11);
            assert_eq!(serde_json::to_string(&read).expect("is written"), text);
        }
        let none: Angles =
            serde_json::from_str(r#"{"one": 1, "many": [], "ends": null}"#).expect("is read");
        assert_eq!(none.ends, None);
        let wild = serde_json::from_str::<Angles>(r#"{"one": 1e300, "many": [], "ends": null}"#);
        assert!(wild.expect_err("wild").to_string().contains("an angle of"));
    }
}
