//! `grazing figure`: figures for papers, from their spec or by the name of a preset.

mod materials;

use super::CliError;
use super::models::{self, Models};
use crate::brdf::{Fresnel, fresnel::FRESNELS};
use crate::export::fonts::lacking_text;
use crate::export::preset::{PRESETS, Preset, PresetOptions};
use crate::export::{
    ExportError, FORMATS, FigureFormat, FigureSpec, OpenedTables, SubjectSource, check_writable,
    open_from_files, prepare, spec_beside, write_figure,
};
use crate::figure::faults::{Faults, MOST_ANGLES};
use crate::figure::page::{Inks, SAME_AXES, SameAxes, Style, style_limits};
use crate::figure::scale::{RADIAL_SCALES, RadialScale};
use crate::figure::write::raster::MOST_PIXELS;
use crate::files::{self, FileError};
use crate::geom::sphere::SphereView;
use crate::quote;
use clap::builder::{PossibleValue, PossibleValuesParser};
use materials::Needs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  grazing figure --preset poster teflon.binary nickel.binary -o results.pdf
          Spheres and polar lobes, measured and as the Phong family, which is fitted first
  grazing figure --preset lobes fits.json --theta-i 30,60,80 -o lobes.svg
          The materials of a fit file with their fits
  grazing figure --preset lobes fits.json --model combined,ggx,ward -o three.pdf
          Three models over the data of each material
  grazing figure --preset lobes -o lobes.pdf
          The synthetic materials, without any file
  grazing figure results.figure.json -o results.pdf
          The same figure again, byte by byte, from the spec that was written beside it
  grazing figure results.figure.json --grey --font 7 -o results.png
          The same in greys and with a smaller font
  grazing figure --preset slices fits.json -o slices.pdf -o slices.csv
          A figure and its numbers";

/// Draw figures for papers
///
/// The figure is a .figure.json, or it is made by a preset from measured files and fit files; what has no fit yet is
/// fitted. The format is that of the name: .svg, .pdf, .png, or .csv with the numbers that are drawn. Beside the
/// figure its .figure.json is written, from which it can be drawn again: it names the measured files with their SHA-256.
/// No display and no graphics adapter is needed.
#[derive(clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Args {
    /// A .figure.json; with --preset measured files and fit files, or none for the synthetic materials
    #[arg(required_unless_present = "preset", value_name = "FILE")]
    files: Vec<PathBuf>,
    /// File to write: .svg, .pdf, .png, .csv, or .exr for a sphere alone; can be given several times
    #[arg(short, long, required = true, value_name = "FILE")]
    output: Vec<PathBuf>,
    /// Which figure to make from the files
    #[arg(long, value_name = "NAME", value_parser = presets())]
    preset: Option<String>,
    /// Which models the preset shows
    #[arg(long, value_name = "KEY,…", value_parser = models::parse, help = models_help(), requires = "preset")]
    model: Option<Models>,
    /// The Fresnel factor of the models
    #[arg(long, default_value = "exact", value_parser = PossibleValuesParser::new(FRESNELS.map(Fresnel::key)), requires = "preset")]
    fresnel: String,
    /// Angles of incidence of lobes and slices in degrees, at most 90
    #[arg(long, value_name = "DEG,…", value_delimiter = ',', default_value = "30,60,80", requires = "preset", allow_hyphen_values = true, value_parser = theta_i)]
    theta_i: Vec<f64>,
    /// How values become lengths; as the preset likes it where not given
    #[arg(long, value_parser = PossibleValuesParser::new(RADIAL_SCALES.map(RadialScale::key)), requires = "preset")]
    scale: Option<String>,
    /// Exposure of spheres in stops
    #[arg(long, value_name = "EV", default_value_t = 0.0, requires = "preset", allow_hyphen_values = true, value_parser = super::render::exposure)]
    exposure: f64,
    #[command(flatten)]
    look: LookArgs,
    /// Draw also where a measured file is no longer the one that the figure was drawn from
    #[arg(long)]
    changed: bool,
    /// Replace files that exist
    #[arg(long)]
    force: bool,
}

/// Look of the figure; what is not given is as the figure or the preset has it.
#[derive(clap::Args)]
struct LookArgs {
    /// Width of the page in millimetres
    #[arg(long, value_name = "MM", value_parser = style("width_mm"), allow_hyphen_values = true)]
    width: Option<f64>,
    /// Font size in points
    #[arg(long, value_name = "PT", value_parser = style("font_pt"), allow_hyphen_values = true)]
    font: Option<f64>,
    /// Width of a curve in points
    #[arg(long, value_name = "PT", value_parser = style("line_pt"), allow_hyphen_values = true)]
    line: Option<f64>,
    /// Pixels to the inch: of pictures in the figure, and of a PNG
    #[arg(long, value_name = "N", value_parser = style("dpi"), allow_hyphen_values = true)]
    dpi: Option<f64>,
    /// Greys that a black and white printer tells apart
    #[arg(long)]
    grey: bool,
    /// Leave the page clear instead of white
    #[arg(long)]
    transparent: bool,
    /// Leave the legend out
    #[arg(long)]
    no_legend: bool,
    /// Letter the panels (a), (b), …
    #[arg(long)]
    letters: bool,
    /// Which panels of a kind have the same axis of values
    #[arg(long, value_name = "WHICH", value_parser = PossibleValuesParser::new(SAME_AXES.map(SameAxes::key)))]
    same_axes: Option<String>,
}

impl LookArgs {
    fn apply(&self, style: &mut Style) {
        let Style {
            width_mm,
            font_pt,
            line_pt,
            dpi,
            ..
        } = style;
        for (value, to) in [
            (self.width, width_mm),
            (self.font, font_pt),
            (self.line, line_pt),
            (self.dpi, dpi),
        ] {
            if let Some(value) = value {
                *to = value;
            }
        }
        if self.grey {
            style.palette = Inks::Grey;
        }
        style.transparent |= self.transparent;
        style.legend &= !self.no_legend;
        style.letters |= self.letters;
        let asked = |axes: &SameAxes| Some(axes.key()) == self.same_axes.as_deref();
        style.same_axes = SAME_AXES.into_iter().find(asked).unwrap_or(style.same_axes);
    }
}

fn models_help() -> String {
    format!(
        "{}; where not given the Phong family in a poster and a ranking, the combined model in the others",
        models::help()
    )
}

fn presets() -> PossibleValuesParser {
    PossibleValuesParser::new(
        PRESETS
            .iter()
            .map(|preset| PossibleValue::new(preset.key).help(preset.help)),
    )
}

/// The parser of a number of the style, which says what can be asked for.
fn style(
    key: &str,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static + use<> {
    let [low, high] = style_limits(key).unwrap_or([0.0, f64::MAX]);
    move |text| match text.trim().parse::<f64>() {
        Ok(value) if (low..=high).contains(&value) => Ok(value),
        _ => Err(format!("expected a number from {low} to {high}")),
    }
}

fn theta_i(text: &str) -> Result<f64, String> {
    let degrees: f64 = text
        .trim()
        .parse()
        .map_err(|_| "expected degrees such as 30,60,80".to_string())?;
    if (0.0..90.0).contains(&degrees) {
        Ok(degrees.to_radians())
    } else {
        Err("expected 0 to less than 90 degrees".into())
    }
}

pub fn run(args: &Args) -> Result<(), CliError> {
    let outputs = args.outputs()?;
    let mut opened = OpenedTables::new();
    let (mut spec, folder) = match &args.preset {
        Some(key) => {
            let inputs: Vec<&Path> = args.files.iter().map(PathBuf::as_path).collect();
            let beside: Vec<PathBuf> = args.output.iter().map(|path| spec_beside(path)).collect();
            super::spare_inputs("figure", beside.iter().map(PathBuf::as_path), &inputs)?;
            (preset(args, key, &outputs, &mut opened)?, PathBuf::new())
        }
        None => from_file(&args.files)?,
    };
    args.spare_data(&spec, &folder)?;
    args.check_pixels(&outputs, spec.style.width_mm, spec.style.dpi)?;
    args.look.apply(&mut spec.style);
    let spec = spec.settled();
    let mut faults = Faults::default();
    spec.clone().sanitize(&mut faults);
    faults.result().or_else(usage)?;
    let go_on = &mut || ControlFlow::Continue(());
    let mut table = |source: &_| open_from_files(source, &folder, args.changed, &mut opened);
    let prepared = prepare(&spec, &mut table, go_on)?;
    let spec = match args.changed {
        true => spec.of_data(&folder, &opened),
        false => spec,
    };
    let kept = args.preset.is_none().then(|| args.files[0].as_path());
    let lacking = write_figure(&outputs, (&spec, &prepared), args.force, kept)?;
    if let Some(text) = lacking_text(&lacking) {
        super::report(&FileError::new(&outputs[0].0, text));
    }
    Ok(())
}

impl Args {
    /// The files to write with their formats, as far as can be told before there is a figure.
    fn outputs(&self) -> Result<Vec<(PathBuf, FigureFormat)>, CliError> {
        let inputs: Vec<&Path> = self.files.iter().map(PathBuf::as_path).collect();
        let mut places = Vec::new();
        let mut outputs = Vec::new();
        for path in &self.output {
            let Some(format) = FigureFormat::of_path(path) else {
                let known = FORMATS.map(|format| format!(".{}", format.extension()));
                return usage(format!(
                    "{}: the name does not say which format; expected one of {}",
                    quote::path(path),
                    known.join(", ")
                ));
            };
            let place = files::place(path);
            super::spare_inputs("figure", [path.as_path()], &inputs)?;
            if places.contains(&place) {
                let path = quote::path(path);
                return usage(format!("the output is given twice; give it once: {path}"));
            }
            // Said now and not after the fits.
            check_writable(path, self.force)?;
            places.push(place);
            outputs.push((path.clone(), format));
        }
        Ok(outputs)
    }

    /// Refuses a PNG of more pixels in a row than there can be, as the options have it or else the figure.
    fn check_pixels(
        &self,
        outputs: &[(PathBuf, FigureFormat)],
        width_mm: f64,
        dpi: f64,
    ) -> Result<(), CliError> {
        let width_mm = self.look.width.unwrap_or(width_mm);
        let dpi = self.look.dpi.unwrap_or(dpi);
        let pixels = (width_mm / 25.4 * dpi).round();
        let png = outputs
            .iter()
            .find(|(_, format)| *format == FigureFormat::Png);
        match png {
            Some((path, _)) if pixels > f64::from(MOST_PIXELS) => {
                let path = quote::path(path);
                usage(format!(
                    "a PNG of {pixels} pixels in a row; expected at most {MOST_PIXELS}: change --width or --dpi: {path}"
                ))
            }
            _ => Ok(()),
        }
    }

    /// Refuses to write over the data of a figure, or over its spec over them.
    fn spare_data(&self, spec: &FigureSpec, folder: &Path) -> Result<(), CliError> {
        let files = spec
            .subjects
            .iter()
            .filter_map(|subject| match &subject.source {
                SubjectSource::Measured { file, .. } => Some(file.places(folder)),
                _ => None,
            });
        let data: Vec<PathBuf> = files.flatten().collect();
        let data: Vec<&Path> = data.iter().map(PathBuf::as_path).collect();
        let beside = self.output.iter().map(|path| spec_beside(path));
        let written: Vec<PathBuf> = self.output.iter().cloned().chain(beside).collect();
        super::spare_inputs("figure", written.iter().map(PathBuf::as_path), &data)
    }
}

fn usage<T>(text: String) -> Result<T, CliError> {
    Err(CliError::Usage("figure", text))
}

/// The figure of a file, and the folder that its paths are seen from.
fn from_file(paths: &[PathBuf]) -> Result<(FigureSpec, PathBuf), CliError> {
    let [path] = paths else {
        return usage("several files need a --preset; without it one .figure.json is drawn".into());
    };
    let spec = FigureSpec::open(path)?;
    let path = files::absolute(path);
    Ok((spec, path.parent().unwrap_or(Path::new("")).to_owned()))
}

fn preset(
    args: &Args,
    key: &str,
    outputs: &[(PathBuf, FigureFormat)],
    opened: &mut OpenedTables,
) -> Result<FigureSpec, CliError> {
    if args.theta_i.len() > MOST_ANGLES {
        let count = args.theta_i.len();
        return usage(format!(
            "--theta-i has {count} angles; expected at most {MOST_ANGLES}"
        ));
    }
    let preset = Preset::by_key(key).unwrap_or(&PRESETS[0]);
    args.check_pixels(outputs, preset.width_mm, Style::default().dpi)?;
    let models = args.model.iter().flat_map(|models| &models.0);
    let options = PresetOptions {
        models: models.copied().collect(),
        fresnel: Fresnel::by_key(&args.fresnel).unwrap_or(Fresnel::Exact),
        theta_i: args.theta_i.clone(),
        scale: args.scale.as_deref().and_then(RadialScale::by_key),
        view: SphereView {
            exposure_stops: args.exposure,
            ..SphereView::default()
        },
        style: Style {
            width_mm: preset.width_mm,
            same_axes: preset.same_axes,
            ..Style::default()
        },
    };
    preset.check(&options).or_else(usage)?;
    let needs = Needs {
        variants: &preset.variants(&options),
        errors: preset.shows_errors,
    };
    let materials = materials::of_files(&args.files, &needs, opened)?;
    Ok(preset.figure(&materials, &options))
}

impl From<ExportError> for CliError {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::File(error) => Self::File(error),
            ExportError::Spec(error) => Self::Spec(error),
            error => Self::Other(error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::limits::MAX_EXPOSURE_STOPS;
    use clap::Parser;

    #[derive(Parser)]
    struct Figure {
        #[command(flatten)]
        args: Args,
    }

    #[derive(Parser)]
    struct Render {
        #[command(flatten)]
        args: crate::cli::render::Args,
    }

    /// Whether `figure` and `render` take an exposure.
    fn taken(stops: f64) -> [bool; 2] {
        let stops = format!("--exposure={stops}");
        let preset = PRESETS[0].key;
        let figure = ["figure", "--preset", preset, "a.json", "-o", "a.svg"];
        let render = ["render", "a.json", "-o", "a.png"];
        [
            Figure::try_parse_from(figure.iter().chain([&stops.as_str()]))
                .is_ok_and(|figure| figure.args.exposure.abs() > 1.0),
            Render::try_parse_from(render.iter().chain([&stops.as_str()])).is_ok(),
        ]
    }

    #[test]
    fn an_exposure_that_one_command_takes_the_other_takes() {
        assert_eq!(taken(MAX_EXPOSURE_STOPS), [true; 2]);
        assert_eq!(taken(-MAX_EXPOSURE_STOPS), [true; 2]);
        assert_eq!(taken(MAX_EXPOSURE_STOPS + 1.0), [false; 2]);
        assert_eq!(taken(99.0), [false; 2]);
    }
}
