//! The command line: opens the window, or does the same work without one.
//!
//! Exit code 0: done. 1: failed, with one line on standard error. 2: the command line itself is wrong, or the spec of a figure
//! that it names.

mod eval;
mod export;
mod figure;
mod fit;
mod info;
mod models;
mod render;
mod sample;
mod table;

use crate::app;
use crate::files::{self, FileError};
use crate::gpu;
use crate::quote;
use crate::quote::shown;
use crate::signals;
use clap::error::{ContextKind, ContextValue, ErrorKind as UsageError};
use clap::{CommandFactory as _, Parser, Subcommand};
use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// A desktop BRDF explorer for the angles at which Phong models go wrong.
///
/// Without a command, opens the window with the given files. A file that is named like a command is opened as ./NAME.
#[derive(Parser)]
#[command(name = "grazing", version, args_conflicts_with_subcommands = true)]
struct Cli {
    /// MERL files, fit files, JSON files with models or a session to open in the window
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Print the graphics adapter that the window would use: name, driver, backend, type
    ///
    /// No display is needed. The variable WGPU_ADAPTER_NAME asks for another one by a part of its name, WGPU_BACKEND for one of
    /// the interface vulkan, gl, metal or dx12.
    #[arg(long, exclusive = true)]
    adapter: bool,
    #[command(subcommand)]
    command: Option<CliCommand>,
}

#[derive(Subcommand)]
enum CliCommand {
    Info(info::Args),
    Sample(sample::Args),
    Eval(eval::Args),
    Fit(Box<fit::Args>),
    Figure(Box<figure::Args>),
    Render(render::Args),
    Export(export::Args),
}

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
enum CliError {
    #[error(transparent)]
    File(#[from] FileError),
    /// A figure's spec asks for what cannot be drawn.
    #[error(transparent)]
    Spec(FileError),
    #[error("cannot write the output: {0}")]
    Output(#[from] io::Error),
    #[error("{0}")]
    Other(String),
    /// Options that do not go together, found after reading them one by one; with the command's name.
    #[error("{1}")]
    Usage(&'static str, String),
    /// Said already where it happened.
    #[error("some files failed")]
    Reported,
}

/// The command line as data, for manual pages and completions.
pub fn command() -> clap::Command {
    Cli::command()
}

/// The program: reads the command line, works, returns the exit code.
pub fn main() -> ExitCode {
    // Usage errors, --help and --version end here, with 2 or 0.
    let cli = Cli::try_parse().unwrap_or_else(|error| bounded(error).exit());
    if cli.command.is_some() {
        signals::watch(|| {});
    }
    let mut out = io::BufWriter::new(io::stdout().lock());
    let result = match &cli.command {
        None if cli.adapter => adapter(&mut out),
        None => {
            drop(out);
            return finish(app::run(cli.files).map_err(CliError::Other));
        }
        Some(CliCommand::Info(args)) => info::run(args, &mut out),
        Some(CliCommand::Sample(args)) => sample::run(args, &mut out),
        Some(CliCommand::Eval(args)) => eval::run(args, &mut out),
        Some(CliCommand::Fit(args)) => fit::run(args, &mut out),
        Some(CliCommand::Figure(args)) => figure::run(args),
        Some(CliCommand::Render(args)) => render::run(args),
        Some(CliCommand::Export(args)) => export::run(args, &mut out),
    };
    finish(result.and_then(|()| Ok(out.flush()?)))
}

/// Error of the command line that quotes no more of it than other messages do.
fn bounded(mut error: clap::Error) -> clap::Error {
    let quoted: Vec<_> = error
        .context()
        .filter_map(|(kind, value)| {
            let value = match value {
                ContextValue::String(text) => ContextValue::String(shown(text)),
                ContextValue::Strings(texts) => {
                    ContextValue::Strings(texts.iter().map(|text| shown(text)).collect())
                }
                _ => return None,
            };
            Some((kind, value))
        })
        .collect();
    for (kind, value) in quoted {
        error.insert(kind, value);
    }
    // The tip repeats the argument, as text with colours.
    let tips = error.get(ContextKind::Suggested).map(ToString::to_string);
    if tips.is_some_and(|tips| shown(&tips) != tips) {
        error.remove(ContextKind::Suggested);
    }
    error
}

/// `grazing --adapter`.
fn adapter(out: &mut dyn Write) -> Result<(), CliError> {
    gpu::adapter::check_environment().map_err(CliError::Other)?;
    let gpu = gpu::adapter::headless().map_err(|error| {
        CliError::Other(format!(
            "{error}; install a driver: {}",
            app::startup::APT_LINE
        ))
    })?;
    Ok(writeln!(out, "{}", gpu::adapter::report(&gpu.info))?)
}

fn finish(result: Result<(), CliError>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever reads has had enough (`grazing eval … | head`): no failure.
        Err(CliError::Output(error)) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(CliError::Usage(name, text)) => {
            let mut cli = command();
            cli.build();
            match cli.find_subcommand_mut(name) {
                Some(command) => command.error(UsageError::ArgumentConflict, text).exit(),
                None => cli.error(UsageError::ArgumentConflict, text).exit(),
            }
        }
        Err(CliError::Reported) => ExitCode::FAILURE,
        Err(error @ CliError::Spec(_)) => {
            report(&error);
            ExitCode::from(2)
        }
        Err(error) => {
            report(&error);
            ExitCode::FAILURE
        }
    }
}

/// Refuses an output that is one of the inputs, under whatever name; `--force` does not change that.
fn spare_inputs<'p>(
    command: &'static str,
    outputs: impl IntoIterator<Item = &'p Path>,
    inputs: &[&Path],
) -> Result<(), CliError> {
    let is_input = |output: &&Path| {
        inputs
            .iter()
            .any(|input| files::is_same_file(input, output))
    };
    match outputs.into_iter().find(is_input) {
        None => Ok(()),
        Some(path) => {
            let path = quote::path(path);
            let text = format!("the output would replace an input; choose another name: {path}");
            Err(CliError::Usage(command, text))
        }
    }
}

/// One line on standard error.
fn report(error: &dyn Display) {
    // eprintln! would panic where standard error is closed.
    let _ = writeln!(io::stderr(), "grazing: {error}");
}
