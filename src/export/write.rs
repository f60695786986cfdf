//! Figures as files.

use super::error::ExportError;
use super::prepare::Prepared;
use super::recipe::folder_of;
use super::spec::{FigureSpec, spec_beside};
use crate::figure::page::{Page, only_sphere};
use crate::figure::sphere_image::render_part;
use crate::figure::write::{font, pdf, raster, svg};
use crate::files::{self, FileError, write_atomically};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// File format of a figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FigureFormat {
    /// Lines and text that stay such.
    #[default]
    Svg,
    /// Vector graphics, for LaTeX.
    Pdf,
    /// Pixels.
    Png,
    /// The numbers that are drawn.
    Csv,
    /// A sphere alone, in linear light and not clamped.
    Exr,
}

/// Formats in the order offered.
pub const FORMATS: [FigureFormat; 5] = [
    FigureFormat::Svg,
    FigureFormat::Pdf,
    FigureFormat::Png,
    FigureFormat::Csv,
    FigureFormat::Exr,
];

impl FigureFormat {
    /// The end of a file's name, and its name on the command line.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Pdf => "pdf",
            Self::Png => "png",
            Self::Csv => "csv",
            Self::Exr => "exr",
        }
    }

    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Svg => "SVG",
            Self::Pdf => "PDF",
            Self::Png => "PNG",
            Self::Csv => "CSV",
            Self::Exr => "EXR",
        }
    }

    /// Whether letters are drawn in it.
    fn has_text(self) -> bool {
        matches!(self, Self::Svg | Self::Pdf | Self::Png)
    }

    /// The format that the name of a file says.
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        FORMATS
            .into_iter()
            .find(|format| format.extension() == extension)
    }

    /// A drawn figure in this format. The same figure gives the same bytes.
    ///
    /// # Errors
    /// One sentence where it cannot be written so.
    pub fn bytes(
        self,
        spec: &FigureSpec,
        prepared: &Prepared,
        page: &Page,
    ) -> Result<Vec<u8>, ExportError> {
        let dpi = spec.style.dpi;
        let other = |text: String| ExportError::Other(text);
        match self {
            Self::Svg => Ok(svg::svg(&page.paper).into_bytes()),
            Self::Pdf => pdf::pdf(&page.paper).map_err(|error| other(error.to_string())),
            Self::Png => raster::png(&page.paper, dpi).map_err(|error| other(error.to_string())),
            Self::Csv if page.table.rows.is_empty() => Err(other(
                "the figure has no numbers: nothing but spheres".into(),
            )),
            Self::Csv => Ok(page.table.text(',').into_bytes()),
            Self::Exr => exr(spec, prepared, dpi).map_err(other),
        }
    }
}

/// The only sphere of a figure, as many pixels wide as the page at this resolution.
fn exr(spec: &FigureSpec, prepared: &Prepared, dpi: f64) -> Result<Vec<u8>, String> {
    const MOST: f64 = 8192.0;
    let Some((source, view, sight)) = only_sphere(&spec.page(), &prepared.subjects) else {
        return Err("EXR holds one sphere and nothing else; choose a sphere alone, or PNG".into());
    };
    let size = (spec.style.width_mm / 25.4 * dpi).round().clamp(1.0, MOST);
    let picture = render_part(&source, &view, sight, size as usize);
    let mut bytes = Cursor::new(Vec::new());
    picture
        .write_exr(&mut bytes)
        .map_err(|error| format!("cannot make the EXR: {error}"))?;
    Ok(bytes.into_inner())
}

/// Checks whether a figure could be written, and its spec beside it, as far as is known without writing and drawing: for an
/// error before long work. A spec that is there may be the figure's own.
///
/// # Errors
/// One line with the path last.
pub fn check_writable(figure: &Path, force: bool) -> Result<(), FileError> {
    files::check_writable(figure, force)?;
    files::check_writable(&spec_beside(figure), true)
}

/// Draws a figure, writes its spec beside each file and then the figure in one or several formats: whoever is interrupted has
/// a new spec beside an old figure at worst, and a picture carries the recipe that fits it. Files that are there are refused
/// unless `force`, before anything is written; a spec that is there already with the same bytes is no conflict. `kept` is a
/// spec that is left as it is, the one that is drawn. Gives back the letters that no font has, where such are drawn.
///
/// # Errors
/// One line with the path last.
pub fn write_figure(
    outputs: &[(PathBuf, FigureFormat)],
    (spec, prepared): (&FigureSpec, &Prepared),
    force: bool,
    kept: Option<&Path>,
) -> Result<BTreeSet<char>, ExportError> {
    let kept = kept.map(files::place);
    let mut beside: Vec<PathBuf> = Vec::new();
    for (path, _) in outputs {
        files::check_writable(path, force)?;
        let spec_path = spec_beside(path);
        let place = files::place(&spec_path);
        let known = beside.iter().any(|other| files::place(other) == place);
        if known || kept.as_ref() == Some(&place) || spec.is_in(&spec_path) {
            continue;
        }
        files::check_writable(&spec_path, force)?;
        beside.push(spec_path);
    }
    let numbers = outputs
        .iter()
        .any(|(_, format)| *format == FigureFormat::Csv);
    let mut page = spec.draw(prepared, numbers)?;
    let mut figures = Vec::new();
    for (path, format) in outputs {
        page.paper.recipe = Some(spec.recipe(&folder_of(path)));
        figures.push((path.clone(), format.bytes(spec, prepared, &page)?));
    }
    let specs = beside
        .into_iter()
        .map(|path| (path, spec.to_json().into_bytes()));
    for (path, bytes) in specs.chain(figures) {
        write_atomically(&path, force, |file| file.write_all(&bytes))?;
    }
    Ok(if outputs.iter().any(|(_, format)| format.has_text()) {
        font::lacking(&page.paper.drawing, &page.paper.fallback)
    } else {
        BTreeSet::new()
    })
}
