//! The error map on paper.

use super::{ErrorSpec, Plane};
use crate::figure::faults::Faults;
use crate::figure::fit_output::FitOutput;
use crate::figure::heatmap::{HeatMap, HeatView};
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::scale::RadialScale;
use crate::figure::table::DataTable;
use crate::geom::degrees;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// An error map on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ErrorMapSpec {
    /// Axes of the map.
    pub plane: Plane,
    /// Law from shares to colours.
    pub scale: RadialScale,
    /// The part in sight.
    pub view: HeatView,
    /// Weight of the cells in E, by its key.
    pub weight: String,
    /// Grazing limit in radians.
    #[serde(with = "degrees")]
    pub limit: f64,
}

impl Default for ErrorMapSpec {
    fn default() -> Self {
        Self {
            plane: Plane::default(),
            scale: RadialScale::CubeRoot,
            view: HeatView::default(),
            weight: "cosine".into(),
            limit: FRAC_PI_2,
        }
    }
}

impl PanelView for ErrorMapSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.inside("view", |faults| self.view.sanitize(faults));
        faults.angle("limit", &mut self.limit, [0.0, FRAC_PI_2]);
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.65 * width + 4.0 * font
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let Some(FitOutput::ErrorMap {
            parts,
            columns,
            total,
            channels,
        }) = input.made
        else {
            return PanelDrawing::default();
        };
        let shown = ErrorSpec {
            plane: self.plane,
            scale: self.scale,
            view: self.view,
            total: *total,
            channels: *channels,
            spots: Vec::new(),
        };
        let field = shown.field(parts, *columns);
        let heat = shown.heat_spec(input.name, &field);
        let names = match self.plane {
            Plane::Directions => ["theta_i", "theta_o", "percent_of_e"],
            Plane::HalfDiff => ["theta_h", "theta_d", "percent_of_e"],
        };
        PanelDrawing {
            table: DataTable::of_cells(names, &field),
            axis: None,
            drawing: HeatMap::new(&heat, &field, input.size).drawing,
        }
    }
}
