//! The error landscape on paper.

use super::{LandscapeSpec, Terrain, axes};
use crate::brdf::Fresnel;
use crate::figure::faults::Faults;
use crate::figure::fit_output::FitOutput;
use crate::figure::heatmap::{HeatMap, HeatView};
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::scale::number;
use crate::figure::table::DataTable;
use crate::geom::degrees;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// An error landscape on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LandscapePanel {
    /// The Fresnel factor.
    pub fresnel: Fresnel,
    /// η everywhere; the best one at each point without.
    pub eta: Option<f64>,
    /// Weight of the cells in E, by its key.
    pub weight: String,
    /// Grazing limit in radians.
    #[serde(with = "degrees")]
    pub limit: f64,
    /// (s, α) of a fit, from its start to its end.
    pub path: Vec<[f64; 2]>,
    /// (s, α) of a model.
    pub here: Option<[f64; 2]>,
    /// The part in sight.
    pub view: HeatView,
}

impl Default for LandscapePanel {
    fn default() -> Self {
        Self {
            fresnel: Fresnel::Exact,
            eta: Some(1.5),
            weight: "cosine".into(),
            limit: FRAC_PI_2,
            path: Vec::new(),
            here: None,
            view: HeatView::default(),
        }
    }
}

/// Values of η: those of a model.
const ETAS: [f64; 2] = [1.0, 1e3];

impl PanelView for LandscapePanel {
    fn sanitize(&mut self, faults: &mut Faults) {
        // Without a Fresnel factor it means nothing.
        if let (true, Some(eta)) = (self.fresnel != Fresnel::None, &mut self.eta) {
            faults.number("eta", eta, ETAS);
        }
        faults.angle("limit", &mut self.limit, [0.0, FRAC_PI_2]);
        faults.inside("view", |faults| self.view.sanitize(faults));
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.65 * width + 4.0 * font
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let Some(FitOutput::Landscape { terrain, best }) = input.made else {
            return PanelDrawing::default();
        };
        let eta = match (self.fresnel, self.eta) {
            (Fresnel::None, _) => "no Fresnel".to_string(),
            (_, Some(eta)) => format!("η = {}", number(eta)),
            (_, None) => "η solved".to_string(),
        };
        let shown = LandscapeSpec {
            eta,
            view: self.view,
            path: self.path.clone(),
            here: self.here,
            best: *best,
        };
        let field = terrain.field();
        let heat = shown.heat_spec(input.name, terrain);
        PanelDrawing {
            table: table(terrain),
            axis: None,
            drawing: HeatMap::new(&heat, &field, input.size).drawing,
        }
    }
}

/// E in percent at the nodes of a landscape.
fn table(terrain: &Terrain) -> DataTable {
    let [x, y] = axes();
    let mut table = DataTable::new(&[x.key(), y.key(), "percent_e"]);
    let nodes = terrain
        .alpha
        .iter()
        .flat_map(|alpha| terrain.s.iter().map(move |s| (*s, *alpha)));
    for ((s, alpha), percent) in nodes.zip(&terrain.percent) {
        table
            .rows
            .push(vec![s.into(), alpha.into(), (*percent).into()]);
    }
    table
}
