//! The materials that have fits: the open ones, and the files of the folder.

use crate::app::state::State;
use crate::brdf::Brdf;
use crate::figure::palette::Role;
use crate::files;
use crate::fit::{EndReason, Errors, Weight};
use std::path::{Path, PathBuf};

/// A material with fits.
pub struct FittedMaterial {
    /// Name on screen.
    pub name: String,
    /// Place from which it is shown.
    pub place: MaterialPlace,
    /// Colour of the material, where its file has been read.
    pub color: Option<Role>,
    /// Kept fits.
    pub fits: Vec<Fitted>,
}

/// Place of a material.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialPlace {
    /// Position among the open ones.
    Open(usize),
    /// File of the folder.
    File(PathBuf),
}

/// A kept fit in short.
#[derive(Clone, Copy)]
pub struct Fitted {
    /// Fitted model.
    pub brdf: Brdf,
    /// E of the fitted model.
    pub errors: Errors,
    /// Weight of the cells in E.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// Whether it was stopped before its end.
    pub cancelled: bool,
}

impl State {
    /// The open materials, then the files of the folder that are not open; those without a fit are left out.
    pub fn fitted_materials(&self) -> Vec<FittedMaterial> {
        let mut all = Vec::new();
        let mut open = Vec::new();
        for (index, opened) in self.scene.opened.iter().enumerate() {
            let Some(material) = self.materials.get(&opened.id) else {
                continue;
            };
            let path = material.file();
            let fits = material.fits.iter().map(|kept| Fitted {
                brdf: kept.outcome.brdf,
                errors: kept.outcome.errors,
                weight: kept.setup.weight,
                limit: kept.setup.limit,
                cancelled: kept.is_cancelled(),
            });
            all.push(FittedMaterial {
                name: material.name.clone(),
                place: MaterialPlace::Open(index),
                color: path.as_ref().and_then(|path| self.color_of(path)),
                fits: fits.collect(),
            });
            open.extend(path);
        }
        let files = self.library.folder.iter().flat_map(|folder| &folder.files);
        for file in files.filter(|file| !open.contains(&file.path)) {
            let records = self.library.fits.get(&file.path).into_iter().flatten();
            let fits = records.map(|record| Fitted {
                brdf: record.brdf,
                errors: record.errors,
                weight: record.weight,
                limit: record.limit_deg.to_radians(),
                cancelled: record.ended == EndReason::Cancelled,
            });
            all.push(FittedMaterial {
                name: files::material_name(&file.path),
                place: MaterialPlace::File(file.path.clone()),
                color: self.color_of(&file.path),
                fits: fits.collect(),
            });
        }
        all.retain(|material| !material.fits.is_empty());
        all
    }

    /// The colour of the material in a file of the folder, where it has been read.
    fn color_of(&self, path: &Path) -> Option<Role> {
        let mut files = self.library.folder.as_ref()?.files.iter();
        let file = files.find(|file| file.path == path)?;
        Some(Role::Fixed(file.examined()?.color))
    }
}
