//! Differences between a file and what was taken from it: what it says, against what is left of it.

use crate::keys;
use serde_json::Value;

/// Places in a file, as keys with dots between them.
#[derive(Debug, Default, PartialEq)]
pub struct Differences {
    /// Keys that nothing was made of.
    pub unknown: Vec<String>,
    /// Values that are not as they were given.
    pub changed: Vec<String>,
}

/// Compares what a file says with the same written again. A null is no difference, nor is a key that is absent: both
/// ask for what is usual. `skip` names places that have been spoken about.
pub fn differences(given: &Value, kept: &Value, skip: &[String]) -> Differences {
    let mut found = Differences::default();
    compare(given, kept, String::new(), skip, &mut found);
    found
}

fn compare(given: &Value, kept: &Value, at: String, skip: &[String], found: &mut Differences) {
    if skip.contains(&at) {
        return;
    }
    let inside = |key: &str| {
        if at.is_empty() {
            key.to_owned()
        } else {
            format!("{at}.{key}")
        }
    };
    match (given, kept) {
        (Value::Null, _) => {}
        (Value::Object(given), Value::Object(kept)) => {
            for (key, value) in given {
                match kept.get(key) {
                    Some(kept) => compare(value, kept, inside(key), skip, found),
                    None if skip.contains(&inside(key)) => {}
                    None => {
                        let known = kept.keys().map(String::as_str);
                        let meant =
                            keys::nearest(key, known.filter(|key| !given.contains_key(*key)));
                        let proposal = meant.map_or_else(String::new, |meant| {
                            format!(" (did you mean `{meant}`?)")
                        });
                        found.unknown.push(inside(key) + &proposal);
                    }
                }
            }
        }
        (Value::Array(given), Value::Array(kept)) if given.len() == kept.len() => {
            for (index, (given, kept)) in given.iter().zip(kept).enumerate() {
                compare(given, kept, inside(&index.to_string()), skip, found);
            }
        }
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap_or(0.0), b.as_f64().unwrap_or(0.0));
            // Degrees are rounded in the file.
            if (a - b).abs() > 1e-9 * a.abs().max(1.0) {
                found.changed.push(at);
            }
        }
        (given, kept) => {
            if given != kept {
                found.changed.push(at);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn each_place_that_differs_is_named_once() {
        let given = json!({"a": 1, "b": {"c": [1, 2.5, 3], "d": null}, "e": "x", "f": {"g": 0}});
        let kept = json!({"a": 1.0, "b": {"c": [1.0, 2.0, 3.0], "d": 4}, "e": "y", "h": 5});
        let found = differences(&given, &kept, &[]);
        assert_eq!(found.unknown, ["f"]);
        assert_eq!(found.changed, ["b.c.1", "e"]);
        let misspelt = differences(&json!({"a": {"shwn": 1}}), &json!({"a": {"shown": 0}}), &[]);
        assert_eq!(misspelt.unknown, ["a.shwn (did you mean `shown`?)"]);
        let found = differences(&given, &kept, &["b".into(), "f".into()]);
        assert_eq!(found.changed, ["e"]);
        assert!(found.unknown.is_empty());
        assert_eq!(differences(&kept, &kept, &[]), Differences::default());
        let shorter = differences(&json!({"l": [1, 2]}), &json!({"l": [1]}), &[]);
        assert_eq!(shorter.changed, ["l"]);
    }
}
