//! Fits as JSON: one line per fit, numbers as the shortest text that reads back as the same f64.

use super::record::{FitEntry, FitRecord, SourceFile, StageRecord};
use crate::brdf::{self, Brdf, ParamId, all_params};
use crate::fit::options::Bounds;
use crate::fit::outcome::ALBEDO_ANGLES;
use crate::fit::{EndReason, Errors, FitOptions, Partial, Stage, Weight};
use crate::geom::Rgb;
use crate::json;
use crate::keys;
use crate::quote::said;
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Writes a fit file: an array with an object per fit.
///
/// # Errors
/// Errors of the writer.
pub fn write_json(fits: &[FitRecord], out: &mut dyn Write) -> io::Result<()> {
    write!(out, "[")?;
    for (index, fit) in fits.iter().enumerate() {
        out.write_all(if index == 0 { b"\n  " } else { b",\n  " })?;
        serde_json::to_writer(&mut *out, &Object::from(fit))?;
    }
    writeln!(out, "\n]")
}

/// JSON object of a fit in a fit file.
pub fn to_value(fit: &FitRecord) -> Value {
    // Numbers and texts under keys that are texts: nothing that JSON lacks.
    serde_json::to_value(Object::from(fit)).unwrap_or_default()
}

/// Reads the JSON object of a fit.
///
/// # Errors
/// Says why it has no model, or which key is missing or not understood.
pub fn from_value(value: Value) -> Result<FitRecord, String> {
    let brdf = brdf::json::from_value(&value).map_err(|error| error.to_string())?;
    let object =
        Object::deserialize(value).map_err(|error| format!("not a fit: {}", said(&error)))?;
    let record = object.into_record(brdf);
    record.ok_or_else(|| "not a fit: a stage, an angle, the weight or the end is unknown".into())
}

/// Entries of a text that holds one object or an array of them: fits, plain models, or both.
///
/// # Errors
/// Says where the text is no JSON, or which entry has no model and why. Other keys of an entry are used where they are
/// understood and ignored where not.
pub fn entries(text: &str) -> Result<Vec<FitEntry>, String> {
    let mut found = Vec::new();
    let keys = keys::names::<Object>();
    let is_known = |key: &str| keys.contains(&key) || brdf::json::is_key(key);
    json::entries(text, &is_known, &mut |at, value| {
        let entry = entry(value).map_err(|what| match at {
            Some(at) => format!("entry {at}: {what}"),
            None => what,
        })?;
        found.push(entry);
        Ok(())
    })?;
    if found.is_empty() {
        return Err("the array of models is empty".into());
    }
    found.shrink_to_fit();
    Ok(found)
}

fn entry(value: Value) -> Result<FitEntry, String> {
    let brdf = brdf::json::from_value(&value).map_err(|error| error.to_string())?;
    let text = |key: &str| value.get(key).and_then(Value::as_str).map(str::to_owned);
    Ok(FitEntry {
        brdf,
        material: text("material")
            .map(|name| name.replace(char::is_control, " "))
            .filter(|name| !name.trim().is_empty()),
        source: value
            .get("source")
            .and_then(|source| SourceFile::deserialize(source).ok()),
        error: value.get("error").and_then(Value::as_f64),
        fit: Object::deserialize(value)
            .ok()
            .and_then(|object| object.into_record(brdf))
            .map(Box::new),
    })
}

/// JSON object of a fit: its keys in the order in which they are written.
#[derive(Serialize, Deserialize)]
struct Object {
    material: String,
    source: Option<SourceFile>,
    program: String,
    version: String,
    options: OptionsObject,
    /// `model`, `fresnel` and a key per parameter, read before the rest; see [`brdf::json`].
    #[serde(flatten, skip_deserializing)]
    brdf: Option<Keys>,
    error: f64,
    error_grazing: Option<f64>,
    error_channels: [Option<f64>; 3],
    stages: Vec<StageObject>,
    albedo: BTreeMap<String, Rgb>,
    albedo_above_one: bool,
    evaluations: usize,
    ended_because: String,
    concerns: Vec<String>,
}

#[derive(Serialize, Deserialize)]
struct OptionsObject {
    weight: String,
    limit: f64,
    stages: Vec<usize>,
    start: Keys,
    held: Keys,
    bounds: Keys,
}

#[derive(Serialize, Deserialize)]
struct StageObject {
    stage: usize,
    start_error: f64,
    error: f64,
    evaluations: usize,
    parameters: Keys,
}

/// A JSON object whose keys keep their order.
struct Keys(Vec<(String, Value)>);

impl Serialize for Keys {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (key, value) in &self.0 {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for Keys {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let map = serde_json::Map::deserialize(deserializer)?;
        Ok(Self(map.into_iter().collect()))
    }
}

impl Keys {
    /// A key per parameter; null where `value` gives none, and where the parameter does not count.
    fn per_parameter(brdf: &Brdf, value: impl Fn(ParamId) -> Option<Value>) -> Self {
        let of = |id: ParamId| value(id).filter(|_| brdf.uses(id)).unwrap_or_default();
        let rows = brdf::json::rows(brdf.model);
        let keys = rows.map(|row| (row.key().to_owned(), of(row.id)));
        Self(keys.collect())
    }

    fn of_values(values: &Partial, brdf: &Brdf) -> Self {
        Self::per_parameter(brdf, |id| match values.get(id) {
            [] => None,
            [one] => Some((*one).into()),
            many => Some(many.into()),
        })
    }

    fn of_parameters(brdf: &Brdf) -> Self {
        Self::per_parameter(brdf, |id| Some(brdf::json::parameter(brdf, id)))
    }

    fn of_bounds(options: &FitOptions, brdf: &Brdf) -> Self {
        Self::per_parameter(brdf, |id| {
            let (low, high) = options.bounds_of(brdf.model.param(id)?);
            Some([low, high].as_slice().into())
        })
    }

    fn of_brdf(brdf: &Brdf) -> Self {
        let mut keys = vec![
            ("model".into(), brdf.model.key.into()),
            ("fresnel".into(), brdf.fresnel.key().into()),
        ];
        keys.extend(Self::of_parameters(brdf).0);
        Self(keys)
    }

    fn get<'de, T: Deserialize<'de>>(&'de self, id: ParamId) -> Option<T> {
        let (_, value) = self.0.iter().find(|(key, _)| key == id.key())?;
        T::deserialize(value).ok()
    }

    fn values(&self) -> Partial {
        let shared = all_params().filter(|row| !row.id.is_color());
        let shared = shared.filter_map(|row| Some((row.id, self.get(row.id)?)));
        Partial {
            rho_d: self.get(ParamId::RHO_D),
            k_s: self.get(ParamId::K_S),
            shared: shared.collect(),
        }
    }

    /// Bounds that are not those of the model's rows.
    fn bounds(&self, brdf: &Brdf) -> BTreeMap<ParamId, Bounds> {
        let rows = brdf.model.rows();
        let bounds = rows.filter_map(|row| {
            let bounds: Bounds = self.get(row.id)?;
            (bounds != row.bounds).then_some((row.id, bounds))
        });
        bounds.collect()
    }
}

impl From<&FitRecord> for Object {
    fn from(fit: &FitRecord) -> Self {
        let (brdf, options) = (&fit.brdf, &fit.options);
        let finite = |error: f64| error.is_finite().then_some(error);
        let stages = fit.stages.iter().map(|stage| StageObject {
            stage: stage.stage.number(),
            start_error: stage.start_error,
            error: stage.error,
            evaluations: stage.evaluations,
            parameters: Keys::of_parameters(&Brdf {
                params: stage.params,
                ..*brdf
            }),
        });
        Self {
            material: fit.material.clone(),
            source: fit.source.clone(),
            program: env!("CARGO_PKG_NAME").into(),
            version: fit.version.clone(),
            options: OptionsObject {
                weight: fit.weight.key().into(),
                limit: fit.limit_deg,
                stages: options.stages.iter().map(Stage::number).collect(),
                start: Keys::of_values(&options.start, brdf),
                held: Keys::of_values(&options.held, brdf),
                bounds: Keys::of_bounds(options, brdf),
            },
            brdf: Some(Keys::of_brdf(brdf)),
            error: fit.errors.total,
            error_grazing: fit.errors.grazing.and_then(finite),
            error_channels: fit.errors.channels.map(finite),
            stages: stages.collect(),
            albedo: ALBEDO_ANGLES
                .map(angle_key)
                .into_iter()
                .zip(fit.albedo)
                .collect(),
            albedo_above_one: fit.exceeds_one(),
            evaluations: fit.evaluations,
            ended_because: fit.ended.key().into(),
            concerns: fit.concerns.clone(),
        }
    }
}

/// Key of an albedo: the angle in degrees.
pub(super) fn angle_key(degrees: f64) -> String {
    format!("{degrees}")
}

impl Object {
    /// Record of the fit; `None` where a stage, an angle, the weight or the end is unknown. `brdf` is the model that
    /// the object was read as.
    fn into_record(self, brdf: Brdf) -> Option<FitRecord> {
        let stages = self.options.stages.into_iter().map(Stage::by_number);
        let options = FitOptions {
            stages: stages.collect::<Option<_>>()?,
            start: self.options.start.values(),
            held: self.options.held.values(),
            bounds: self.options.bounds.bounds(&brdf),
        };
        let stage = |stage: StageObject| {
            Some(StageRecord {
                stage: Stage::by_number(stage.stage)?,
                start_error: stage.start_error,
                error: stage.error,
                evaluations: stage.evaluations,
                params: stage.parameters.values().over(brdf).params,
            })
        };
        let [Some(a), Some(b), Some(c)] =
            ALBEDO_ANGLES.map(|angle| self.albedo.get(&angle_key(angle)).copied())
        else {
            return None;
        };
        Some(FitRecord {
            material: self.material,
            source: self.source,
            version: self.version,
            weight: Weight::by_key(&self.options.weight)?,
            limit_deg: self.options.limit,
            options,
            brdf,
            errors: Errors {
                total: self.error,
                grazing: self.error_grazing,
                channels: self.error_channels.map(|error| error.unwrap_or(f64::NAN)),
            },
            stages: self.stages.into_iter().map(stage).collect::<Option<_>>()?,
            albedo: [a, b, c],
            evaluations: self.evaluations,
            ended: [EndReason::Converged, EndReason::Limit, EndReason::Cancelled]
                .into_iter()
                .find(|ended| ended.key() == self.ended_because)?,
            concerns: self.concerns,
        })
    }
}
