//! JSON of others, read in bounded memory: whatever a text holds, no more of it is kept than what is asked for.

use crate::quote::said;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Number, Value};
use std::cell::Cell;
use std::fmt;

/// Bytes of memory that one entry of an array takes at most: a fit takes a hundredth of it.
const MOST_OF_ENTRY: usize = 4 << 20;

/// Bytes of memory that a model inside something else takes at most.
pub const MOST_OF_MODEL: usize = 1 << 20;

/// Bytes that a value takes beside what is in it.
const VALUE: usize = size_of::<Value>();
/// Bytes that an object with a key takes, and each further key: its nodes have room for eleven.
const OBJECT: usize = 640;
const KEY: usize = 128;

const TOO_MUCH: &str = "there are far more values in it than are read";

/// What is wrong with a JSON text, in one sentence.
pub fn problem(error: &serde_json::Error) -> String {
    if error.is_data() {
        said(error)
    } else {
        format!("not valid JSON: {error}")
    }
}

/// The value of a text, in at most about `most` bytes of memory.
///
/// # Errors
/// One sentence: where the text is no JSON, or that more is in it.
pub fn value(text: &str, most: usize) -> Result<Value, String> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    bounded(&mut deserializer, most)
        .and_then(|value| deserializer.end().map(|()| value))
        .map_err(|error| problem(&error))
}

/// The value of a deserializer, in at most about `most` bytes of memory.
///
/// # Errors
/// Errors of the deserializer, and one that says that more is in it.
pub fn bounded<'de, D: Deserializer<'de>>(deserializer: D, most: usize) -> Result<Value, D::Error> {
    Within::new(&Cell::new(most), &|_| true).deserialize(deserializer)
}

/// Which of these keys the object of a text has, as far as the text is JSON; none where it is no object.
pub fn has_keys<const N: usize>(text: &str, wanted: [&str; N]) -> [bool; N] {
    let mut found = [false; N];
    if text.trim_start().starts_with('{') {
        let mut deserializer = serde_json::Deserializer::from_str(text);
        // A text that is cut off has the keys up to there.
        let _ = deserializer.deserialize_map(TopKeys(wanted, &mut found));
    }
    found
}

/// Calls `each` with the entries of an array one after the other, each with its position, or with the only value where the
/// text is no array. Keys of an entry for which `is_known` says no have null in place of their value. Ends with the first
/// error.
///
/// # Errors
/// Those of `each`; one sentence where the text is no JSON or there is too much in an entry.
pub fn entries(
    text: &str,
    is_known: &dyn Fn(&str) -> bool,
    each: &mut dyn FnMut(Option<usize>, Value) -> Result<(), String>,
) -> Result<(), String> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let mut entries = Entries {
        is_known,
        each,
        failure: None,
        at: None,
    };
    let read = if text.trim_start().starts_with('[') {
        deserializer.deserialize_seq(&mut entries)
    } else {
        Within::new(&Cell::new(MOST_OF_ENTRY), is_known)
            .deserialize(&mut deserializer)
            .and_then(|value| entries.take(value))
    };
    let read = read.and_then(|()| deserializer.end());
    let Entries { failure, at, .. } = entries;
    match (failure, read) {
        (Some(what), _) => Err(what),
        (None, Ok(())) => Ok(()),
        (None, Err(error)) => Err(match at.filter(|_| error.is_data()) {
            Some(index) => format!("entry {index}: {}", problem(&error)),
            None => problem(&error),
        }),
    }
}

/// A value within the bytes that are left; an object has null for the values of keys that are not known.
#[derive(Clone, Copy)]
struct Within<'b> {
    left: &'b Cell<usize>,
    is_known: &'b dyn Fn(&str) -> bool,
}

impl<'b> Within<'b> {
    fn new(left: &'b Cell<usize>, is_known: &'b dyn Fn(&str) -> bool) -> Self {
        Self { left, is_known }
    }

    /// All of what is inside.
    fn inside(self) -> Self {
        Self::new(self.left, &|_| true)
    }

    fn take<E: Error>(self, bytes: usize) -> Result<(), E> {
        let left = self.left.get().checked_sub(bytes);
        self.left.set(left.ok_or_else(|| E::custom(TOO_MUCH))?);
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for Within<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Within<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("any JSON value")
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        Ok(Number::from_f64(value).map_or(Value::Null, Value::Number))
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        self.take(value.len())?;
        Ok(value.into())
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_none<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        self.deserialize(deserializer)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = items.next_element_seed(self.inside())? {
            self.take(VALUE)?;
            values.push(value);
        }
        Ok(values.into())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let mut found = Map::new();
        while let Some(key) = map.next_key::<String>()? {
            let room = if found.is_empty() { OBJECT } else { KEY };
            self.take(room + key.len())?;
            let value = if (self.is_known)(&key) {
                map.next_value_seed(self.inside())?
            } else {
                map.next_value::<IgnoredAny>()?;
                Value::Null
            };
            found.insert(key, value);
        }
        Ok(found.into())
    }
}

/// The entries of an array.
struct Entries<'a> {
    is_known: &'a dyn Fn(&str) -> bool,
    each: &'a mut dyn FnMut(Option<usize>, Value) -> Result<(), String>,
    /// What `each` has said.
    failure: Option<String>,
    /// Position of the entry that is read.
    at: Option<usize>,
}

impl Entries<'_> {
    fn take<E: Error>(&mut self, value: Value) -> Result<(), E> {
        (self.each)(self.at, value).map_err(|what| {
            self.failure = Some(what);
            E::custom("stopped")
        })
    }
}

impl<'de> Visitor<'de> for &mut Entries<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an array")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        for index in 0.. {
            self.at = Some(index);
            let left = Cell::new(MOST_OF_ENTRY);
            let entry = items.next_element_seed(Within::new(&left, self.is_known))?;
            let Some(entry) = entry else { break };
            self.take(entry)?;
        }
        self.at = None;
        Ok(())
    }
}

/// Keys of an object, those that are looked for marked as found. Ends where all are.
struct TopKeys<'k, 'f, const N: usize>([&'k str; N], &'f mut [bool; N]);

impl<'de, const N: usize> Visitor<'de> for TopKeys<'_, '_, N> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(Marked) = map.next_key_seed(Mark(&self.0, self.1))? {
            if self.1.iter().all(|found| *found) {
                return Err(A::Error::custom("all are found"));
            }
            map.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }
}

/// A key that is marked where it is looked for, and not kept.
struct Mark<'m, 'k>(&'m [&'k str], &'m mut [bool]);
struct Marked;

impl<'de> DeserializeSeed<'de> for Mark<'_, '_> {
    type Value = Marked;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Marked, D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl Visitor<'_> for Mark<'_, '_> {
    type Value = Marked;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a key")
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<Marked, E> {
        for (wanted, found) in self.0.iter().zip(self.1) {
            *found |= *wanted == key;
        }
        Ok(Marked)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn all(text: &str) -> Result<Vec<(Option<usize>, Value)>, String> {
        let mut all = Vec::new();
        entries(text, &|key| key != "other", &mut |at, value| {
            all.push((at, value));
            Ok(())
        })?;
        Ok(all)
    }

    #[test]
    fn a_value_is_that_of_serde() {
        for text in [
            "null",
            "[true, -1, 18446744073709551615, 0.1, 1e300, \"a\\u0041\", [], {}]",
            "{\"a\": {\"b\": [1, {\"c\": null}]}, \"a\": 2}",
        ] {
            let plain: Value = serde_json::from_str(text).expect("JSON");
            assert_eq!(value(text, 1 << 20), Ok(plain));
        }
        let said = value("[1, 2", 1 << 20).expect_err("cut off");
        assert!(said.starts_with("not valid JSON: EOF"), "{said}");
        assert!(value("1 2", 1 << 20).is_err());
    }

    #[test]
    fn no_more_is_kept_than_is_allowed() {
        for piece in ["[],", "{\"a\":1},", "\"abcdefgh\",", "0,", "[[[[[[]]]]]],"] {
            let text = format!("[{}0]", piece.repeat(1000));
            assert!(value(&text, 1 << 20).is_ok(), "{piece}");
            let said = value(&text, 1 << 12).expect_err("too much");
            assert!(said.starts_with(TOO_MUCH), "{said}");
        }
    }

    #[test]
    fn entries_come_one_by_one_without_what_is_not_known() {
        let found = all("[{\"a\": 1, \"other\": [1, 2]}, 3]").expect("entries");
        let expected = [
            (Some(0), json!({"a": 1, "other": null})),
            (Some(1), json!(3)),
        ];
        assert_eq!(found, expected);
        assert_eq!(
            all(" {\"a\": {\"other\": 1}}"),
            Ok(vec![(None, json!({"a": {"other": 1}}))])
        );
        assert_eq!(all("[]"), Ok(vec![]));
        let said = all("[1, ").expect_err("cut off");
        assert!(said.starts_with("not valid JSON"), "{said}");
        // However much is in what is not known.
        let much = "[],".repeat(MOST_OF_ENTRY / 16);
        assert!(all(&format!("[{{\"other\": [{much}0]}}]")).is_ok());
        let said = all(&format!("[1, {{\"a\": [{much}0]}}]")).expect_err("too much");
        assert!(said.starts_with("entry 1: there are far more"), "{said}");
    }

    #[test]
    fn keys_are_those_at_the_top_and_not_what_a_text_says() {
        let has = |text: &str| has_keys(text, ["a", "b"]);
        assert_eq!(has(" {\"a\": 1, \"b\": 2}"), [true; 2]);
        assert_eq!(
            has("{\"c\": \"a\", \"d\": {\"a\": 1}, \"b\": 2}"),
            [false, true]
        );
        assert_eq!(has("{\"\\u0061\": 1"), [true, false]);
        assert_eq!(has("[{\"a\": 1}]"), [false; 2]);
        assert_eq!(has(""), [false; 2]);
    }
}
