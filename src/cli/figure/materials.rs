//! Materials with their models, from measured files and fit files or the synthetic ones; what has no fit is fitted.

use crate::brdf::Brdf;
use crate::cli::CliError;
use crate::cli::fit::progress::Bar;
use crate::export::preset::PresetMaterial;
use crate::export::{OpenedTable, OpenedTables, SubjectSource, open_from_files};
use crate::files::fits;
use crate::files::names::told_apart;
use crate::files::{self, FileError};
use crate::fit::options::NO_LIMIT;
use crate::fit::{self, FitOptions, Problem, Variant, Weight};
use crate::measured::{SAMPLES, SyntheticMaterial, Table};
use crate::quote::shown;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A material and the fits that are known of it.
struct Found {
    data: Data,
    name: String,
    models: Vec<Brdf>,
}

/// Where values come from.
#[derive(PartialEq)]
enum Data {
    File(PathBuf),
    Sample(&'static str),
}

/// The materials in the order in which they are named, each with a model per variant; the synthetic ones where none is
/// named.
pub(super) fn of_files(
    paths: &[PathBuf],
    variants: &[Variant],
    opened: &mut OpenedTables,
) -> Result<Vec<PresetMaterial>, CliError> {
    let mut found: Vec<Found> = Vec::new();
    for path in paths {
        match files::open_models(path)? {
            Some(entries) => {
                for fits in fits::by_material(path, entries) {
                    add_fits(&mut found, path, &fits)?;
                }
            }
            None => drop(at(&mut found, path)),
        }
    }
    if paths.is_empty() {
        found.extend(SAMPLES.iter().map(Found::sample));
    }
    let named: Vec<_> = found
        .iter()
        .map(|found| (found.name.clone(), Some(found.place())))
        .collect();
    for (found, name) in found.iter_mut().zip(told_apart(&named)) {
        found.name = name;
    }
    let mut bar = Bar::new(found.len(), variants);
    let mut materials = Vec::new();
    for (index, found) in found.into_iter().enumerate() {
        bar.file(index, &found.place());
        materials.push(material(found, variants, opened, &mut bar)?);
    }
    bar.finish();
    Ok(materials)
}

impl Found {
    fn sample(sample: &SyntheticMaterial) -> Self {
        Self {
            data: Data::Sample(sample.key),
            name: sample.name.to_owned(),
            models: Vec::new(),
        }
    }

    /// The file, or the name of a synthetic material: for messages.
    fn place(&self) -> PathBuf {
        match &self.data {
            Data::File(path) => path.clone(),
            Data::Sample(key) => key.into(),
        }
    }
}

/// The place of a file among those found, which it is added to where it is new. Two names of one file are two materials.
fn at<'a>(found: &'a mut Vec<Found>, path: &Path) -> &'a mut Found {
    let path = files::named_place(path);
    let data = Data::File(path.clone());
    let index = found.iter().position(|found| found.data == data);
    let index = index.unwrap_or_else(|| {
        found.push(Found {
            data,
            name: files::material_name(&path),
            models: Vec::new(),
        });
        found.len() - 1
    });
    &mut found[index]
}

fn add_fits(
    found: &mut Vec<Found>,
    path: &Path,
    fits: &fits::MaterialFits,
) -> Result<(), FileError> {
    let Some(file) = &fits.found else {
        let name = shown(&fits.name);
        let what = format!(
            "the measured file of {name} is missing, and a figure needs it; put it where the fit file says or beside it"
        );
        return Err(FileError::new(path, what));
    };
    let material = at(found, file);
    // By ascending E: the first of a variant is its best.
    material
        .models
        .extend(fits.entries.iter().map(|entry| entry.brdf));
    Ok(())
}

fn material(
    found: Found,
    variants: &[Variant],
    opened: &mut OpenedTables,
    bar: &mut Bar,
) -> Result<PresetMaterial, CliError> {
    let (table, source) = match &found.data {
        Data::File(path) => {
            let (table, file) = files::open_measured(path, &mut |_| ControlFlow::Continue(()))?;
            let table = Arc::new(table);
            let place = file.places(Path::new(""));
            let kept = OpenedTable {
                table: Arc::clone(&table),
                file: Some(file.clone()),
            };
            opened.insert(place[0].clone(), kept);
            (table, SubjectSource::measured(file))
        }
        Data::Sample(key) => {
            let source = SubjectSource::sample(key);
            let table = open_from_files(&source, Path::new(""), false, opened)?;
            (table, source)
        }
    };
    let models = models(&found, &table, variants, bar)?;
    Ok(PresetMaterial {
        name: found.name,
        source,
        models,
    })
}

fn models(
    found: &Found,
    table: &Table,
    variants: &[Variant],
    bar: &mut Bar,
) -> Result<Vec<Brdf>, FileError> {
    let known = |variant: &Variant| {
        let mut models = found.models.iter();
        models
            .find(|brdf| Variant::from(*brdf) == *variant)
            .copied()
    };
    let missing: Vec<Variant> = variants
        .iter()
        .filter(|variant| known(variant).is_none())
        .copied()
        .collect();
    let mut fitted = Vec::new();
    if !missing.is_empty() {
        let problem = Problem::new(table, Weight::default(), NO_LIMIT)
            .map_err(|error| FileError::new(&found.place(), error.to_string()))?;
        let watch = &mut |position: usize, progress: &fit::FitProgress| {
            bar.progress(position, progress);
            ControlFlow::Continue(())
        };
        let outcomes = fit::fit_all(&problem, &missing, &FitOptions::default(), watch);
        fitted.extend(outcomes.into_iter().map(|outcome| outcome.brdf));
    }
    let of = |variant: &Variant| {
        let mut fitted = fitted.iter();
        known(variant).or_else(|| {
            fitted
                .find(|brdf| Variant::from(*brdf) == *variant)
                .copied()
        })
    };
    Ok(variants.iter().filter_map(of).collect())
}
