//! A BRDF as a JSON object: `{"model": …, "fresnel": …, "rho_d": [r,g,b], …}`.
//!
//! Keys of parameters are those of their rows. A parameter that the model does not have may be null or absent;
//! `fresnel` is `none` where absent. Other keys are ignored, so that richer files (a fit with its error, say) open too.

use super::fresnel::{FRESNELS, Fresnel};
use super::model::{Brdf, Model};
use super::models::{COMBINED, MODELS, all_params, param_by_key};
use super::params::{Param, ParamId};
use crate::json;
use crate::keys::{did_you_mean, nearest};
use crate::quote::{quoted, shown};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

/// Error of a JSON value that is no BRDF: one sentence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct BrdfJsonError(String);

/// Reads a BRDF from a JSON object.
///
/// # Errors
/// Names the key that is missing, of the wrong kind or out of range, and what was expected.
pub fn from_value(value: &Value) -> Result<Brdf, BrdfJsonError> {
    let fail = |text: String| Err(BrdfJsonError(text));
    let Some(object) = value.as_object() else {
        return fail(format!(
            "expected a JSON object with a model, found {}",
            kind(value)
        ));
    };
    let model_key = match object.get("model") {
        Some(Value::String(key)) => key,
        Some(other) => return fail(format!("\"model\" must be a text, found {}", kind(other))),
        None => {
            return fail(format!(
                "\"model\" is missing; expected one of {}",
                keys(MODELS.iter().map(|m| m.key))
            ));
        }
    };
    let Some(model) = Model::by_key(model_key) else {
        let known = || MODELS.iter().map(|m| m.key);
        return fail(format!(
            "unknown model {}; expected one of {}{}",
            quoted(model_key),
            keys(known()),
            did_you_mean(model_key, known())
        ));
    };
    let fresnel = match object.get("fresnel") {
        None | Some(Value::Null) => Fresnel::None,
        Some(value) => match value.as_str().and_then(Fresnel::by_key) {
            Some(fresnel) => fresnel,
            None => {
                let known = || FRESNELS.iter().map(|f| f.key());
                return fail(format!(
                    "unknown \"fresnel\" {}; expected one of {}{}",
                    shown(&value.to_string()),
                    keys(known()),
                    did_you_mean(value.as_str().unwrap_or_default(), known())
                ));
            }
        },
    };
    reject_misspelt_keys(object)?;
    reject_parameters_of_others(object, model)?;
    let mut brdf = Brdf::new(model, fresnel);
    for row in brdf.used() {
        let key = row.key();
        let values = brdf.get_mut(row.id);
        let expected = if row.id.is_color() {
            "an array of three numbers"
        } else {
            "a number"
        };
        let found = match object.get(key) {
            None | Some(Value::Null) => {
                let meant = nearest(
                    key,
                    object.keys().map(String::as_str).filter(|key| !is_key(key)),
                );
                let found = meant.map_or_else(String::new, |found| {
                    format!("; there is {}: did you mean `{key}`?", quoted(found))
                });
                return fail(format!(
                    "\"{key}\" ({}) is missing; expected {expected}{found}",
                    row.name
                ));
            }
            Some(found) => found,
        };
        let numbers = match found {
            Value::Array(items) if row.id.is_color() => items.iter().map(Value::as_f64).collect(),
            Value::Number(_) if !row.id.is_color() => {
                Some(vec![found.as_f64().unwrap_or(f64::NAN)])
            }
            _ => None,
        };
        let Some(numbers) = numbers.filter(|numbers| numbers.len() == values.len()) else {
            let found = shown(&found.to_string());
            return fail(format!("\"{key}\" must be {expected}, found {found}"));
        };
        for (to, from) in values.iter_mut().zip(numbers) {
            if !row.accepts(from) {
                let (low, high) = row.domain;
                return fail(format!(
                    "\"{key}\" = {} is out of range; expected {low} to {high}",
                    shown(&from.to_string())
                ));
            }
            *to = from;
        }
    }
    Ok(brdf)
}

/// Rows of the parameters that the JSON of a model has keys for: its own, and those of the combined model, which every file
/// has ever had.
pub fn rows(model: &Model) -> impl Iterator<Item = &'static Param> {
    let known = |model: &Model, row: &Param| model.param(row.id).is_some();
    all_params().filter(move |row| known(model, row) || known(&COMBINED, row))
}

/// JSON object of a BRDF; parameters that do not count are null.
pub fn to_value(brdf: &Brdf) -> Value {
    let mut object = Map::new();
    object.insert("model".into(), brdf.model.key.into());
    object.insert("fresnel".into(), brdf.fresnel.key().into());
    for row in rows(brdf.model) {
        object.insert(row.key().into(), parameter(brdf, row.id));
    }
    Value::Object(object)
}

/// JSON value of a parameter: a number or three; null where it does not count.
pub fn parameter(brdf: &Brdf, id: ParamId) -> Value {
    match brdf.get(id) {
        _ if !brdf.uses(id) => Value::Null,
        [one] => (*one).into(),
        many => many.into(),
    }
}

impl Serialize for Brdf {
    /// Serializes as [`to_value`].
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        to_value(self).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Brdf {
    /// Deserializes as [`from_value`].
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = json::bounded(deserializer, json::MOST_OF_MODEL)?;
        from_value(&value).map_err(serde::de::Error::custom)
    }
}

/// A model as its key, for `#[serde(with = …)]`.
pub mod model_key {
    use super::{MODELS, Model, keys};
    use serde::{Deserialize, Deserializer, Serializer};

    /// Writes the key.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer>(model: &&'static Model, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(model.key)
    }

    /// Reads the key.
    ///
    /// # Errors
    /// Names the keys that there are where it is none of them.
    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<&'static Model, D::Error> {
        let key = String::deserialize(from)?;
        Model::by_key(&key).ok_or_else(|| {
            let known: Vec<String> = MODELS
                .iter()
                .map(|model| format!("`{}`", model.key))
                .collect();
            // As serde says it of an enum, so that the nearest is proposed.
            let known = keys(known.iter().map(String::as_str));
            serde::de::Error::custom(format!("unknown variant `{key}`, expected one of {known}"))
        })
    }
}

/// Reads one BRDF from a JSON text that is an object or an array of objects; `index` counts from 0.
///
/// # Errors
/// Invalid JSON, an index past the end, and the errors of [`from_value`].
pub fn from_text(text: &str, index: usize) -> Result<Brdf, BrdfJsonError> {
    let (mut found, mut count) = (None, None);
    json::entries(text, &is_key, &mut |at, value| {
        count = at.map(|at| at + 1);
        if at.unwrap_or(0) == index {
            found = Some(value);
        }
        Ok(())
    })
    .map_err(BrdfJsonError)?;
    match (found, count) {
        (Some(value), _) => from_value(&value),
        (None, Some(count)) => Err(BrdfJsonError(format!(
            "there is no entry {index}; the array has {count}, counted from 0"
        ))),
        (None, None) if text.trim_start().starts_with('[') => {
            Err(BrdfJsonError("the array of models is empty".into()))
        }
        (None, None) => Err(BrdfJsonError(format!(
            "there is no entry {index}; the file holds a single model, entry 0"
        ))),
    }
}

/// Whether a key of an object is read as a part of a model.
pub fn is_key(key: &str) -> bool {
    ["model", "fresnel"].contains(&key) || param_by_key(key).is_some()
}

/// Rejects values of parameters that the model does not have. Those of the combined model are left alone, as they were in
/// files that are older than the other models.
fn reject_parameters_of_others(
    object: &Map<String, Value>,
    model: &Model,
) -> Result<(), BrdfJsonError> {
    let lacks = |row: &&Param| model.param(row.id).is_none() && COMBINED.param(row.id).is_none();
    let given = |row: &&Param| object.get(row.key()).is_some_and(|value| !value.is_null());
    match all_params().find(|row| lacks(row) && given(row)) {
        Some(row) => Err(BrdfJsonError(format!(
            "{} has no \"{}\"; it has {}",
            model.key,
            row.key(),
            keys(model.rows().map(Param::key))
        ))),
        None => Ok(()),
    }
}

/// Rejects keys that differ from a known one only in capitals, dashes, underscores or spaces, `Fresnel`, `k-s`, and those a
/// letter away from `fresnel`, without which there is none and nobody would be told. Others pass.
fn reject_misspelt_keys(object: &Map<String, Value>) -> Result<(), BrdfJsonError> {
    let bare = |key: &str| key.to_lowercase().replace(['-', '_', ' '], "");
    let rows = all_params().map(Param::key);
    for known in rows.chain(["model", "fresnel"]) {
        let slip = |key: &str| known == "fresnel" && strsim::osa_distance(key, known) == 1;
        let meant = |key: &&String| {
            key.as_str() != known && (bare(key) == bare(known) || slip(key.as_str()))
        };
        if let Some(key) = object.keys().find(meant) {
            return Err(BrdfJsonError(format!(
                "unknown key {}; expected \"{known}\"",
                quoted(key)
            )));
        }
    }
    Ok(())
}

fn keys<'a>(keys: impl Iterator<Item = &'a str>) -> String {
    keys.collect::<Vec<_>>().join(", ")
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "a truth value",
        Value::Number(_) => "a number",
        Value::String(_) => "a text",
        Value::Array(_) => "an array",
        Value::Object(_) => "an object",
    }
}
