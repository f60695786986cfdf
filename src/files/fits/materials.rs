//! Entries of a fit file grouped by material.

use super::record::{FitEntry, FitRecord, SourceFile};
use crate::brdf::Brdf;
use crate::files::paths::{absolute, material_name};
use std::collections::{HashMap, HashSet};
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
                fit: Some(Box::new(record.clone())),
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
    let mut places = Places::default();
    for (index, entry) in entries.into_iter().enumerate() {
        let tried: Vec<PathBuf> = entry
            .source
            .iter()
            .flat_map(|source| source.places(folder))
            .collect();
        let found = tried.iter().find(|place| place.is_file()).cloned();
        if let Some(at) = places.of(&entry, &found, &all) {
            let fits = &mut all[at];
            if fits.entries[0].material != entry.material {
                places.mixed.insert(at);
            }
            fits.entries.push(entry);
            if fits.found.is_none() && found.is_some() {
                (fits.found, fits.places) = (found, tried);
            }
            continue;
        }
        let name = match &entry.material {
            Some(name) => name.clone(),
            None if single => material_name(&path),
            None => format!("{} {index}", material_name(&path)),
        };
        places.add(all.len(), &name, &entry);
        all.push(MaterialFits {
            name,
            source: entry.source.clone(),
            found,
            places: tried,
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

/// Positions of materials by what their entries have in common, so that a file of many is read in a time in proportion.
#[derive(Default)]
struct Places {
    /// By the path of the measured file.
    by_path: HashMap<PathBuf, usize>,
    /// By SHA-256, in small letters, and name.
    by_data: HashMap<(String, Option<String>), Vec<usize>>,
    /// By name, where no measured file is named.
    by_name: HashMap<String, usize>,
    /// Those whose entries have several names.
    mixed: HashSet<usize>,
}

impl Places {
    /// Keeps where the material that begins with an entry is.
    fn add(&mut self, at: usize, name: &str, entry: &FitEntry) {
        match &entry.source {
            Some(source) => {
                self.by_path.entry(source.path.clone()).or_insert(at);
                let data = data_of(source).map(|data| (data, entry.material.clone()));
                if let Some(data) = data {
                    self.by_data.entry(data).or_default().push(at);
                }
            }
            None => {
                self.by_name.entry(name.to_owned()).or_insert(at);
            }
        }
    }

    /// The first material that an entry, whose measured file was `found`, is one of.
    fn of(&self, entry: &FitEntry, found: &Option<PathBuf>, all: &[MaterialFits]) -> Option<usize> {
        let Some(source) = &entry.source else {
            return self.by_name.get(entry.material.as_ref()?).copied();
        };
        let data = data_of(source).map(|data| (data, entry.material.clone()));
        let alike = data.and_then(|data| self.by_data.get(&data));
        let same_data = alike.into_iter().flatten().find(|at| {
            let both = found.as_ref().zip(all[**at].found.as_ref());
            both.is_none_or(|(found, other)| found == other) && !self.mixed.contains(at)
        });
        let same_path = self.by_path.get(&source.path);
        same_data.into_iter().chain(same_path).min().copied()
    }
}

fn data_of(source: &SourceFile) -> Option<String> {
    source.sha256.as_ref().map(|hash| hash.to_ascii_lowercase())
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
