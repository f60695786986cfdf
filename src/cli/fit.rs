//! `grazing fit FILE…`: parameters of models from measured files.

mod parse;
pub(super) mod progress;

use super::CliError;
use super::info::{ModelRow, write_models};
use super::models::{self, ALL, Models};
use crate::brdf::fresnel::FRESNELS;
use crate::brdf::{Fresnel, Model, ParamId, all_params};
use crate::files::fits::{FitRecord, write_csv, write_json};
use crate::files::{self, FileError, write_atomically};
use crate::fit::{FitOptions, Partial, Problem, StageSet, Variant, WEIGHTS, Weight, fit_all};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser as _};
use progress::Bar;
use std::io::{self, IsTerminal as _, Write};
use std::num::NonZero;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::thread;

const EXAMPLES: &str = "\
Examples:
  grazing fit teflon.binary
          The combined model with Fresnel; the result is printed as JSON
  grazing fit *.binary --model all --fresnel all -o fits.json --csv fits.csv
          Every model of each material; `grazing fits.json` shows them in the window
  grazing fit gold.binary --model combined,ggx,ward
          Three models with the exact Fresnel factor, to compare
  grazing fit nickel.binary --limit 80 --stages 1,2,3 --start s=200,alpha=0.5,eta=1.5
          The published staged fit from a start of your own, without what is beyond 80°
  grazing fit nickel.binary --hold eta=1.5,rho_d=0
          With the index of refraction known and no diffuse part";

/// Fit models to measured materials
///
/// Looks for the parameters of a model that come nearest to each file: those with the smallest error
/// E = Σ w |model − measured| / Σ w measured over all measured cells and R, G, B. With the default weight E is the
/// share of the reflected energy that the model puts in the wrong place, under light from everywhere.
///
/// The result is a JSON array with an object per fit, described in docs/formats.md. A file that cannot be used is reported
/// in one line and the others go on; the exit code is then 1. Where standard error is a terminal, a bar shows how far
/// it is. Ctrl+C ends it, and then nothing is written. Where the result goes to a file and standard output is a terminal, a
/// table of the fits is shown there.
#[derive(clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Args {
    /// MERL files, fitted one after the other
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Which models, with commas between them; all and phong-family stand for several
    #[arg(long, default_value = "combined", value_name = "KEY,…", value_parser = models::parse, help = models::help())]
    model: Models,
    /// Which Fresnel reflectance multiplies the specular term; all fits with each
    #[arg(long, default_value = "exact", value_parser = keys(FRESNELS.map(Fresnel::key)))]
    fresnel: String,
    /// How much a cell counts
    #[arg(long, default_value = Weight::default().key(), value_parser = weight_parser())]
    weight: Weight,
    /// Leave out cells where the light or the viewer is more than this from the normal, in degrees: above 0, at most 90
    #[arg(long, value_name = "DEG", default_value = "90", value_parser = parse::limit, allow_hyphen_values = true)]
    limit: f64,
    /// Which stages are run, always in this order
    ///
    /// 1: rho_d and k_s, exactly. 2: the lobe's parameters and eta. 3: these and k_s. 4: all parameters together, from
    /// several starts. The first three are the staged fit of Nielsen et al. (2014); the fourth is never worse.
    #[arg(long, default_value = "1,2,3,4", value_name = "NUMBERS", value_parser = parse::stages, allow_hyphen_values = true)]
    stages: StageSet,
    /// Where the stages begin, instead of at what the data say: s=30,alpha=0.5,eta=1.5
    ///
    /// Any of rho_d, k_s, eta and the parameters of the models; a colour is one number or three: k_s=1:2:3. Models without
    /// a parameter do without its value. Stage 4 tries the starts from the data too.
    #[arg(long, value_name = "KEY=VALUE,…", value_parser = parse::values)]
    start: Option<Partial>,
    /// Hold parameters at these values: eta=1.5,rho_d=0.1:0.2:0.3
    ///
    /// Written as for --start.
    #[arg(long, value_name = "KEY=VALUE,…", value_parser = parse::values)]
    hold: Option<Partial>,
    /// Write the JSON to a file
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write a CSV file, a row per fit; then JSON is written only with -o
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Replace output files that exist
    #[arg(long)]
    force: bool,
    /// How many threads; as many as the machine has cores where not given, and at most that many. The result does not
    /// depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

fn keys(keys: impl IntoIterator<Item = &'static str>) -> PossibleValuesParser {
    PossibleValuesParser::new(keys.into_iter().chain([ALL]))
}

fn weight_parser() -> impl clap::builder::TypedValueParser<Value = Weight> {
    PossibleValuesParser::new(WEIGHTS.map(|w| PossibleValue::new(w.key()).help(w.help())))
        .map(|key| Weight::by_key(&key).unwrap_or_default())
}

pub fn run(args: &Args, out: &mut dyn Write) -> Result<(), CliError> {
    let variants = args.variants();
    args.check(&variants)?;
    // Said now and not after hours.
    for path in args.outputs() {
        files::check_writable(path, args.force)?;
    }
    let fit = || fit_files(args, &variants);
    let (fits, all_good) = match args.threads {
        None => fit(),
        Some(threads) => rayon::ThreadPoolBuilder::new()
            .num_threads(pool_size(threads))
            .build()
            .map_err(|error| CliError::Other(format!("cannot start {threads} threads: {error}")))?
            .install(fit),
    };
    if fits.is_empty() {
        return Err(CliError::Reported);
    }
    let mut written = Ok(());
    if let Some(path) = &args.output {
        written = write_atomically(path, args.force, |file| write_json(&fits, file));
    }
    if let Some(path) = &args.csv {
        // Also where the other failed: there were hours in it.
        let csv = write_atomically(path, args.force, |file| write_csv(&fits, file));
        written = written.and(csv);
    }
    written?;
    if args.outputs().next().is_none() {
        write_json(&fits, out)?;
    } else if io::stdout().is_terminal() {
        let rows: Vec<ModelRow> = fits.iter().map(row).collect();
        write_models(&rows, out)?;
    }
    if all_good {
        Ok(())
    } else {
        out.flush()?;
        Err(CliError::Reported)
    }
}

/// Number of threads that are started where `asked` are asked for: more than there are cores only wait for each other,
/// fifty times as long where there are a thousand.
fn pool_size(asked: u16) -> usize {
    // Where the number of cores is not known, what is asked for is taken.
    let cores = thread::available_parallelism().map_or(asked.into(), NonZero::get);
    cores.min(asked.into())
}

/// A fit in the table that is shown to a person.
fn row(fit: &FitRecord) -> ModelRow {
    ModelRow {
        material: Some(fit.material.clone()),
        path: fit.source.as_ref().map(|source| source.path.clone()),
        brdf: fit.brdf,
        error: Some(fit.errors.total),
    }
}

impl Args {
    fn outputs(&self) -> impl Iterator<Item = &PathBuf> {
        self.output.iter().chain(&self.csv)
    }

    /// The chosen models, each with the chosen Fresnel factors.
    fn variants(&self) -> Vec<Variant> {
        let is = |choice: &str, key| choice == ALL || choice == key;
        let fresnels = || {
            FRESNELS
                .into_iter()
                .filter(|fresnel| is(&self.fresnel, fresnel.key()))
        };
        let of = |model: &'static Model| fresnels().map(move |fresnel| Variant { model, fresnel });
        self.model.0.iter().copied().flat_map(of).collect()
    }

    fn options(&self) -> FitOptions {
        FitOptions {
            stages: self.stages,
            start: self.start.clone().unwrap_or_default(),
            held: self.hold.clone().unwrap_or_default(),
            ..FitOptions::default()
        }
    }

    /// Checks the options taken together.
    fn check(&self, variants: &[Variant]) -> Result<(), CliError> {
        let usage = |text: String| Err(CliError::Usage("fit", text));
        let FitOptions { start, held, .. } = self.options();
        for row in all_params() {
            let (starts, held) = (start.has(row.id), held.has(row.id));
            if starts && held {
                return usage(format!(
                    "{} is given in --start and in --hold; give it once",
                    row.key()
                ));
            }
            let uses = |variant: &Variant| variant.defaults().uses(row.id);
            if (starts || held) && !variants.iter().any(uses) {
                let rows = all_params().map(|row| row.id);
                let used = |id: &ParamId| variants.iter().any(|v| v.defaults().uses(*id));
                let known: Vec<&str> = rows.filter(used).map(ParamId::key).collect();
                let option = if starts { "--start" } else { "--hold" };
                return usage(format!(
                    "{option}: the chosen model has no {}; it has {}",
                    row.key(),
                    known.join(", ")
                ));
            }
        }
        if let (Some(output), Some(csv)) = (&self.output, &self.csv)
            && files::is_same_file(output, csv)
        {
            return usage("-o and --csv name the same file; expected two".into());
        }
        let inputs: Vec<&Path> = self.files.iter().map(PathBuf::as_path).collect();
        super::spare_inputs("fit", self.outputs().map(PathBuf::as_path), &inputs)
    }
}

/// The fits of all files in their order, and whether every file was good. Says at once which is not.
fn fit_files(args: &Args, variants: &[Variant]) -> (Vec<FitRecord>, bool) {
    let mut bar = Bar::new(args.files.len(), variants);
    let (mut fits, mut all_good) = (Vec::new(), true);
    for (index, path) in args.files.iter().enumerate() {
        bar.file(index, path);
        match fit_file(path, args, variants, &mut bar) {
            Ok(more) => fits.extend(more),
            Err(error) => {
                all_good = false;
                bar.suspend(|| super::report(&error));
            }
        }
    }
    bar.finish();
    (fits, all_good)
}

fn fit_file(
    path: &Path,
    args: &Args,
    variants: &[Variant],
    bar: &mut Bar,
) -> Result<Vec<FitRecord>, FileError> {
    let (table, source) = files::open_measured(path, &mut |_| ControlFlow::Continue(()))?;
    let problem = Problem::new(&table, args.weight, args.limit.to_radians())
        .map_err(|error| FileError::new(path, error.to_string()))?;
    // The problem has all it needs.
    drop(table);
    let options = args.options();
    let outcomes = fit_all(&problem, variants, &options, &mut |position, progress| {
        bar.progress(position, progress);
        ControlFlow::Continue(())
    });
    let record = |outcome| {
        FitRecord::new(
            files::material_name(path),
            Some(source.clone()),
            (args.weight, args.limit),
            &options,
            outcome,
        )
    };
    Ok(outcomes.iter().map(record).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_threads_are_started_than_there_are_cores() {
        let cores = pool_size(u16::MAX);
        assert_eq!(
            Some(cores),
            thread::available_parallelism().ok().map(NonZero::get)
        );
        assert_eq!((pool_size(1), pool_size(1024)), (1, cores.min(1024)));
    }
}
