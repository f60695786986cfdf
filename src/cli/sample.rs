//! `grazing sample`: the synthetic materials as files.

use super::CliError;
use crate::files::write_atomically;
use crate::keys;
use crate::measured::{SAMPLES, SyntheticMaterial, merl};
use crate::quote::quoted;
use serde_json::json;
use std::io::Write;
use std::path::PathBuf;

/// Write a synthetic material as a MERL file, or list them
#[derive(clap::Args)]
pub struct Args {
    /// Which material; --list shows them
    #[arg(required_unless_present = "list", requires = "output")]
    name: Option<String>,
    /// File to write
    #[arg(short, long, value_name = "FILE", requires = "name")]
    output: Option<PathBuf>,
    /// Replace the file if it exists
    #[arg(long, requires = "output")]
    force: bool,
    /// List the materials
    #[arg(long, conflicts_with_all = ["name", "output"])]
    list: bool,
    /// Print the list as JSON
    #[arg(long, requires = "list")]
    json: bool,
}

pub fn run(args: &Args, out: &mut dyn Write) -> Result<(), CliError> {
    let (Some(name), Some(output)) = (&args.name, &args.output) else {
        return list(args.json, out);
    };
    let Some(sample) = SyntheticMaterial::by_key(name) else {
        let known: Vec<_> = SAMPLES.iter().map(|sample| sample.key).collect();
        let proposal = keys::did_you_mean(name, known.iter().copied());
        let known = known.join(", ");
        return Err(CliError::Other(format!(
            "unknown sample {}; expected one of {known}{proposal}",
            quoted(name)
        )));
    };
    let table = sample.synthesize();
    Ok(write_atomically(output, args.force, |writer| {
        merl::write(&table, writer)
    })?)
}

fn list(as_json: bool, out: &mut dyn Write) -> Result<(), CliError> {
    if as_json {
        let rows: Vec<_> = SAMPLES
            .iter()
            .map(|s| json!({"key": s.key, "name": s.name, "about": s.about}))
            .collect();
        writeln!(out, "{:#}", json!(rows))?;
        return Ok(());
    }
    let width = SAMPLES.iter().map(|s| s.key.len()).max().unwrap_or(0);
    for sample in &SAMPLES {
        writeln!(out, "{:width$}  {}", sample.key, sample.name)?;
        writeln!(out, "{:width$}  {}", "", sample.about)?;
    }
    Ok(())
}
