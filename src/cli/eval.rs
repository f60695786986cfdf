//! `grazing eval SOURCE --directions FILE.csv`: f_r at given directions.

use super::CliError;
use crate::files::directions::{self, Directions};
use crate::files::{self, write_atomically};
use crate::geom::Rgb;
use crate::measured::Lookup;
use crate::measured::lookup::LOOKUPS;
use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser as _;
use glam::DVec3;
use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::PathBuf;

/// The columns that are added.
const ADDED: [&str; 3] = ["r", "g", "b"];

/// Evaluate f_r at directions from a CSV file
///
/// Prints the same rows with f_r in 1/sr added as r, g, b: empty below the horizon and where nothing was measured.
#[derive(clap::Args)]
pub struct Args {
    /// MERL file, fit file, or JSON file with a model or an array of models
    source: PathBuf,
    /// CSV file with columns theta_i, phi_i, theta_o, phi_o in degrees; - is standard input
    #[arg(long, value_name = "FILE")]
    directions: PathBuf,
    /// How a value is taken from a measured table
    #[arg(long, default_value = Lookup::default().key(), value_parser = lookup_parser())]
    lookup: Lookup,
    /// Which model of an array or fit file, counted from 0; `grazing info` lists them
    #[arg(long, default_value_t = 0, value_name = "K")]
    index: usize,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Write a file instead of printing
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Replace the output file if it exists
    #[arg(long, requires = "output")]
    force: bool,
}

pub(super) fn lookup_parser() -> impl clap::builder::TypedValueParser<Value = Lookup> {
    PossibleValuesParser::new(LOOKUPS.map(Lookup::key))
        .map(|key| Lookup::by_key(&key).unwrap_or_default())
}

pub fn run(args: &Args, out: &mut dyn Write) -> Result<(), CliError> {
    let output = args.output.as_deref();
    super::spare_inputs("eval", output, &[&args.source, &args.directions])?;
    // Everything is checked before anything is written: a bad row leaves no half output.
    let directions = directions::read(&args.directions, &ADDED)?;
    let source = files::open_source(&args.source, args.index, &mut |_| ControlFlow::Continue(()))?;
    let value = |wi, wo| source.eval(wi, wo, args.lookup);
    let print = |out: &mut dyn Write| {
        if args.json {
            write_json(&directions, &value, out)
        } else {
            write_csv(&directions, &value, out)
        }
    };
    match &args.output {
        Some(path) => write_atomically(path, args.force, |file| print(file))?,
        None => print(out)?,
    }
    Ok(())
}

fn write_csv(
    directions: &Directions,
    value: &dyn Fn(DVec3, DVec3) -> Option<Rgb>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer
        .write_record(directions.header.iter().chain(ADDED))
        .map_err(io_error)?;
    directions.for_each(|row, wi, wo| {
        let added = match value(wi, wo) {
            Some(f_r) => f_r.map(shortest),
            None => [const { String::new() }; 3],
        };
        writer
            .write_record(row.iter().chain(added.iter().map(String::as_str)))
            .map_err(io_error)
    })?;
    writer.flush()
}

/// The error of the writer below; csv's own conversion hides its kind.
fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// An array of objects: the angles and f_r as numbers, r, g, b null where empty, other columns as texts.
fn write_json(
    directions: &Directions,
    value: &dyn Fn(DVec3, DVec3) -> Option<Rgb>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let text = |text: &str| serde_json::Value::from(text).to_string();
    write!(out, "[")?;
    let mut comma = "";
    directions.for_each(|row, wi, wo| {
        write!(out, "{comma}\n  {{")?;
        comma = ",";
        for (column, (title, field)) in directions.header.iter().zip(row).enumerate() {
            let angle = directions.columns.contains(&column);
            match field.trim().parse::<f64>() {
                Ok(degrees) if angle => {
                    write!(out, "{}: {}, ", text(title.trim()), shortest(degrees))?;
                }
                _ => write!(out, "{}: {}, ", text(title), text(field))?,
            }
        }
        let value = value(wi, wo);
        for (channel, name) in ADDED.into_iter().enumerate() {
            let value = value.map_or("null".into(), |f_r| shortest(f_r[channel]));
            let comma = if channel == 0 { "" } else { ", " };
            write!(out, "{comma}\"{name}\": {value}")?;
        }
        write!(out, "}}")
    })?;
    writeln!(out, "\n]")
}

/// The shortest text that reads back as the same number.
fn shortest(value: f64) -> String {
    format!("{value:?}")
}
