//! Fits as JSON: one line per fit, numbers as the shortest text that reads back as the same f64.

use super::record::{FitEntry, FitRecord, SourceFile, StageRecord};
use crate::brdf::{self, Brdf, ParamId, Params, PerParam, params};
use crate::fit::options;
use crate::fit::outcome::ALBEDO_ANGLES;
use crate::fit::{EndReason, Errors, FitOptions, Partial, Stage, Weight};
use crate::geom::Rgb;
use crate::json;
use crate::keys;
use crate::quote::said;
use serde::{Deserialize, Serialize};
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
    model: String,
    fresnel: String,
    rho_d: Rgb,
    k_s: Rgb,
    s: f64,
    alpha: Option<f64>,
    eta: Option<f64>,
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
    start: Numbers,
    held: Numbers,
    bounds: Bounds,
}

#[derive(Serialize, Deserialize)]
struct StageObject {
    stage: usize,
    start_error: f64,
    error: f64,
    evaluations: usize,
    parameters: Numbers,
}

/// Parameter values by key; null where there is none.
#[derive(Serialize, Deserialize)]
struct Numbers {
    rho_d: Option<Rgb>,
    k_s: Option<Rgb>,
    s: Option<f64>,
    alpha: Option<f64>,
    eta: Option<f64>,
}

impl Numbers {
    /// Values without those of parameters that do not count for a model.
    fn new(values: &Partial, brdf: &Brdf) -> Self {
        Self {
            rho_d: values.rho_d,
            k_s: values.k_s,
            s: values.s,
            alpha: values.alpha.filter(|_| brdf.uses(ParamId::Alpha)),
            eta: values.eta.filter(|_| brdf.uses(ParamId::Eta)),
        }
    }

    fn of(params: &Params, brdf: &Brdf) -> Self {
        let mut all = Partial::default();
        for row in &params::ALL {
            all.set(row.id, params);
        }
        Self::new(&all, brdf)
    }

    fn values(&self) -> Partial {
        Partial {
            rho_d: self.rho_d,
            k_s: self.k_s,
            s: self.s,
            alpha: self.alpha,
            eta: self.eta,
        }
    }
}

/// Bounds by key, (smallest, largest); null where the model lacks the parameter.
#[derive(Serialize, Deserialize)]
struct Bounds {
    rho_d: Option<(f64, f64)>,
    k_s: Option<(f64, f64)>,
    s: Option<(f64, f64)>,
    alpha: Option<(f64, f64)>,
    eta: Option<(f64, f64)>,
}

impl Bounds {
    fn new(options: &FitOptions, brdf: &Brdf) -> Self {
        let of = |id| {
            let row = brdf.model.param(id).filter(|_| brdf.uses(id))?;
            Some(options.bounds_of(row))
        };
        Self {
            rho_d: of(ParamId::RhoD),
            k_s: of(ParamId::KS),
            s: of(ParamId::S),
            alpha: of(ParamId::Alpha),
            eta: of(ParamId::Eta),
        }
    }

    /// Bounds that are not the default ones.
    fn values(&self) -> PerParam<Option<options::Bounds>> {
        PerParam::from_rows(|row| {
            let bounds = match row.id {
                ParamId::RhoD => self.rho_d,
                ParamId::KS => self.k_s,
                ParamId::S => self.s,
                ParamId::Alpha => self.alpha,
                ParamId::Eta => self.eta,
            };
            bounds.filter(|bounds| *bounds != options::default_bounds(row))
        })
    }
}

impl From<&FitRecord> for Object {
    fn from(fit: &FitRecord) -> Self {
        let (brdf, options) = (&fit.brdf, &fit.options);
        let Numbers { alpha, eta, .. } = Numbers::of(&brdf.params, brdf);
        let finite = |error: f64| error.is_finite().then_some(error);
        let stages = fit.stages.iter().map(|stage| StageObject {
            stage: stage.stage.number(),
            start_error: stage.start_error,
            error: stage.error,
            evaluations: stage.evaluations,
            parameters: Numbers::of(&stage.params, brdf),
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
                start: Numbers::new(&options.start, brdf),
                held: Numbers::new(&options.held, brdf),
                bounds: Bounds::new(options, brdf),
            },
            model: brdf.model.key.into(),
            fresnel: brdf.fresnel.key().into(),
            rho_d: brdf.params.rho_d,
            k_s: brdf.params.k_s,
            s: brdf.params.s,
            alpha,
            eta,
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
            bounds: self.options.bounds.values(),
        };
        let stage = |stage: StageObject| {
            Some(StageRecord {
                stage: Stage::by_number(stage.stage)?,
                start_error: stage.start_error,
                error: stage.error,
                evaluations: stage.evaluations,
                params: stage.parameters.values().over(brdf.params),
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
