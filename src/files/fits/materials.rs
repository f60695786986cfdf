//! Entries of a fit file grouped by material.

use super::record::{FitEntry, FitRecord, SourceFile};
use crate::brdf::Brdf;
use crate::files::paths::{absolute, material_name};
use std::path::{Path, PathBuf};

/// Models of one material in a fit file.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialFits {
    /// Name of the material.
    pub name: String,
    /// Measured file as named by the fit file; `None` where it names none.
    pub source: Option<SourceFile>,
    /// Paths at which the measured file may be, absolute, in the order of [`SourceFile::places`].
    pub places: Vec<PathBuf>,
    /// Path of the measured file; `None` where it is at none of `places`.
    pub found: Option<PathBuf>,
    /// Model with the smallest E; the first where no E is given.
    pub best: Brdf,
    /// Entries by ascending E, those without E last.
    pub entries: Vec<FitEntry>,
}

impl MaterialFits {
    /// Fits of a measured file that exists, grouped as those of a fit file; `None` without any.
    pub fn of_records(
        name: String,
        source: Option<SourceFile>,
        found: &Path,
        records: &[FitRecord],
    ) -> Option<Self> {
        let mut entries: Vec<FitEntry> = records
            .iter()
            .map(|record| FitEntry {
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

/// Sorts entries by ascending E, those without E last.
fn sort(entries: &mut [FitEntry]) {
    let error = |entry: &FitEntry| entry.error.unwrap_or(f64::INFINITY);
    entries.sort_by(|a, b| error(a).total_cmp(&error(b)));
}

/// Groups the entries of the file `path` by material and checks which measured files exist.
///
/// Entries belong together if they were fitted to the same path; to the same bytes under the same name, unless two such
/// files are there, which are two materials; or if none of them names a source and they have the same material. Entries
/// without a name are each on their own, named after the file.
pub fn by_material(path: &Path, entries: Vec<FitEntry>) -> Vec<MaterialFits> {
    let path = absolute(path);
    let folder = path.parent().unwrap_or(Path::new(""));
    let single = entries.len() == 1;
    let mut all: Vec<MaterialFits> = Vec::new();
    for (index, entry) in entries.into_iter().enumerate() {
        let places: Vec<PathBuf> = entry
            .source
            .iter()
            .flat_map(|source| source.places(folder))
            .collect();
        let found = places.iter().find(|place| place.is_file()).cloned();
        let same = all.iter_mut().find(|fits| belongs(&entry, &found, fits));
        if let Some(fits) = same {
            fits.entries.push(entry);
            if fits.found.is_none() && found.is_some() {
                (fits.found, fits.places) = (found, places);
            }
            continue;
        }
        let name = match &entry.material {
            Some(name) => name.clone(),
            None if single => material_name(&path),
            None => format!("{} {index}", material_name(&path)),
        };
        all.push(MaterialFits {
            name,
            source: entry.source.clone(),
            found,
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

/// Entry with the smallest E among the fits of a measured file: those made from the same path or the same bytes.
pub fn best_of<'a>(entries: &'a [FitEntry], source: &SourceFile) -> Option<&'a FitEntry> {
    let of_it = entries.iter().filter(|entry| {
        let same =
            |other: &SourceFile| other.path == source.path || other.same_data(source) == Some(true);
        entry.source.as_ref().is_some_and(same)
    });
    let error = |entry: &FitEntry| entry.error.unwrap_or(f64::INFINITY);
    of_it.min_by(|a, b| error(a).total_cmp(&error(b)))
}

/// Whether an entry, whose measured file was `found`, is one of a material.
fn belongs(entry: &FitEntry, found: &Option<PathBuf>, fits: &MaterialFits) -> bool {
    let named_alike = || {
        fits.entries
            .iter()
            .all(|other| other.material == entry.material)
    };
    match (&entry.source, &fits.source) {
        (Some(a), Some(b)) if a.path == b.path => true,
        (Some(a), Some(b)) if a.same_data(b) == Some(true) => {
            let both = found.as_ref().zip(fits.found.as_ref());
            named_alike() && both.is_none_or(|(found, other)| found == other)
        }
        (None, None) => entry.material.as_ref() == Some(&fits.name),
        _ => false,
    }
}
