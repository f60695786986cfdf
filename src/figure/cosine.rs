//! The cosines that f_r is multiplied by before it is shown.

use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// The cosines that f_r is multiplied by: cos θi gives the radiance under a light of unit strength, cos θo the
/// cosine-corrected BRDF of optics.
/// JSON: `false` for none and `true` for cos θi, as ever, and else `"theta-o"` or `"both"`.
/// In files it is `false` for none and `true` for cos θi, as ever, and else `"theta-o"` or `"both"`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CosineFactor {
    /// Whether by cos θi.
    pub theta_i: bool,
    /// Whether by cos θo.
    pub theta_o: bool,
}

impl CosineFactor {
    /// f_r as it is.
    pub const NONE: Self = Self {
        theta_i: false,
        theta_o: false,
    };
    /// f_r cos θi.
    pub const THETA_I: Self = Self {
        theta_i: true,
        theta_o: false,
    };
    /// f_r cos θo.
    pub const THETA_O: Self = Self {
        theta_i: false,
        theta_o: true,
    };
    /// f_r cos θi cos θo.
    pub const BOTH: Self = Self {
        theta_i: true,
        theta_o: true,
    };

    /// The factor for a pair of directions, from their cosines.
    pub fn of(self, cos_theta_i: f64, cos_theta_o: f64) -> f64 {
        let i = if self.theta_i { cos_theta_i } else { 1.0 };
        let o = if self.theta_o { cos_theta_o } else { 1.0 };
        i * o
    }

    /// Suffix of `f_{r}` in a title, in the markup of [`super::text`].
    pub fn markup(self) -> &'static str {
        match self {
            Self::NONE => "",
            Self::THETA_I => " cos θ_{i}",
            Self::THETA_O => " cos θ_{o}",
            Self::BOTH => " cos θ_{i} cos θ_{o}",
        }
    }

    /// The quantity as it stands in a table.
    pub fn quantity(self) -> &'static str {
        match self {
            Self::NONE => "f_r",
            Self::THETA_I => "f_r cos theta_i",
            Self::THETA_O => "f_r cos theta_o",
            Self::BOTH => "f_r cos theta_i cos theta_o",
        }
    }
}

impl Serialize for CosineFactor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match *self {
            Self::NONE => serializer.serialize_bool(false),
            Self::THETA_I => serializer.serialize_bool(true),
            Self::THETA_O => serializer.serialize_str("theta-o"),
            Self::BOTH => serializer.serialize_str("both"),
        }
    }
}

impl<'de> Deserialize<'de> for CosineFactor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Factor;

        impl Visitor<'_> for Factor {
            type Value = CosineFactor;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("false, true, \"theta-o\" or \"both\"")
            }

            fn visit_bool<E: Error>(self, theta_i: bool) -> Result<CosineFactor, E> {
                Ok(CosineFactor {
                    theta_i,
                    theta_o: false,
                })
            }

            fn visit_str<E: Error>(self, word: &str) -> Result<CosineFactor, E> {
                match word {
                    "theta-o" => Ok(CosineFactor::THETA_O),
                    "both" => Ok(CosineFactor::BOTH),
                    _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
                }
            }
        }

        deserializer.deserialize_any(Factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_read_as_it_is_written_and_as_it_was_before_it_had_cos_theta_o() {
        for (factor, text, value) in [
            (CosineFactor::NONE, "false", 1.0),
            (CosineFactor::THETA_I, "true", 0.5),
            (CosineFactor::THETA_O, "\"theta-o\"", 0.25),
            (CosineFactor::BOTH, "\"both\"", 0.125),
        ] {
            assert_eq!(serde_json::to_string(&factor).expect("a word"), text);
            assert_eq!(
                serde_json::from_str::<CosineFactor>(text).ok(),
                Some(factor)
            );
            assert_eq!(factor.of(0.5, 0.25), value);
        }
        let error = serde_json::from_str::<CosineFactor>("\"cosine\"").expect_err("no such factor");
        let error = error.to_string();
        assert!(
            error.contains("false, true, \"theta-o\" or \"both\""),
            "{error}"
        );
    }
}
