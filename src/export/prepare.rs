//! Preparation of a figure before it can be drawn: data in memory, surveys of a fit.

use super::error::ExportError;
use super::fit_output;
use super::fonts;
use super::spec::{FigureSpec, SubjectLook, SubjectSource, SubjectSpec};
use crate::figure::ViewSpec;
use crate::figure::fit_output::FitOutput;
use crate::figure::page::{Page, draw};
use crate::figure::subject::{Look, Source, Subject};
use crate::figure::write::font;
use crate::files::fits::SourceFile;
use crate::files::{self, FileError};
use crate::keys;
use crate::measured::{Lookup, SAMPLES, SyntheticMaterial, Table};
use crate::quote::{quoted, shown};
use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Data that drawing needs besides the figure itself.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Subjects in the order of the figure.
    pub subjects: Vec<Subject>,
    /// An entry per panel, row by row.
    pub made: Vec<Option<FitOutput>>,
}

/// Data in memory by the place of their file.
pub type OpenedTables = BTreeMap<PathBuf, OpenedTable>;

/// Data in memory.
#[derive(Clone, Debug)]
pub struct OpenedTable {
    /// The data.
    pub table: Arc<Table>,
    /// The file as it was read; `None` for a sample.
    pub file: Option<SourceFile>,
}

/// Opens the data of a figure and makes what its panels show. `table` gives the data of a measured file or of a
/// sample; each is asked for once per subject. `follow` breaks where nobody waits any more.
///
/// # Errors
/// What `table` says, and one sentence where something cannot be made.
pub fn prepare(
    spec: &FigureSpec,
    table: &mut dyn FnMut(&SubjectSource) -> Result<Arc<Table>, ExportError>,
    follow: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Prepared, ExportError> {
    let mut subjects = Vec::new();
    for subject in &spec.subjects {
        if follow().is_break() {
            return Err(ExportError::Stopped);
        }
        subjects.push(subject_of(subject, table)?);
    }
    let panels = spec.rows.iter().flat_map(|row| &row.panels);
    let mut all = Vec::new();
    let mut outputs: Vec<(ViewSpec, Vec<Source>, FitOutput)> = Vec::new();
    for panel in panels {
        let of_panel: Vec<&Subject> = panel
            .subjects
            .iter()
            .filter_map(|at| subjects.get(*at))
            .collect();
        let wanted = fit_output::wanted(&panel.view);
        let sources: Vec<Source> = of_panel.iter().map(|one| one.source.clone()).collect();
        let mut known = outputs.iter();
        // Made once for all panels that show it.
        let same = known.find(|(other, of, _)| Some(other) == wanted.as_ref() && *of == sources);
        if let Some((_, _, output)) = same {
            all.push(Some(output.clone()));
            continue;
        }
        let output = fit_output::of_panel(&panel.view, &of_panel, follow)?;
        if let (Some(wanted), Some(output)) = (wanted, &output) {
            outputs.push((wanted, sources, output.clone()));
        }
        all.push(output);
    }
    Ok(Prepared {
        subjects,
        made: all,
    })
}

fn subject_of(
    spec: &SubjectSpec,
    table: &mut dyn FnMut(&SubjectSource) -> Result<Arc<Table>, ExportError>,
) -> Result<Subject, ExportError> {
    let (source, look) = match &spec.source {
        SubjectSource::Measured { lookup, .. } | SubjectSource::Sample { lookup, .. } => {
            let table = table(&spec.source)?;
            (Source::Measured(table, *lookup), Look::Measured)
        }
        SubjectSource::Model(brdf) => (Source::Model(*brdf), Look::Model),
    };
    Ok(Subject {
        // A table of numbers has it in every row.
        label: shown(&spec.label),
        look: spec.look.map_or(look, SubjectLook::look),
        series: spec.series,
        hidden: false,
        source,
    })
}

/// Opens data from files and makes samples; `folder` is where paths of the figure are seen from. A file whose bytes are
/// not those that were drawn is an error unless `changed_is_fine`. `known` keeps what was opened.
///
/// # Errors
/// One line that names the file: missing, changed, or not what it should be.
pub fn open_from_files(
    source: &SubjectSource,
    folder: &Path,
    changed_is_fine: bool,
    known: &mut OpenedTables,
) -> Result<Arc<Table>, ExportError> {
    match source {
        SubjectSource::Measured { file, .. } => {
            let place = place_of(file, folder)?;
            let opened = match known.get(&place) {
                Some(opened) => opened.clone(),
                None => {
                    let go_on = &mut |_| ControlFlow::Continue(());
                    let (table, found) = files::open_measured(&place, go_on)?;
                    OpenedTable {
                        table: Arc::new(table),
                        file: Some(found),
                    }
                }
            };
            // Of each subject: two may name one path with different bytes.
            let same = opened.file.as_ref().and_then(|found| found.same_data(file));
            if same == Some(false) && !changed_is_fine {
                let what = "the file is not the one that the figure was drawn from (its SHA-256 differs); --changed draws it all the same";
                return Err(FileError::new(&place, what).into());
            }
            let table = Arc::clone(&opened.table);
            known.insert(place, opened);
            Ok(table)
        }
        SubjectSource::Sample { key, .. } => {
            let place = PathBuf::from(format!("sample:{key}"));
            if let Some(opened) = known.get(&place) {
                return Ok(Arc::clone(&opened.table));
            }
            let sample = SyntheticMaterial::by_key(key).ok_or_else(|| {
                let proposal = keys::did_you_mean(key, SAMPLES.iter().map(|sample| sample.key));
                ExportError::Other(format!(
                    "unknown sample {}; `grazing sample --list` shows them{proposal}",
                    quoted(key)
                ))
            })?;
            let table = Arc::new(sample.synthesize());
            let opened = OpenedTable {
                table: Arc::clone(&table),
                file: None,
            };
            known.insert(place, opened);
            Ok(table)
        }
        SubjectSource::Model(_) => Err(ExportError::Other("a model has no data".into())),
    }
}

fn place_of(file: &SourceFile, folder: &Path) -> Result<PathBuf, FileError> {
    let places = file.places(folder);
    let found = places.iter().find(|place| place.is_file()).cloned();
    found.ok_or_else(|| {
        // What is there and cannot be reached is not missing.
        for place in &places {
            if let Err(error) = place.metadata()
                && error.kind() == io::ErrorKind::PermissionDenied
            {
                return FileError::io(place, "cannot open the file", &error);
            }
        }
        let what = if file.path.to_string_lossy().contains(char::REPLACEMENT_CHARACTER) {
            "the measured file of the figure is missing; its path has U+FFFD where a name was no UTF-8: write it as {\"bytes\": …}, with %E9 for such a byte"
        } else {
            "the measured file of the figure is missing; put it there or beside the figure"
        };
        FileError::new(&places[0], what)
    })
}

impl SubjectSource {
    /// A synthetic sample.
    pub fn sample(key: &str) -> Self {
        Self::Sample {
            key: key.to_owned(),
            lookup: Lookup::Smooth,
        }
    }

    /// A measured file.
    pub fn measured(file: SourceFile) -> Self {
        Self::Measured {
            file,
            lookup: Lookup::Smooth,
        }
    }
}

impl FigureSpec {
    /// The figure of the data that were opened, which may have changed since it was drawn first.
    pub fn of_data(mut self, folder: &Path, opened: &OpenedTables) -> Self {
        for file in self.measured_files() {
            let place = place_of(file, folder).ok();
            let found = place.and_then(|place| opened.get(&place)?.file.as_ref());
            if let Some(found) = found {
                file.bytes = found.bytes;
                file.sha256.clone_from(&found.sha256);
            }
        }
        self
    }

    /// Draws it from what [`prepare`] has brought, with fonts of the system for letters that the font of figures lacks;
    /// `numbers` says whether its table is wanted too.
    ///
    /// # Errors
    /// One sentence.
    pub fn draw(&self, prepared: &Prepared, numbers: bool) -> Result<Page, ExportError> {
        let page = draw(&self.page(), &prepared.subjects, &prepared.made, numbers);
        let mut page = page.map_err(ExportError::Other)?;
        page.paper.fallback = fonts::for_letters(&font::lacking(&page.paper.drawing, &[]));
        Ok(page)
    }
}
