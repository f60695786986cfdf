//! The materials that have a fit of the shown model, each with its dot.

use crate::app::state::State;
use crate::app::state::fitted::{Fitted, MaterialPlace};
use crate::app::views::scatter::settings::ScatterSettings;
use crate::brdf::{Brdf, Model};
use crate::figure::palette::Role;
use crate::figure::scatter::ScatterDot;

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

/// The open materials, then the files of the folder that are not open.
pub fn rows(state: &State, view: &ScatterSettings) -> Vec<ScatterRow> {
    let materials = state.fitted_materials().into_iter();
    materials
        .filter_map(|material| {
            let fit = best(view.model, &material.fits)?;
            let error = fit.errors.total;
            let [x, y] = view.values(&fit.brdf, Some(error))?;
            let (ring, shown) = match material.place {
                MaterialPlace::Open(index) => {
                    (Some(Role::Series(index)), index == state.scene.selected)
                }
                MaterialPlace::File(_) => (None, false),
            };
            Some(ScatterRow {
                brdf: fit.brdf,
                error,
                dot: ScatterDot {
                    name: material.name,
                    x,
                    y,
                    fill: material.color.or(ring).unwrap_or(Role::Muted),
                    ring,
                    shown,
                },
                place: material.place,
            })
        })
        .collect()
}

/// Fit of the model with the smallest E.
fn best<'a>(model: &Model, fits: &'a [Fitted]) -> Option<&'a Fitted> {
    fits.iter()
        .filter(|fit| fit.brdf.model == model)
        .min_by(|a, b| a.errors.total.total_cmp(&b.errors.total))
}
