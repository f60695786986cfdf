//! `grazing info FILE`: what is in a MERL file, a fit file or a file with models.

use super::CliError;
use super::table::{self, Column};
use crate::brdf::{Brdf, ParamId, all_params};
use crate::files;
use crate::files::fits::FitEntry;
use crate::files::names::told_apart;
use crate::measured::ChannelStats;
use serde_json::json;
use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::PathBuf;

/// Say what is in a file: bins, valid cells and ranges of a MERL file; the models of a fit file
#[derive(clap::Args)]
pub struct Args {
    /// MERL file, fit file or JSON file with models
    file: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args, out: &mut dyn Write) -> Result<(), CliError> {
    if let Some(entries) = files::open_models(&args.file)? {
        return models(&entries, args.json, out);
    }
    let table = files::open_table(&args.file, &mut |_| ControlFlow::Continue(()))?;
    let name = files::material_name(&args.file);
    let (bins, cells, valid) = (
        table.grid().phi_d_bins(),
        table.grid().len(),
        table.valid_count(),
    );
    let channels = ["red", "green", "blue"];
    let stats = table.channel_stats();
    if args.json {
        let spreads: serde_json::Map<_, _> = channels
            .iter()
            .zip(&stats)
            .map(|(channel, s)| {
                let spread = json!({"min": s.min, "median": s.median, "max": s.max});
                ((*channel).to_string(), spread)
            })
            .collect();
        let value = json!({
            "name": name, "phi_d_bins": bins, "cells": cells, "valid_cells": valid, "f_r": spreads,
        });
        writeln!(out, "{value:#}")?;
        return Ok(());
    }
    let share = 100.0 * valid as f64 / cells as f64;
    writeln!(out, "name         {name}")?;
    writeln!(out, "φ_d bins     {bins}")?;
    writeln!(out, "cells        {cells}")?;
    writeln!(out, "valid cells  {valid} ({share:.1} %)")?;
    writeln!(out)?;
    let column = |of: fn(&ChannelStats) -> f64| {
        Column::Numbers(stats.iter().map(|s| Some(six_digits(of(s)))).collect())
    };
    let columns = vec![
        (
            "f_r [1/sr]",
            Column::Text(channels.map(String::from).to_vec()),
        ),
        ("min", column(|s| s.min)),
        ("median", column(|s| s.median)),
        ("max", column(|s| s.max)),
    ];
    table::write(columns, out)?;
    Ok(())
}

/// Models of a file.
fn models(entries: &[FitEntry], as_json: bool, out: &mut dyn Write) -> Result<(), CliError> {
    if as_json {
        let row = |(index, entry): (usize, &FitEntry)| {
            json!({
                "index": index, "material": entry.material, "model": entry.brdf.model.key,
                "fresnel": entry.brdf.fresnel.key(), "error": entry.error,
            })
        };
        let rows: Vec<_> = entries.iter().enumerate().map(row).collect();
        writeln!(out, "{:#}", json!(rows))?;
        return Ok(());
    }
    let rows: Vec<ModelRow> = entries
        .iter()
        .map(|entry| ModelRow {
            material: entry.material.clone(),
            path: entry.source.as_ref().map(|source| source.path.clone()),
            brdf: entry.brdf,
            error: entry.error,
        })
        .collect();
    Ok(write_models(&rows, out)?)
}

/// A row of the table of models.
pub(super) struct ModelRow {
    /// Name of the material; `None` where there is none.
    pub material: Option<String>,
    /// Measured file, which tells the material from others of the name.
    pub path: Option<PathBuf>,
    /// The model.
    pub brdf: Brdf,
    /// E of the model; `None` where it is not known.
    pub error: Option<f64>,
}

/// Writes a table of models, a row for each; `index` is what `grazing eval --index` takes.
pub(super) fn write_models(rows: &[ModelRow], out: &mut dyn Write) -> io::Result<()> {
    let keys = |key: fn(&ModelRow) -> &str| {
        Column::Text(rows.iter().map(|row| key(row).to_owned()).collect())
    };
    let mut columns = vec![
        (
            "index",
            Column::Numbers(
                (0..rows.len())
                    .map(|index| Some(index.to_string()))
                    .collect(),
            ),
        ),
        ("material", Column::Text(names(rows))),
        ("model", keys(|row| row.brdf.model.key)),
        ("fresnel", keys(|row| row.brdf.fresnel.key())),
        (
            "E",
            Column::Numbers(
                rows.iter()
                    .map(|row| row.error.map(|error| format!("{error:.6}")))
                    .collect(),
            ),
        ),
    ];
    for param in all_params().filter(|param| !param.id.is_color()) {
        let used = |row: &&ModelRow| row.brdf.uses(param.id);
        if !rows.iter().any(|row| used(&row)) && param.id != ParamId::ETA {
            continue;
        }
        let value = |row: &ModelRow| {
            let value = row.brdf.number(param.id)?;
            row.brdf.uses(param.id).then(|| six_digits(value))
        };
        columns.push((
            param.key(),
            Column::Numbers(rows.iter().map(value).collect()),
        ));
    }
    table::write(columns, out)
}

/// Names of the materials, told apart by their folders where several have the same one.
fn names(rows: &[ModelRow]) -> Vec<String> {
    let named: Vec<_> = rows
        .iter()
        .map(|row| {
            let name = row.material.clone().unwrap_or_else(|| "–".into());
            (name, row.path.clone())
        })
        .collect();
    told_apart(&named)
}

/// Six significant digits, which is what an f32 holds.
fn six_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    format!("{rounded:?}")
}
