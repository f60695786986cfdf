//! `grazing render SOURCE -o sphere.png`: the lit sphere as a picture, without window or graphics adapter.

mod parse;

pub(super) use parse::exposure;

use super::{CliError, eval};
use crate::brdf::Brdf;
use crate::figure::sphere_image::{SphereSource, render};
use crate::figure::subject::Source;
use crate::files::{self, FileError, WriteSeek, fits, write_atomically};
use crate::geom::Rgb;
use crate::geom::sphere::SphereView;
use crate::measured::Lookup;
use clap::ValueEnum;
use image::ImageError;
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  grazing render teflon.binary -o teflon.png --size 1024
          The data under the poster's pair of lights
  grazing render teflon.binary --split fits.json --light grazing -o split.png
          The data left, their best fit in the file right, under the grazing light
  grazing render model.json --light '30,45;120,-140' --exposure -1 -o model.exr
          A model under two lights, one stop darker, in linear floats";

/// Draw the lit sphere to a PNG or EXR file
///
/// Needs neither a window nor a graphics adapter. Each pixel is the mean of 16 samples in linear light. PNG is
/// sRGB-encoded and hatched where nothing was measured. EXR has linear 32-bit floats that are not clamped, with
/// premultiplied alpha; what was not measured covers nothing there.
#[derive(clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Args {
    /// MERL file, fit file, or JSON file with a model or an array of models
    source: PathBuf,
    /// File to write; .png or .exr
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Pixels a side, at most 8192
    #[arg(long, value_name = "N", default_value_t = 512, value_parser = clap::value_parser!(u16).range(1..=8192))]
    size: u16,
    /// The lights: poster, glancing, grazing, viewer, or angles THETA,PHI[;THETA,PHI…] in degrees
    ///
    /// poster is the pair of a glancing light from the upper right and a grazing one from the lower left. THETA is the
    /// angle from the axis towards the viewer, 0 to 180, where more than 90 is behind the sphere. PHI turns from the
    /// right, 0, over above, 90. At most four lights.
    #[arg(long, value_name = "LIGHTS", default_value = "poster", value_parser = parse::lights, allow_hyphen_values = true)]
    light: parse::Lights,
    /// Exposure in stops, -30 to 30; at 0 a white diffuse surface that faces a light is white
    #[arg(long, value_name = "EV", default_value = "0", value_parser = parse::exposure, allow_hyphen_values = true)]
    exposure: f64,
    /// Show a model of this fit file or JSON file in the right half, and SOURCE in the left one
    ///
    /// Without --index it is the best fit of SOURCE in the file, or the only model there.
    #[arg(long, value_name = "FILE")]
    split: Option<PathBuf>,
    /// Which model of an array or fit file, counted from 0; of that of --split where it is given
    #[arg(long, value_name = "K")]
    index: Option<usize>,
    /// How a value is taken from a measured table
    #[arg(long, default_value = Lookup::default().key(), value_parser = eval::lookup_parser())]
    lookup: Lookup,
    #[arg(
        long,
        value_enum,
        default_value_t = Background::Transparent,
        help = "What is behind the sphere"
    )]
    background: Background,
    /// Replace the output file if it exists
    #[arg(long)]
    force: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Background {
    Transparent,
    White,
    Black,
}

impl Background {
    fn color(self) -> Option<Rgb> {
        match self {
            Self::Transparent => None,
            Self::White => Some([1.0; 3]),
            Self::Black => Some([0.0; 3]),
        }
    }
}

/// The kinds of file, by extension.
#[derive(Clone, Copy)]
enum PictureFormat {
    Png,
    Exr,
}

pub fn run(args: &Args) -> Result<(), CliError> {
    let format = format_of(&args.output)?;
    let inputs: Vec<&Path> = [Some(&args.source), args.split.as_ref()]
        .into_iter()
        .flatten()
        .map(PathBuf::as_path)
        .collect();
    super::spare_inputs("render", [args.output.as_path()], &inputs)?;
    // Said now and not after the work.
    files::check_writable(&args.output, args.force)?;
    let source = sphere_source(args)?;
    let view = SphereView {
        lights: args.light.0.clone(),
        exposure_stops: args.exposure,
    };
    let mut picture = render(&source, &view, args.size.into());
    picture.background = args.background.color();
    let write = |file: &mut dyn WriteSeek| match format {
        PictureFormat::Png => picture.write_png(file).map_err(|error| match error {
            ImageError::IoError(error) => error,
            error => io::Error::other(error),
        }),
        // A large one is never whole in memory.
        PictureFormat::Exr => picture.write_exr(file).map_err(|error| match error {
            exr::error::Error::Io(error) => error,
            error => io::Error::other(error),
        }),
    };
    Ok(write_atomically(&args.output, args.force, write)?)
}

fn format_of(path: &Path) -> Result<PictureFormat, FileError> {
    let extension = path.extension().unwrap_or_default();
    if extension.eq_ignore_ascii_case("png") {
        Ok(PictureFormat::Png)
    } else if extension.eq_ignore_ascii_case("exr") {
        Ok(PictureFormat::Exr)
    } else {
        let what = "the extension does not say what to write; expected .png or .exr";
        Err(FileError::new(path, what))
    }
}

fn sphere_source(args: &Args) -> Result<SphereSource, FileError> {
    let shown = |index| {
        let source = files::open_source(&args.source, index, &mut |_| ControlFlow::Continue(()))?;
        Ok(match source {
            files::OpenedSource::Table(table) => Source::Measured(table, args.lookup),
            files::OpenedSource::Brdf(brdf) => Source::Model(brdf),
        })
    };
    let Some(split) = &args.split else {
        return shown(args.index.unwrap_or(0)).map(SphereSource::One);
    };
    let left = shown(0)?;
    let measured = matches!(left, Source::Measured(..)).then_some(args.source.as_path());
    Ok(SphereSource::Split {
        left,
        right: Source::Model(model_beside(measured, split, args.index)?),
        at: 0.0,
    })
}

/// The model of the file `path` that is meant beside a measured file, or beside a model where there is none.
fn model_beside(
    measured: Option<&Path>,
    path: &Path,
    index: Option<usize>,
) -> Result<Brdf, FileError> {
    if let (None, Some(measured), Some(entries)) = (index, measured, files::open_models(path)?)
        && entries.len() > 1
    {
        let best = fits::best_of(&entries, &files::identify(measured)?);
        return best.map(|entry| entry.brdf).ok_or_else(|| {
            let count = entries.len();
            let what = format!("none of the {count} models is a fit of SOURCE; --index picks one");
            FileError::new(path, what)
        });
    }
    files::open_model(path, index.unwrap_or(0)).map(|entry| entry.brdf)
}
