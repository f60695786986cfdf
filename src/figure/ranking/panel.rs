//! The ranking on paper.

use super::order::Ranking;
use super::plot::RankingPlot;
use super::spec::RankingSpec;
use crate::figure::faults::Faults;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::table::{DataTable, TableField};

/// Errors of fits, and of models that are far off.
const ERRORS: [f64; 2] = [0.0, 1e12];
/// Most materials that are read, and most fits of one: every model with every Fresnel factor, and room for more models.
const MOST_MATERIALS: usize = 10_000;
const MOST_FITS: usize = 1_000;

impl PanelView for RankingSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        shorten("materials", &mut self.materials, MOST_MATERIALS, faults);
        faults.inside("materials", |faults| {
            for (position, material) in self.materials.iter_mut().enumerate() {
                faults.inside(position.to_string(), |faults| {
                    shorten("fits", &mut material.fits, MOST_FITS, faults);
                    faults.inside("fits", |faults| {
                        for (position, fit) in material.fits.iter_mut().enumerate() {
                            faults.inside(position.to_string(), |faults| {
                                faults.number("error", &mut fit.error, ERRORS);
                                if let Some(grazing) = &mut fit.grazing {
                                    faults.number("grazing", grazing, ERRORS);
                                }
                            });
                        }
                    });
                });
            }
        });
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.4 * width + 8.0 * font
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let plot = RankingPlot::new(self, input.size);
        PanelDrawing {
            table: table(self, &plot.ranking),
            axis: None,
            drawing: plot.drawing,
        }
    }
}

/// Cuts a list to the most that is read.
fn shorten<T>(key: &str, list: &mut Vec<T>, most: usize, faults: &mut Faults) {
    if list.len() > most {
        faults.inside(key, |faults| {
            faults.add("length", list.len(), format!("at most {most}"));
        });
        list.truncate(most);
    }
}

/// A row per material and model, in the order of the plot; `best` is 1 where the model wins the material.
fn table(spec: &RankingSpec, ranking: &Ranking) -> DataTable {
    let mut table = DataTable::new(&[
        "rank",
        "material",
        "model",
        "fresnel",
        "percent_e",
        "percent_e_grazing",
        "best",
    ]);
    for (rank, row) in ranking.rows.iter().enumerate() {
        let name: TableField = spec.materials[row.material].name.as_str().into();
        for (k, model) in ranking.models.iter().enumerate() {
            let Some((fit, _)) = &row.fits[k] else {
                continue;
            };
            let best = row.winner.map(|winner| f64::from(u8::from(winner == k)));
            table.rows.push(vec![
                ((rank + 1) as f64).into(),
                name.clone(),
                model.key.into(),
                fit.fresnel.key().into(),
                (100.0 * fit.error).into(),
                fit.grazing.map(|grazing| 100.0 * grazing).into(),
                best.into(),
            ]);
        }
    }
    table
}
