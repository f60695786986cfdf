//! Computation of the view in the background.

use crate::app::state::State;
use crate::app::state::cache::{Query, Update, WhenNewer};
use crate::app::state::shared_table::SharedTable;
use crate::app::views::landscape::settings::LandscapeSettings;
use crate::brdf::Fresnel;
use crate::fit::landscape::{Eta, Landscape};
use crate::fit::{FitProgress, Problem, ProblemError, Weight, landscape};
use std::ops::ControlFlow;

/// The best E of the combined model over (s, α).
#[derive(Clone, Debug, PartialEq)]
pub struct LandscapeQuery {
    /// The material.
    pub data: SharedTable,
    /// Weight of the cells in E.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// The factor on the specular term.
    pub fresnel: Fresnel,
    /// Treatment of η: fixed, or optimised at every node.
    pub eta: Eta,
}

impl LandscapeQuery {
    /// Query for the shown material and the model over it. A fit under way moves η with every report: the query stays
    /// with the place of the sliders.
    pub fn of(state: &State) -> Option<Self> {
        let (material, _) = state.current()?;
        let brdf = state.scene.opened.get(state.scene.selected)?.brdf;
        let settings = &state.fit.settings;
        let eta = match brdf.fresnel {
            // It does not matter, and must not make a difference.
            Fresnel::None => Eta::Fixed(1.0),
            _ if state.scene.views.get::<LandscapeSettings>().solve_eta => Eta::Optimised,
            _ => Eta::Fixed(brdf.params.eta),
        };
        Some(Self {
            data: SharedTable(material.table.clone()),
            weight: settings.weight,
            limit: settings.limit,
            fresnel: brdf.fresnel,
            eta,
        })
    }
}

impl Query for LandscapeQuery {
    type Output = Result<Landscape, ProblemError>;
    const DOING: &'static str = "computing the error landscape";
    const WHEN_NEWER: WhenNewer = WhenNewer::Cancel;

    fn run(
        &self,
        report: &mut dyn FnMut(Update<Self::Output>) -> ControlFlow<()>,
    ) -> Option<Self::Output> {
        let problem = match Problem::new(&self.data.0, self.weight, self.limit) {
            Ok(problem) => problem,
            Err(error) => return Some(Err(error)),
        };
        let mut say = |word| {
            report(match word {
                landscape::LandscapeUpdate::Progress(share) => Update::Progress(share),
                landscape::LandscapeUpdate::Grid(grid) => Update::Partial(Ok(grid)),
            })
        };
        landscape::landscape(&problem, self.fresnel, self.eta, &mut say).map(Ok)
    }
}

/// Corners of a path at most.
const MOST: usize = 400;

/// The way of the fit under way, or of the last one of the shown model, from its start to its end.
pub fn path(state: &State) -> Vec<[f64; 2]> {
    let updates: &[FitProgress] = match state.current_run().and_then(|run| run.current_part()) {
        Some(part) => &part.updates,
        None => state.current_fit().map_or(&[], |fit| &fit.trace),
    };
    let step = updates.len().div_ceil(MOST).max(1);
    let kept = updates.iter().step_by(step).chain(updates.last());
    let mut path: Vec<[f64; 2]> = kept
        .map(|progress| landscape::place(&progress.brdf))
        .collect();
    path.dedup();
    path
}
