//! Materials with their models, from measured files and fit files or the synthetic ones; what has no fit is fitted.

use crate::brdf::Brdf;
use crate::cli::CliError;
use crate::cli::fit::progress::Bar;
use crate::export::preset::PresetMaterial;
use crate::export::{OpenedTable, OpenedTables, SubjectSource, open_from_files};
use crate::files::fits;
use crate::files::fits::FitRecord;
use crate::files::names::told_apart;
use crate::files::{self, FileError};
use crate::fit::options::NO_LIMIT;
use crate::fit::{
    self, EndReason, Errors, FitOptions, Outcome, Problem, ProblemError, Variant, Weight,
};
use crate::measured::{SAMPLES, SyntheticMaterial, Table};
use crate::quote::shown;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Needs of a preset of each material.
pub(super) struct Needs<'a> {
    /// Models over the data.
    pub variants: &'a [Variant],
    /// Whether their errors are needed, and no data where a fit file has them.
    pub errors: bool,
}

/// A material and the fits that are known of it.
struct Found {
    data: Data,
    name: String,
    models: Vec<Known>,
}

/// A model that a file has.
struct Known {
    brdf: Brdf,
    /// E where it is that which a figure compares: with the default weight, and over all cells.
    errors: Option<Errors>,
}

/// Where values come from.
#[derive(PartialEq)]
enum Data {
    File(PathBuf),
    Sample(&'static str),
    /// A measured file that is not there: the fit file that names it, and where it should be.
    Missing(PathBuf, PathBuf),
}

/// The materials in the order in which they are named, each with a model per variant; the synthetic ones where none is
/// named.
pub(super) fn of_files(
    paths: &[PathBuf],
    needs: &Needs,
    opened: &mut OpenedTables,
) -> Result<Vec<PresetMaterial>, CliError> {
    let mut found: Vec<Found> = Vec::new();
    for path in paths {
        match files::open_models(path)? {
            Some(entries) => {
                for fits in fits::by_material(path, entries) {
                    add_fits(&mut found, path, &fits);
                }
            }
            None => drop(at_file(&mut found, path)),
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
    let mut bar = Bar::new(found.len(), needs.variants);
    let mut materials = Vec::new();
    for (index, found) in found.into_iter().enumerate() {
        bar.file(index, &found.place());
        materials.push(material(&found, needs, opened, &mut bar)?);
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
            Data::File(path) | Data::Missing(_, path) => path.clone(),
            Data::Sample(key) => key.into(),
        }
    }
}

/// The place of a file among those found, which it is added to where it is new. Two names of one file are two materials.
fn at_file<'a>(found: &'a mut Vec<Found>, path: &Path) -> &'a mut Found {
    let path = files::named_place(path);
    let name = files::material_name(&path);
    at(found, Data::File(path), name)
}

fn at(found: &mut Vec<Found>, data: Data, name: String) -> &mut Found {
    let index = found.iter().position(|found| found.data == data);
    let index = index.unwrap_or_else(|| {
        found.push(Found {
            data,
            name,
            models: Vec::new(),
        });
        found.len() - 1
    });
    &mut found[index]
}

fn add_fits(found: &mut Vec<Found>, path: &Path, fits: &fits::MaterialFits) {
    let material = match &fits.found {
        Some(file) => at_file(found, file),
        None => {
            let place = fits.places.first().cloned().unwrap_or_default();
            let place = if place.as_os_str().is_empty() {
                PathBuf::from(&fits.name)
            } else {
                place
            };
            at(
                found,
                Data::Missing(path.to_owned(), place),
                fits.name.clone(),
            )
        }
    };
    // By ascending E: the first of a variant is its best.
    let known = fits.entries.iter().map(|entry| Known {
        brdf: entry.brdf,
        errors: entry.fit.as_deref().and_then(comparable_errors),
    });
    material.models.extend(known);
}

/// E of a fit that ran to its end with the default weight over all cells.
fn comparable_errors(fit: &FitRecord) -> Option<Errors> {
    let over_all = (fit.limit_deg.to_radians() - NO_LIMIT).abs() < 1e-9;
    let comparable =
        fit.weight == Weight::default() && over_all && fit.ended != EndReason::Cancelled;
    comparable.then_some(fit.errors)
}

fn material(
    found: &Found,
    needs: &Needs,
    opened: &mut OpenedTables,
    bar: &mut Bar,
) -> Result<PresetMaterial, CliError> {
    let known = |variant: &Variant| {
        let mut models = found.models.iter();
        models.find(|known| {
            Variant::from(&known.brdf) == *variant && (known.errors.is_some() || !needs.errors)
        })
    };
    let missing: Vec<Variant> = needs
        .variants
        .iter()
        .filter(|variant| known(variant).is_none())
        .copied()
        .collect();
    let mut source = None;
    let mut fitted = Vec::new();
    if !needs.errors || !missing.is_empty() {
        let (table, place) = open(found, opened)?;
        if !missing.is_empty() {
            fitted = fit_missing(&table, &missing, bar)
                .map_err(|error| FileError::new(&found.place(), error.to_string()))?;
        }
        source = Some(place);
    }
    let of = |variant: &Variant| {
        let outcome = |outcome: &&Outcome| Variant::from(&outcome.brdf) == *variant;
        match known(variant) {
            Some(known) => Some((known.brdf, known.errors)),
            None => fitted
                .iter()
                .find(outcome)
                .map(|outcome| (outcome.brdf, Some(outcome.errors))),
        }
    };
    let models: Vec<_> = needs.variants.iter().filter_map(of).collect();
    Ok(PresetMaterial {
        name: found.name.clone(),
        source,
        models: models.iter().map(|(brdf, _)| *brdf).collect(),
        errors: if needs.errors {
            models.iter().filter_map(|(_, errors)| *errors).collect()
        } else {
            Vec::new()
        },
    })
}

/// The data of a material, and how a figure names them.
fn open(found: &Found, opened: &mut OpenedTables) -> Result<(Arc<Table>, SubjectSource), CliError> {
    match &found.data {
        Data::File(path) => {
            let (table, file) = files::open_measured(path, &mut |_| ControlFlow::Continue(()))?;
            let table = Arc::new(table);
            let place = file.places(Path::new(""));
            let kept = OpenedTable {
                table: Arc::clone(&table),
                file: Some(file.clone()),
            };
            opened.insert(place[0].clone(), kept);
            Ok((table, SubjectSource::measured(file)))
        }
        Data::Sample(key) => {
            let source = SubjectSource::sample(key);
            let table = open_from_files(&source, Path::new(""), false, opened)?;
            Ok((table, source))
        }
        Data::Missing(fit_file, _) => {
            let name = shown(&found.name);
            let what = format!(
                "the measured file of {name} is missing, and a figure needs it; put it where the fit file says or beside it"
            );
            Err(FileError::new(fit_file, what).into())
        }
    }
}

fn fit_missing(
    table: &Table,
    missing: &[Variant],
    bar: &mut Bar,
) -> Result<Vec<Outcome>, ProblemError> {
    let problem = Problem::new(table, Weight::default(), NO_LIMIT)?;
    let watch = &mut |position: usize, progress: &fit::FitProgress| {
        bar.progress(position, progress);
        ControlFlow::Continue(())
    };
    let options = FitOptions::default();
    Ok(fit::fit_all(&problem, missing, &options, watch))
}
