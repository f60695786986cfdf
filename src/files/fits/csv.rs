//! Fits as CSV: a row per fit, empty where a parameter or an error does not exist.

use super::json::angle_key;
use super::record::FitRecord;
use crate::brdf::all_params;
use crate::files::path_text;
use crate::fit::Partial;
use crate::fit::outcome::ALBEDO_ANGLES;
use std::io::{self, Write};

const CHANNELS: [&str; 3] = ["r", "g", "b"];

/// Writes a line of column names and a row per fit.
///
/// # Errors
/// Errors of the writer.
pub fn write_csv(fits: &[FitRecord], out: &mut dyn Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(columns())?;
    for fit in fits {
        writer.write_record(row(fit))?;
    }
    writer.flush()
}

fn columns() -> Vec<String> {
    let colors = |name: String| CHANNELS.map(|channel| format!("{name}_{channel}"));
    let mut columns: Vec<String> = ["material", "model", "fresnel", "error", "error_grazing"]
        .map(String::from)
        .to_vec();
    columns.extend(colors("error".into()));
    for row in all_params() {
        if row.id.is_color() {
            columns.extend(colors(row.key().into()));
        } else {
            columns.push(row.key().into());
        }
    }
    for angle in ALBEDO_ANGLES {
        columns.extend(colors(format!("albedo_{}", angle_key(angle))));
    }
    let rest = [
        "evaluations",
        "ended_because",
        "concerns",
        "path",
        "sha256",
        "weight",
        "limit",
        "stages",
        "start",
        "held",
    ];
    columns.extend(rest.map(String::from));
    columns
}

fn row(fit: &FitRecord) -> Vec<String> {
    let mut row = vec![
        fit.material.clone(),
        fit.brdf.model.key.into(),
        fit.brdf.fresnel.key().into(),
        number(fit.errors.total),
        fit.errors.grazing.map_or(String::new(), number),
    ];
    row.extend(fit.errors.channels.map(number));
    for param in all_params() {
        if fit.brdf.uses(param.id) {
            row.extend(fit.brdf.get(param.id).iter().copied().map(number));
        } else {
            row.push(String::new());
        }
    }
    row.extend(fit.albedo.as_flattened().iter().copied().map(number));
    let (path, sha256) = match &fit.source {
        Some(source) => (
            path_text::cell(&source.path),
            source.sha256.clone().unwrap_or_default(),
        ),
        None => Default::default(),
    };
    let stages = fit.options.stages.iter();
    let stages: Vec<String> = stages.map(|stage| stage.number().to_string()).collect();
    row.extend([
        fit.evaluations.to_string(),
        fit.ended.key().into(),
        fit.concerns.join(" "),
        path,
        sha256,
        fit.weight.key().into(),
        number(fit.limit_deg),
        stages.join(","),
        settings(&fit.options.start, fit),
        settings(&fit.options.held, fit),
    ]);
    row
}

/// Parameter values as they are typed on the command line: `s=30,k_s=1:2:3`.
fn settings(values: &Partial, fit: &FitRecord) -> String {
    let set = fit.brdf.used().filter(|row| values.has(row.id)).map(|row| {
        let numbers: Vec<String> = values.get(row.id).iter().copied().map(number).collect();
        format!("{}={}", row.key(), numbers.join(":"))
    });
    set.collect::<Vec<_>>().join(",")
}

/// Shortest text that reads back as the same number; empty where it is not finite.
fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else {
        String::new()
    }
}
