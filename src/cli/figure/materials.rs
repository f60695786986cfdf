//! Materials with their models, from measured files and fit files; what has no fit is fitted.

use crate::brdf::Brdf;
use crate::cli::CliError;
use crate::cli::fit::progress::Bar;
use crate::export::preset::PresetMaterial;
use crate::export::{OpenedTables, SubjectSource};
use crate::files::fits;
use crate::files::names::told_apart;
use crate::files::{self, FileError};
use crate::fit::options::NO_LIMIT;
use crate::fit::{self, FitOptions, Problem, Variant, Weight};
use crate::measured::Table;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A measured file and the fits that are known of it.
struct MaterialFiles {
    path: PathBuf,
    name: String,
    models: Vec<Brdf>,
}

/// The materials in the order in which they are named, each with a model per variant.
pub(super) fn of_files(
    paths: &[PathBuf],
    variants: &[Variant],
    opened: &mut OpenedTables,
) -> Result<Vec<PresetMaterial>, CliError> {
    let mut found: Vec<MaterialFiles> = Vec::new();
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
    let named: Vec<_> = found
        .iter()
        .map(|found| (found.name.clone(), Some(found.path.clone())))
        .collect();
    for (found, name) in found.iter_mut().zip(told_apart(&named)) {
        found.name = name;
    }
    let mut bar = Bar::new(found.len(), variants);
    let mut materials = Vec::new();
    for (index, found) in found.into_iter().enumerate() {
        bar.file(index, &found.path);
        materials.push(material(found, variants, opened, &mut bar)?);
    }
    bar.finish();
    Ok(materials)
}

/// The place of a file among those found, which it is added to where it is new. Two names of one file are two materials.
fn at<'a>(found: &'a mut Vec<MaterialFiles>, path: &Path) -> &'a mut MaterialFiles {
    let path = files::named_place(path);
    let index = found.iter().position(|found| found.path == path);
    let index = index.unwrap_or_else(|| {
        found.push(MaterialFiles {
            path: path.clone(),
            name: files::material_name(&path),
            models: Vec::new(),
        });
        found.len() - 1
    });
    &mut found[index]
}

fn add_fits(
    found: &mut Vec<MaterialFiles>,
    path: &Path,
    fits: &fits::MaterialFits,
) -> Result<(), FileError> {
    let Some(file) = &fits.found else {
        let name = &fits.name;
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
    found: MaterialFiles,
    variants: &[Variant],
    opened: &mut OpenedTables,
    bar: &mut Bar,
) -> Result<PresetMaterial, CliError> {
    let (table, file) = files::open_measured(&found.path, &mut |_| ControlFlow::Continue(()))?;
    let table = Arc::new(table);
    let place = file.places(Path::new(""));
    opened.insert(place[0].clone(), Arc::clone(&table));
    let models = models(&found, &table, variants, bar)?;
    Ok(PresetMaterial {
        name: found.name,
        source: SubjectSource::measured(file),
        models,
    })
}

fn models(
    found: &MaterialFiles,
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
            .map_err(|error| FileError::new(&found.path, error.to_string()))?;
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
