//! `grazing export SOURCE`: a model as a file for other programs.

use super::CliError;
use crate::files::{self, MODEL_FORMATS, ModelFormat, write_atomically};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser as _};
use std::io::Write;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  grazing export fits.json --index 2 -o teflon.wgsl
          A function `brdf(wi, wo)` with the fitted numbers, to paste into a shader
  grazing export model.json --format glsl
          The same in GLSL, printed
  grazing export fits.json -o teflon-fit.binary
          A MERL file of the model, for programs that read measured materials";

/// Write a model for other programs: as a MERL file, a Disney .brdf file, or a WGSL or GLSL function
///
/// The functions are f_r in 1/sr, without the cosine, of unit vectors in the local frame with z = n. A MERL file holds
/// the model's values at the centres of its 90 × 90 × 180 cells; those below the horizon are invalid.
#[derive(clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Args {
    /// Fit file, or JSON file with a model or an array of models
    source: PathBuf,
    /// File to write; without it a text is printed
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[arg(
        long,
        value_parser = format_parser(),
        help = "What to write, where the extension of the file does not say it: .binary, .brdf, .wgsl, .glsl"
    )]
    format: Option<ModelFormat>,
    /// Which model of an array or fit file, counted from 0; `grazing info` lists them
    #[arg(long, default_value_t = 0, value_name = "K")]
    index: usize,
    /// Replace the output file if it exists
    #[arg(long, requires = "output")]
    force: bool,
}

fn format_parser() -> impl clap::builder::TypedValueParser<Value = ModelFormat> {
    PossibleValuesParser::new(MODEL_FORMATS.map(|f| PossibleValue::new(f.key()).help(f.name())))
        .map(|key| ModelFormat::by_key(&key).unwrap_or(ModelFormat::Wgsl))
}

pub fn run(args: &Args, out: &mut dyn Write) -> Result<(), CliError> {
    let usage = |text: &str| Err(CliError::Usage("export", text.into()));
    let format = match (args.format, &args.output) {
        (Some(format), _) => format,
        (None, Some(path)) => ModelFormat::of_path(path)?,
        (None, None) => return usage("give --format, or --output with an extension that says it"),
    };
    let Some(path) = &args.output else {
        if !format.is_text() {
            return usage("a MERL file is no text; give --output");
        }
        let model = files::open_model(&args.source, args.index)?;
        return Ok(format.write(&model.brdf, model.material.as_deref(), out)?);
    };
    super::spare_inputs("export", [path.as_path()], &[&args.source])?;
    let model = files::open_model(&args.source, args.index)?;
    let material = model.material.as_deref();
    Ok(write_atomically(path, args.force, |file| {
        format.write(&model.brdf, material, file)
    })?)
}
