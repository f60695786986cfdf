//! Names of enum variants in files and on the command line: serde's names are the only ones, and `key()` and `by_key()`
//! of an enum are derived from them here.

use crate::quote::said;
use serde::Deserialize;
use serde::de::value::{Error, StrDeserializer};
use serde::de::{Deserializer, Error as _, IntoDeserializer, Visitor};
use serde::forward_to_deserialize_any;
use std::fmt;

/// The names that serde gives the variants of an enum, or the keys of a struct, in the order of their declaration; none for
/// another type.
pub fn names<T: Deserialize<'static>>() -> &'static [&'static str] {
    let mut names: &'static [&'static str] = &[];
    // It ends in an error when it has the names; a type that is neither has none.
    let _ = T::deserialize(Names(&mut names));
    names
}

/// The name of the variant at a position, `value as usize` for an enum without data; empty where there is none.
pub fn key_at<T: Deserialize<'static>>(position: usize) -> &'static str {
    names::<T>().get(position).copied().unwrap_or_default()
}

/// The variant without data that serde reads from a name.
pub fn by_key<'a, T: Deserialize<'a>>(key: &'a str) -> Option<T> {
    let text: StrDeserializer<'a, Error> = key.into_deserializer();
    T::deserialize(text).ok()
}

/// How much alike two words are where one may be meant by the other, from 0 to 1, as [`strsim::jaro_winkler`] has it. Dashes
/// and underscores may be left out: it takes little account of a letter more in a short word.
const ALIKE: f64 = 0.8;

/// Bytes of the longest word that is compared with others.
const LONGEST: usize = 64;

/// The known word that is most like an unknown one; `None` where none is.
pub fn nearest<'k>(unknown: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    // A slip is no longer than the word that was meant, and comparing takes time with both lengths.
    if unknown.len() > LONGEST {
        return None;
    }
    let bare = |word: &str| word.to_lowercase().replace(['-', '_', ' '], "");
    let whole = |known: &str| strsim::jaro_winkler(&unknown.to_lowercase(), &known.to_lowercase());
    let alike = |known: &str| strsim::jaro_winkler(&bare(unknown), &bare(known)).max(whole(known));
    known
        .into_iter()
        .filter(|known| known.len() <= LONGEST)
        .map(|known| (alike(known), known))
        .filter(|(alike, _)| *alike >= ALIKE)
        // The first of equals, so that the same word is proposed each time.
        .reduce(|best, next| if next.0 > best.0 { next } else { best })
        .map(|(_, known)| known)
}

/// The end of a sentence about an unknown word: the word that may be meant, or nothing.
pub fn did_you_mean<'k>(unknown: &str, known: impl IntoIterator<Item = &'k str>) -> String {
    nearest(unknown, known).map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
}

/// What serde says, with the key or word that may be meant where it says that one is unknown and what it expected.
pub fn with_proposal(error: &impl fmt::Display) -> String {
    let said = said(error);
    let mut quoted = said.split('`').skip(1).step_by(2);
    let unknown = ["unknown field `", "unknown variant `"];
    let proposal = match quoted.next() {
        Some(word) if unknown.iter().any(|begin| said.contains(begin)) => {
            did_you_mean(word, quoted)
        }
        _ => String::new(),
    };
    said + &proposal
}

/// Takes the names of an enum's variants or of a struct's keys instead of a value.
struct Names<'n>(&'n mut &'static [&'static str]);

impl<'de> Deserializer<'de> for Names<'_> {
    type Error = Error;

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        variants: &'static [&'static str],
        _visitor: V,
    ) -> Result<V::Value, Error> {
        *self.0 = variants;
        Err(Error::custom(""))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        fields: &'static [&'static str],
        _visitor: V,
    ) -> Result<V::Value, Error> {
        *self.0 = fields;
        Err(Error::custom(""))
    }

    fn deserialize_any<V: Visitor<'de>>(self, _visitor: V) -> Result<V::Value, Error> {
        Err(Error::custom(""))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map identifier ignored_any
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::Fresnel;
    use crate::brdf::fresnel::FRESNELS;
    use crate::figure::page::{INKS, Inks, SAME_AXES, SameAxes};
    use crate::figure::scale::RADIAL_SCALES;
    use crate::figure::shown::{SHOWN, Shown};
    use crate::figure::slices::{OVERS, Over, RESIDUALS, Residual};
    use crate::figure::subject::CHANNELS;
    use crate::figure::{Channel, RadialScale, ViewSpec};
    use crate::fit::{WEIGHTS, Weight};
    use crate::measured::Lookup;
    use crate::measured::lookup::LOOKUPS;
    use serde::Serialize;
    use std::fmt::Debug;

    /// Every value has its old word, and reads and writes it.
    fn check<T>(all: &[T], words: &[&str], key: fn(T) -> &'static str)
    where
        T: Copy + Debug + PartialEq + Serialize + for<'a> Deserialize<'a>,
    {
        assert_eq!(names::<T>().len(), all.len());
        assert_eq!(all.len(), words.len());
        for (value, word) in all.iter().zip(words) {
            assert_eq!(key(*value), *word);
            assert_eq!(by_key::<T>(word), Some(*value));
            let json = serde_json::to_string(value).expect("a word");
            assert_eq!(json, format!("\"{word}\""));
        }
        // Planted: the name on screen, another spelling, nothing.
        assert_eq!(by_key::<T>(""), None);
        assert_eq!(by_key::<T>(&words[0].to_uppercase()), None);
    }

    #[test]
    fn the_words_of_files_and_of_the_command_line_are_the_old_ones_and_the_same() {
        check(&FRESNELS, &["none", "exact", "schlick"], Fresnel::key);
        check(&WEIGHTS, &["cells", "solid-angle", "cosine"], Weight::key);
        check(&LOOKUPS, &["nearest", "smooth"], Lookup::key);
        check(
            &RADIAL_SCALES,
            &["linear", "cube-root", "log"],
            RadialScale::key,
        );
        check(&CHANNELS, &["luminance", "r", "g", "b"], Channel::key);
        check(
            &OVERS,
            &["theta-o", "theta-h", "theta-d", "phi-d"],
            Over::key,
        );
        check(&RESIDUALS, &["none", "difference", "ratio"], Residual::key);
        check(
            &SHOWN,
            &["measured", "model", "residual", "ratio"],
            Shown::key,
        );
        check(&SAME_AXES, &["figure", "row", "panel"], SameAxes::key);
        check(&INKS, &["color", "grey"], |inks: Inks| {
            key_at::<Inks>(inks as usize)
        });
    }

    #[test]
    fn a_view_on_paper_is_called_as_in_its_file() {
        for view in ViewSpec::defaults() {
            let value = serde_json::to_value(&view).expect("data");
            let Some(name) = value.as_object().and_then(|object| object.keys().next()) else {
                panic!("a view is an object, not {value}");
            };
            assert_eq!(view.key(), name);
            let read = |text: &str| serde_json::from_str::<ViewSpec>(text).ok();
            assert_eq!(read(&value.to_string()).as_ref(), Some(&view));
            assert_eq!(read(&format!("{{\"{name}\": {{}}}}")).as_ref(), Some(&view));
            // A scatter was written by its name alone before it had settings.
            assert_eq!(read(&format!("\"{name}\"")).as_ref(), Some(&view));
            assert_eq!(
                read(&format!("{{\"{name}\": {{\"no such key\": 1}}}}")),
                None
            );
            assert_eq!(read(&format!("\"{name}s\"")), None);
        }
    }

    #[test]
    fn the_nearest_word_is_proposed_and_nothing_for_a_stranger() {
        let known = ["rho_d", "k_s", "s", "alpha", "eta"];
        for (word, wanted) in [
            ("ks", Some("k_s")),
            ("Alpah", Some("alpha")),
            ("rhod", Some("rho_d")),
            ("shininess", None),
            ("roughness", None),
            ("", None),
        ] {
            assert_eq!(nearest(word, known), wanted, "{word}");
        }
        assert_eq!(did_you_mean("ks", known), "; did you mean `k_s`?");
        assert_eq!(did_you_mean("colour", known), "");
    }

    #[test]
    fn what_serde_says_gets_a_proposal() {
        let said = |text: &str| {
            let error = serde_json::from_str::<ViewSpec>(text).expect_err("is bad");
            with_proposal(&error)
        };
        let field = said(r#"{"lobes": {"theta": [3]}}"#);
        assert!(field.ends_with("; did you mean `theta_i`?"), "{field}");
        let variant = said(r#"{"lobe": {}}"#);
        assert!(variant.ends_with("; did you mean `lobes`?"), "{variant}");
        // Planted: nothing is like it, and an error that is about something else.
        assert!(!said(r#"{"lobes": {"zoom": 3}}"#).contains("did you mean"));
        assert!(!said(r#"{"lobes": {"theta_i": "`x`"}}"#).contains("did you mean"));
    }

    #[test]
    fn what_is_neither_enum_nor_struct_has_no_names() {
        #[derive(Deserialize)]
        struct Pair {
            #[allow(dead_code)]
            one: f64,
            #[serde(rename = "zwei")]
            #[allow(dead_code)]
            two: Option<f64>,
        }
        assert_eq!(names::<Pair>(), ["one", "zwei"]);
        assert!(names::<f64>().is_empty());
        assert_eq!(key_at::<Fresnel>(3), "");
    }
}
