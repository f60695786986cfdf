//! Preparation of a figure before it can be drawn: data in memory, surveys of a fit.

use super::error::ExportError;
use super::fit_output;
use super::fonts;
use super::spec::{FigureSpec, SubjectLook, SubjectSource, SubjectSpec};
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
pub type OpenedTables = BTreeMap<PathBuf, Arc<Table>>;

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
    for panel in panels {
        let of_panel: Vec<&Subject> = panel
            .subjects
            .iter()
            .filter_map(|at| subjects.get(*at))
            .collect();
        all.push(fit_output::of_panel(&panel.view, &of_panel, follow)?);
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
            if let Some(table) = known.get(&place) {
                return Ok(Arc::clone(table));
            }
            let (table, found) = files::open_measured(&place, &mut |_| ControlFlow::Continue(()))?;
            if found.same_data(file) == Some(false) && !changed_is_fine {
                let what = "the file is not the one that the figure was drawn from (its SHA-256 differs); --changed draws it all the same";
                return Err(FileError::new(&place, what).into());
            }
            let table = Arc::new(table);
            known.insert(place, Arc::clone(&table));
            Ok(table)
        }
        SubjectSource::Sample { key, .. } => {
            let place = PathBuf::from(format!("sample:{key}"));
            if let Some(table) = known.get(&place) {
                return Ok(Arc::clone(table));
            }
            let sample = SyntheticMaterial::by_key(key).ok_or_else(|| {
                let proposal = keys::did_you_mean(key, SAMPLES.iter().map(|sample| sample.key));
                ExportError::Other(format!(
                    "unknown sample {}; `grazing sample --list` shows them{proposal}",
                    quoted(key)
                ))
            })?;
            let table = Arc::new(sample.synthesize());
            known.insert(place, Arc::clone(&table));
            Ok(table)
        }
        SubjectSource::Model(_) => Err(ExportError::Other("a model has no data".into())),
    }
}

fn place_of(file: &SourceFile, folder: &Path) -> Result<PathBuf, FileError> {
    let places = file.places(folder);
    let found = places.iter().find(|place| place.is_file()).cloned();
    found.ok_or_else(|| {
        let what = "the measured file of the figure is missing; put it there or beside the figure";
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
    /// Draws it from what [`prepare`] has brought, with fonts of the system for letters that the font of figures lacks.
    ///
    /// # Errors
    /// One sentence.
    pub fn draw(&self, prepared: &Prepared) -> Result<Page, ExportError> {
        let page = draw(&self.page(), &prepared.subjects, &prepared.made);
        let mut page = page.map_err(ExportError::Other)?;
        page.paper.fallback = fonts::for_letters(&font::lacking(&page.paper.drawing, &[]));
        Ok(page)
    }
}
