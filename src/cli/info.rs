//! `grazing info FILE`: what is in a MERL file, a fit file or a file with models.

use super::CliError;
use crate::files;
use crate::files::fits::FitEntry;
use serde_json::json;
use std::io::Write;
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
    writeln!(
        out,
        "{:<11}  {:>12} {:>12} {:>12}",
        "f_r [1/sr]", "min", "median", "max"
    )?;
    for (channel, s) in channels.iter().zip(&stats) {
        let [min, median, max] = [s.min, s.median, s.max].map(six_digits);
        writeln!(out, "{channel:<11}  {min:>12} {median:>12} {max:>12}")?;
    }
    Ok(())
}

/// A row per model; `index` is what `grazing eval --index` takes.
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
    let material = |entry: &FitEntry| entry.material.clone().unwrap_or("–".into());
    let width = entries.iter().map(|entry| material(entry).chars().count());
    let width = width.chain([8]).max().unwrap_or(0);
    writeln!(out, "index  {:width$}  model        fresnel  E", "material")?;
    for (index, entry) in entries.iter().enumerate() {
        let error = entry
            .error
            .map_or("–".into(), |error| format!("{error:.6}"));
        let (model, fresnel) = (entry.brdf.model.key, entry.brdf.fresnel.key());
        let material = material(entry);
        writeln!(
            out,
            "{index:>5}  {material:width$}  {model:11}  {fresnel:7}  {error}"
        )?;
    }
    Ok(())
}

/// Six significant digits, which is what an f32 holds.
fn six_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    format!("{rounded:?}")
}
