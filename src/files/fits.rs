//! Fit files: what was fitted, how, and what came out, for the window and the command line alike.
//!
//! A fit file is a JSON array with an object per fit; `docs/formats.md` documents its keys. Each object is also a model that
//! [`crate::brdf::json`] reads. A CSV of the same fits is written for spreadsheets and not read.

mod csv;
mod json;

pub use csv::write_csv;
pub use json::{entries, from_value, to_value, write_json};

use crate::brdf::{Brdf, Params};
use crate::fit::{Ended, Errors, Options, Outcome, Stage, Weight};
use crate::geom::Rgb;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Which measured file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceFile {
    /// Its path, from the root on where this program wrote it.
    pub path: String,
    /// Its length.
    pub bytes: Option<u64>,
    /// SHA-256 of its bytes in hexadecimal.
    pub sha256: Option<String>,
}

impl SourceFile {
    /// Whether both are the same bytes; `None` where one of them is not known.
    pub fn same_data(&self, other: &Self) -> Option<bool> {
        let (a, b) = (self.sha256.as_ref()?, other.sha256.as_ref()?);
        Some(a.eq_ignore_ascii_case(b))
    }

    /// The places where it may be, in the order in which to look: its path, seen from `folder` if it is relative;
    /// in `folder` under the same name, as happens when both were moved.
    pub fn places(&self, folder: &Path) -> [PathBuf; 2] {
        // The path may come from another system.
        let name = self.path.rsplit(['/', '\\']).next().unwrap_or(&self.path);
        [folder.join(&self.path), folder.join(name)]
    }
}

/// A stage of a fit as the file keeps it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageRecord {
    /// Which one.
    pub stage: Stage,
    /// E where it began.
    pub start_error: f64,
    /// E where it ended.
    pub error: f64,
    /// How many shapes (s, α, η) it has tried.
    pub evaluations: usize,
    /// Where it ended.
    pub params: Params,
}

/// A fit with all that one must know to repeat it.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRecord {
    /// Name of the material.
    pub material: String,
    /// The measured file; `None` for data without one.
    pub source: Option<SourceFile>,
    /// Version of the program that fitted.
    pub version: String,
    /// How much a cell counted.
    pub weight: Weight,
    /// The grazing limit in degrees.
    pub limit_deg: f64,
    /// Stages, what was held, where it began, bounds.
    pub options: Options,
    /// The fitted model.
    pub brdf: Brdf,
    /// Its E.
    pub errors: Errors,
    /// The stages that were run, in order.
    pub stages: Vec<StageRecord>,
    /// Directional albedo at [`crate::fit::outcome::ALBEDO_ANGLES`].
    pub albedo: [Rgb; 3],
    /// How many shapes (s, α, η) were tried in all.
    pub evaluations: usize,
    /// Why it ended.
    pub ended: Ended,
    /// What to know before trusting it, as sentences.
    pub concerns: Vec<String>,
}

impl FitRecord {
    /// The record of a fit made by this program.
    pub fn new(
        material: String,
        source: Option<SourceFile>,
        (weight, limit_deg): (Weight, f64),
        options: &Options,
        outcome: &Outcome,
    ) -> Self {
        let stages = outcome.stages.iter().map(|report| StageRecord {
            stage: report.stage,
            start_error: report.start_error,
            error: report.error,
            evaluations: report.evaluations,
            params: report.end.params,
        });
        Self {
            material,
            source,
            version: env!("CARGO_PKG_VERSION").into(),
            weight,
            limit_deg,
            options: *options,
            brdf: outcome.brdf,
            errors: outcome.errors,
            stages: stages.collect(),
            albedo: outcome.albedo,
            evaluations: outcome.evaluations,
            ended: outcome.ended,
            concerns: outcome.concerns.iter().map(|c| c.text()).collect(),
        }
    }

    /// Whether the model reflects more than it receives at one of the angles.
    pub fn exceeds_one(&self) -> bool {
        self.albedo.iter().flatten().any(|albedo| *albedo > 1.0)
    }
}

/// A model of a JSON file with what the file says around it.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The model.
    pub brdf: Brdf,
    /// Name of the material, in one line.
    pub material: Option<String>,
    /// The measured file that it was fitted to.
    pub source: Option<SourceFile>,
    /// Its E.
    pub error: Option<f64>,
    /// All the rest, where the entry is a whole fit and no plain model.
    pub fit: Option<FitRecord>,
}

/// The models that a file has for one material.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialFits {
    /// Name of the material.
    pub name: String,
    /// The measured file as the fit file names it.
    pub source: Option<SourceFile>,
    /// Where the measured file may be, see [`SourceFile::places`]; from the root on.
    pub places: Vec<PathBuf>,
    /// The measured file that is there.
    pub found: Option<PathBuf>,
    /// The model with the smallest E; the first where no E is given.
    pub best: Brdf,
    /// All models by ascending E, those without E last.
    pub entries: Vec<Entry>,
}

impl MaterialFits {
    /// Fits of a measured file that is there, as a fit file would bring them; `None` without any.
    pub fn of_records(
        name: String,
        source: Option<SourceFile>,
        found: &Path,
        records: &[FitRecord],
    ) -> Option<Self> {
        let mut entries: Vec<Entry> = records
            .iter()
            .map(|record| Entry {
                brdf: record.brdf,
                material: Some(record.material.clone()),
                source: record.source.clone(),
                error: Some(record.errors.total),
                fit: Some(record.clone()),
            })
            .collect();
        sort(&mut entries);
        Some(Self {
            name,
            source,
            places: vec![found.to_owned()],
            found: Some(found.to_owned()),
            best: entries.first()?.brdf,
            entries,
        })
    }
}

/// By ascending E, those without E last.
fn sort(entries: &mut [Entry]) {
    let error = |entry: &Entry| entry.error.unwrap_or(f64::INFINITY);
    entries.sort_by(|a, b| error(a).total_cmp(&error(b)));
}

/// Sorts the entries of the file `path` by material and looks which measured files are there.
///
/// Entries belong together if they were fitted to the same path or to the same bytes, or if none of them names a
/// source and they have the same material. Nameless ones are each on their own, named after the file.
pub fn by_material(path: &Path, entries: Vec<Entry>) -> Vec<MaterialFits> {
    let path = super::absolute(path);
    let folder = path.parent().unwrap_or(Path::new(""));
    let single = entries.len() == 1;
    let mut all: Vec<MaterialFits> = Vec::new();
    for (index, entry) in entries.into_iter().enumerate() {
        if let Some(fits) = all.iter_mut().find(|fits| belongs(&entry, fits)) {
            fits.entries.push(entry);
            continue;
        }
        let places: Vec<PathBuf> = entry
            .source
            .iter()
            .flat_map(|source| source.places(folder))
            .collect();
        let name = match &entry.material {
            Some(name) => name.clone(),
            None if single => super::material_name(&path),
            None => format!("{} {index}", super::material_name(&path)),
        };
        all.push(MaterialFits {
            name,
            source: entry.source.clone(),
            found: places.iter().find(|place| place.is_file()).cloned(),
            places,
            best: entry.brdf,
            entries: vec![entry],
        });
    }
    for fits in &mut all {
        sort(&mut fits.entries);
        fits.best = fits.entries[0].brdf;
    }
    all
}

/// The model with the smallest E among the fits of a measured file: those made from the same path or the same bytes.
pub fn best_of<'a>(entries: &'a [Entry], source: &SourceFile) -> Option<&'a Entry> {
    let of_it = entries.iter().filter(|entry| {
        let same =
            |other: &SourceFile| other.path == source.path || other.same_data(source) == Some(true);
        entry.source.as_ref().is_some_and(same)
    });
    let error = |entry: &Entry| entry.error.unwrap_or(f64::INFINITY);
    of_it.min_by(|a, b| error(a).total_cmp(&error(b)))
}

fn belongs(entry: &Entry, fits: &MaterialFits) -> bool {
    match (&entry.source, &fits.source) {
        (Some(a), Some(b)) => a.path == b.path || a.same_data(b) == Some(true),
        (None, None) => entry.material.as_ref() == Some(&fits.name),
        _ => false,
    }
}

#[cfg(test)]
mod tests;
