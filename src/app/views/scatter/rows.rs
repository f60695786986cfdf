//! The materials that have a fit of the shown model, each with its dot.

use crate::app::state::State;
use crate::app::views::scatter::settings::ScatterSettings;
use crate::brdf::{Brdf, Model};
use crate::figure::palette::Role;
use crate::figure::scatter::ScatterDot;
use crate::files;
use std::path::{Path, PathBuf};

/// A material with a fit of the shown model.
pub struct ScatterRow {
    /// The fit.
    pub brdf: Brdf,
    /// E of the fit as a share.
    pub error: f64,
    /// Name, place and colour.
    pub dot: ScatterDot,
    /// Shows it.
    pub place: MaterialPlace,
}

/// Place of a material.
pub enum MaterialPlace {
    /// Position among the open ones.
    Open(usize),
    /// File of the folder.
    File(PathBuf),
}

/// The open materials, then the files of the folder that are not open.
pub fn rows(state: &State, view: &ScatterSettings) -> Vec<ScatterRow> {
    let mut rows = Vec::new();
    let mut add = |name: String, (brdf, error): (Brdf, f64), fill, series, shown, place| {
        let Some([x, y]) = view.values(&brdf, Some(error)) else {
            return;
        };
        rows.push(ScatterRow {
            brdf,
            error,
            dot: ScatterDot {
                name,
                x,
                y,
                fill,
                ring: series,
                shown,
            },
            place,
        });
    };
    let mut open = Vec::new();
    for (index, opened) in state.scene.opened.iter().enumerate() {
        let Some(material) = state.materials.get(&opened.id) else {
            continue;
        };
        let path = material.file();
        let color = path.as_ref().and_then(|path| color_of(state, path));
        open.extend(path);
        let fits = material.fits.iter().map(|fit| &fit.outcome);
        let fits = fits.map(|outcome| (outcome.brdf, outcome.errors.total));
        if let Some(fit) = best(view.model, fits) {
            let series = Role::Series(index);
            let shown = index == state.scene.selected;
            let fill = color.unwrap_or(series);
            let place = MaterialPlace::Open(index);
            add(material.name.clone(), fit, fill, Some(series), shown, place);
        }
    }
    let files = state.library.folder.iter().flat_map(|folder| &folder.files);
    for file in files.filter(|file| !open.contains(&file.path)) {
        let fits = state.library.fits.get(&file.path).into_iter().flatten();
        let fits = fits.map(|fit| (fit.brdf, fit.errors.total));
        if let Some(fit) = best(view.model, fits) {
            let name = files::material_name(&file.path);
            let fill = color_of(state, &file.path).unwrap_or(Role::Muted);
            let place = MaterialPlace::File(file.path.clone());
            add(name, fit, fill, None, false, place);
        }
    }
    rows
}

/// Fit of the model with the smallest E.
fn best(model: &Model, fits: impl Iterator<Item = (Brdf, f64)>) -> Option<(Brdf, f64)> {
    fits.filter(|(brdf, _)| brdf.model == model)
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The colour of the material in a file of the folder, where it has been read.
fn color_of(state: &State, path: &Path) -> Option<Role> {
    let mut files = state.library.folder.as_ref()?.files.iter();
    let file = files.find(|file| file.path == path)?;
    Some(Role::Fixed(file.examined()?.color))
}
