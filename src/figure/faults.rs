//! Faults: values of settings that cannot be drawn, by their keys.
//!
//! Each type of settings has one function, `sanitize`, that brings every value to the nearest that can be drawn and adds
//! those that it changed here. The window takes the values; a figure's spec and the command line are refused with the names.

use crate::geom::degrees::rounded;
use crate::quote;
use std::fmt::Display;

/// Most angles of incidence of one panel: one for each degree.
pub const MOST_ANGLES: usize = 90;
/// Values in 1/sr on an axis are below this.
const HIGHEST: f64 = 1e12;
/// Angles are rounded in files, so that one at an end may come back beyond it.
const ROUNDING: f64 = 1e-9;
/// As many are named in one line.
const NAMED: usize = 4;

/// The values that were not possible, in the order in which they were found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    place: Vec<String>,
    found: Vec<String>,
}

impl Faults {
    /// Looks at what is under a key, or at a position of a list.
    pub fn inside(&mut self, key: impl Into<String>, look: impl FnOnce(&mut Self)) {
        self.place.push(key.into());
        look(self);
        self.place.pop();
    }

    /// Adds a value that is not possible, as JSON has it.
    pub fn add(&mut self, key: &str, value: impl Display, expected: impl Display) {
        let mut place = self.place.clone();
        place.push(key.to_owned());
        self.found.push(format!(
            "{} is {}; expected {expected}",
            place.join("."),
            quote::shown(&value.to_string())
        ));
    }

    /// The first of them in one line.
    ///
    /// # Errors
    /// Names keys and values, and what was expected.
    pub fn result(self) -> Result<(), String> {
        let more = self.found.len().saturating_sub(NAMED);
        let mut text = self.found[..self.found.len() - more].join("; ");
        if more > 0 {
            text += &format!("; and {more} more");
        }
        if text.is_empty() { Ok(()) } else { Err(text) }
    }

    /// Brings a number to a range.
    pub fn number(&mut self, key: &str, value: &mut f64, [low, high]: [f64; 2]) {
        if !(low..=high).contains(value) {
            self.add(key, shown(*value), between([low, high]));
            *value = value.max(low).min(high);
        }
    }

    /// Brings an angle to a range; both in radians.
    pub fn angle(&mut self, key: &str, value: &mut f64, ends: [f64; 2]) {
        let [low, high] = ends;
        if !(low - ROUNDING..=high + ROUNDING).contains(value) {
            self.add(key, shown(rounded(*value)), between(ends.map(rounded)));
        }
        *value = value.max(low).min(high);
    }

    /// Brings angles of incidence to at least one in [0, π/2], and not to more than [`MOST_ANGLES`]; 60° where there is none.
    pub fn angles(&mut self, key: &str, angles: &mut Vec<f64>) {
        let count = angles.len();
        if !(1..=MOST_ANGLES).contains(&count) {
            let expected = format!("1 to {MOST_ANGLES} of them");
            self.inside(key, |faults| faults.add("length", count, expected));
        }
        angles.truncate(MOST_ANGLES);
        if angles.is_empty() {
            angles.push(60f64.to_radians());
        }
        self.inside(key, |faults| {
            for (position, angle) in angles.iter_mut().enumerate() {
                let ends = [0.0, std::f64::consts::FRAC_PI_2];
                faults.angle(&position.to_string(), angle, ends);
            }
        });
    }

    /// Takes back a part of a range of angles that is none; `None` is all of it.
    pub fn window(&mut self, key: &str, window: &mut Option<[f64; 2]>, range: [f64; 2]) {
        let [first, last] = range;
        // As narrow as the wheel makes it.
        let least = 1e-3 * (last - first) / 90.0;
        if let Some([low, high]) = *window {
            let inside = low >= first - ROUNDING && high <= last + ROUNDING;
            if !(inside && high - low >= 0.99 * least) {
                let ends = between(range.map(rounded));
                let expected = format!("two angles from {ends}, the second larger, or null");
                self.add(key, list(&[low, high].map(rounded)), expected);
                *window = None;
            }
        }
    }

    /// Takes back the ends of an axis of values that are none; `None` takes them from the values.
    pub fn limits(&mut self, key: &str, limits: &mut Option<[f64; 2]>) {
        if limits.is_some_and(|limits| !are_limits(limits)) {
            let expected = format!("two values from 0 to {HIGHEST:?}, the second larger, or null");
            self.add(key, list(&limits.unwrap_or_default()), expected);
            *limits = None;
        }
    }
}

fn between([low, high]: [f64; 2]) -> String {
    format!("{} to {}", shown(low), shown(high))
}

/// A number as a person writes it: 85, and not 85.0 or three hundred digits.
fn shown(value: f64) -> String {
    if value == 0.0 || (1e-4..1e9).contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:?}")
    }
}

/// Numbers as JSON has them.
pub fn list(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|value| shown(*value)).collect();
    format!("[{}]", values.join(", "))
}

/// Whether these can be the ends of an axis of values in 1/sr.
pub fn are_limits([low, high]: [f64; 2]) -> bool {
    low >= 0.0 && (1e-12..HIGHEST).contains(&high) && high - low > 1e-6 * high
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn what_is_possible_stays_to_the_last_bit_and_the_rest_is_named() {
        let mut faults = Faults::default();
        let (mut number, mut angle) = (0.1, 90f64.to_radians());
        faults.number("n", &mut number, [0.0, 1.0]);
        faults.angle("a", &mut angle, [0.0, FRAC_PI_2]);
        assert_eq!((number, angle), (0.1, FRAC_PI_2));
        assert_eq!(faults.clone().result(), Ok(()));
        for (value, kept) in [
            (2.0, 1.0),
            (-1.0, 0.0),
            (f64::INFINITY, 1.0),
            (f64::NAN, 0.0),
        ] {
            let (mut faults, mut number) = (Faults::default(), value);
            faults.inside("x", |faults| faults.number("n", &mut number, [0.0, 1.0]));
            assert_eq!(number, kept);
            let said = faults.result().expect_err("is named");
            assert_eq!(said, format!("x.n is {value}; expected 0 to 1"));
        }
    }

    #[test]
    fn a_list_of_angles_has_some_and_not_too_many() {
        for (degrees, kept, said) in [
            (vec![], 1, "t.length is 0"),
            (vec![120.0, 30.0], 2, "t.0 is 120; expected 0 to 90"),
            (vec![30.0; 3000], MOST_ANGLES, "t.length is 3000"),
        ] {
            let mut angles: Vec<f64> = degrees.into_iter().map(f64::to_radians).collect();
            let mut faults = Faults::default();
            faults.angles("t", &mut angles);
            assert_eq!(angles.len(), kept);
            assert!(angles.iter().all(|angle| (0.0..=FRAC_PI_2).contains(angle)));
            let text = faults.result().expect_err("is named");
            assert!(text.starts_with(said), "{text}");
        }
    }

    #[test]
    fn ends_that_are_none_are_taken_back() {
        let mut faults = Faults::default();
        let (mut window, mut limits) = (Some([-0.5, 1.0]), Some([0.0, 4.0]));
        faults.window("w", &mut window, [-PI, PI]);
        faults.limits("l", &mut limits);
        assert_eq!(faults.clone().result(), Ok(()));
        assert!(window.is_some() && limits.is_some());
        for odd in [[1.0, 1.0], [2.0, 1.0], [-4.0, 1.0], [0.0, f64::NAN]] {
            (window, limits) = (Some(odd), Some(odd));
            let mut faults = Faults::default();
            faults.window("w", &mut window, [-PI, PI]);
            faults.limits("l", &mut limits);
            assert_eq!((window, limits), (None, None), "{odd:?}");
            assert_eq!(faults.found.len(), 2);
        }
    }

    #[test]
    fn a_line_names_a_few() {
        let mut faults = Faults::default();
        for k in 0..9 {
            faults.add(&k.to_string(), k, "nothing");
        }
        let said = faults.result().expect_err("is named");
        assert!(
            said.contains("3 is 3") && !said.contains("4 is 4"),
            "{said}"
        );
        assert!(said.ends_with("; and 5 more"), "{said}");
    }
}
