//! The materials of the ranking, from the fits that are kept.

use crate::app::state::State;
use crate::app::state::fitted::{Fitted, MaterialPlace};
use crate::app::views::ranking::settings::RankingSettings;
use crate::figure::ranking::{RankedFit, RankedMaterial, RankingSpec};

/// Content of the ranking.
pub struct RankingRows {
    /// Settings of the view with the materials.
    pub spec: RankingSpec,
    /// Places of the materials, in their order.
    pub places: Vec<MaterialPlace>,
    /// Number of fits that are left out, as their E is another quantity or they were stopped.
    pub left_out: usize,
}

/// Limits that differ by less are the same; files round them.
const SAME_LIMIT: f64 = 1e-6;

/// The kept fits with the present weight and grazing limit.
pub fn rows(state: &State, view: &RankingSettings) -> RankingRows {
    let now = &state.fit.settings;
    let comparable = |fit: &Fitted| {
        !fit.cancelled && fit.weight == now.weight && (fit.limit - now.limit).abs() < SAME_LIMIT
    };
    let mut rows = RankingRows {
        spec: view.clone(),
        places: Vec::new(),
        left_out: 0,
    };
    for material in state.fitted_materials() {
        let all = material.fits.len();
        let fits = material.fits.iter().filter(|fit| comparable(fit));
        let fits: Vec<RankedFit> = fits
            .map(|fit| RankedFit::new(&fit.brdf, fit.errors.total, fit.errors.grazing))
            .collect();
        rows.left_out += all - fits.len();
        if !fits.is_empty() {
            let name = material.name;
            rows.spec.materials.push(RankedMaterial { name, fits });
            rows.places.push(material.place);
        }
    }
    rows
}
