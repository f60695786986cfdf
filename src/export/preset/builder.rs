//! The rows of a preset's page, from materials and options.

use super::{Preset, PresetMaterial, PresetModels, PresetOptions};
use crate::brdf::{Fresnel, ParamId};
use crate::export::spec::{SubjectSource, SubjectSpec};
use crate::figure::ViewSpec;
use crate::figure::lobes::{LobeScale, LobeSpec};
use crate::figure::page::{PanelSpec, RowSpec};
use crate::figure::ranking::{RankedFit, RankedMaterial, RankingSpec};
use crate::figure::scatter::{Quantity, ScatterSpec};
use crate::figure::shown::Shown;
use crate::figure::sphere_image::{SphereShow, SphereSpec};
use crate::figure::subject::{Look, model_line};

/// Most spheres in a row of the poster: more would be too small to tell apart.
const MOST_SPHERES: usize = 6;

/// A preset with what it is made for.
pub(super) struct Builder<'a> {
    pub materials: &'a [PresetMaterial],
    pub options: &'a PresetOptions,
    pub preset: &'a Preset,
}

impl Builder<'_> {
    /// Subjects: each material's data, then its models.
    pub fn subjects(&self) -> Vec<SubjectSpec> {
        let by_model = self.preset.tells_models_apart(self.options);
        let alone = self.materials.len() == 1;
        let mut subjects = Vec::new();
        if self.preset.shows_errors {
            return subjects;
        }
        for (index, material) in self.materials.iter().enumerate() {
            let Some(source) = &material.source else {
                continue;
            };
            // Where each panel has one material, all have the same colours and one legend.
            let series = if by_model { 0 } else { index };
            subjects.push(SubjectSpec {
                label: if by_model && !alone {
                    "measured".into()
                } else {
                    material.name.clone()
                },
                look: None,
                series,
                source: source.clone(),
            });
            for brdf in &material.models {
                let model = brdf.model.name;
                let (own, look) = model_line(brdf.model);
                let (series, look) = match (by_model, look, self.preset.models) {
                    (false, ..) => (series, Look::Model),
                    // With the data's colour gone, this look says whose residual is below slices. The poster has none.
                    (true, Look::Model, PresetModels::Several) => (own, Look::Dashed),
                    (true, ..) => (own, look),
                };
                subjects.push(SubjectSpec {
                    label: if self.preset.by_material {
                        material.name.clone()
                    } else if by_model || alone {
                        model.into()
                    } else {
                        format!("{}, {model}", material.name)
                    },
                    look: Some(look.into()),
                    series,
                    source: SubjectSource::Model(*brdf),
                });
            }
        }
        subjects
    }

    /// Position of a material's data among the subjects; its models follow.
    fn first(&self, material: usize) -> usize {
        let before = &self.materials[..material];
        before.iter().map(|m| 1 + m.models.len()).sum()
    }

    /// A panel per material, `columns` in a row.
    pub fn grid(
        &self,
        columns: usize,
        view: impl Fn(&Self, &PresetMaterial) -> ViewSpec,
    ) -> Vec<RowSpec> {
        let panels: Vec<PanelSpec> = self
            .materials
            .iter()
            .enumerate()
            .map(|(index, material)| PanelSpec {
                heading: (self.materials.len() > 1).then(|| material.name.clone()),
                subjects: (self.first(index)..=self.first(index) + material.models.len()).collect(),
                view: view(self, material),
            })
            .collect();
        let row = |panels: &[PanelSpec]| RowSpec {
            panels: panels.to_vec(),
            ..RowSpec::default()
        };
        panels.chunks(columns).map(row).collect()
    }

    pub fn lobes(&self) -> LobeSpec {
        LobeSpec {
            theta_i: self.options.theta_i.clone(),
            active: 0,
            scale: self.options.scale.map_or(LobeScale::Auto, LobeScale::from),
            ..LobeSpec::default()
        }
    }

    /// Rows of the poster: what was measured and the models beside each other on spheres, and below them over each other as
    /// lobes, a plot for each angle of incidence.
    pub fn poster(&self) -> Vec<RowSpec> {
        let mut rows = Vec::new();
        let spheres = 1 + self.preset.models(self.options).len();
        // Rows as even as can be, of spheres of one size.
        let columns = spheres.div_ceil(spheres.div_ceil(MOST_SPHERES));
        let wrapped = spheres > columns;
        let height_mm = wrapped.then(|| self.options.style.width_mm / (columns as f64 + 0.5));
        for (index, material) in self.materials.iter().enumerate() {
            let data = self.first(index);
            let sphere = |show, subject: usize, heading: &str| PanelSpec {
                heading: (index == 0 || wrapped).then(|| heading.to_string()),
                subjects: vec![subject],
                view: ViewSpec::Sphere(SphereSpec {
                    view: self.options.view.clone(),
                    show,
                    ..SphereSpec::default()
                }),
            };
            let lobes = |theta_i: &f64| PanelSpec {
                heading: (index == 0).then(|| {
                    let degrees = (10.0 * theta_i.to_degrees()).round() / 10.0;
                    format!("Light at {degrees}°")
                }),
                subjects: (data..=data + material.models.len()).collect(),
                view: ViewSpec::Lobes(LobeSpec {
                    theta_i: vec![*theta_i],
                    ..self.lobes()
                }),
            };
            let plots = self.options.theta_i.iter().map(lobes).collect();
            let mut spheres = vec![sphere(SphereShow::Measured, data, "Measured")];
            for (k, brdf) in material.models.iter().enumerate() {
                spheres.push(sphere(SphereShow::Model, data + 1 + k, brdf.model.name));
            }
            for (k, spheres) in spheres.chunks(columns).enumerate() {
                rows.push(RowSpec {
                    name: (k == 0).then(|| material.name.clone()),
                    height_mm,
                    panels: spheres.to_vec(),
                });
            }
            rows.push(RowSpec {
                panels: plots,
                ..RowSpec::default()
            });
        }
        rows
    }

    /// The angle of incidence of views that show one; `default` where none is chosen.
    pub fn middle_theta_i(&self, default: f64) -> f64 {
        let all = &self.options.theta_i;
        all.get(all.len() / 2).copied().unwrap_or(default)
    }

    /// A row per material, with a panel for each way to show data and model.
    pub fn compared<const N: usize>(
        &self,
        shown: [Shown; N],
        view: impl Fn(&Self, Shown) -> ViewSpec,
    ) -> Vec<RowSpec> {
        let row = |index: usize| {
            let data = self.first(index);
            let panel = |shown| PanelSpec {
                heading: None,
                subjects: vec![data, data + 1],
                view: view(self, shown),
            };
            RowSpec {
                panels: shown.map(panel).to_vec(),
                ..RowSpec::default()
            }
        };
        (0..self.materials.len()).map(row).collect()
    }

    pub fn ranking(&self) -> Vec<RowSpec> {
        let materials = self.materials.iter().map(|material| {
            let fits = material.models.iter().zip(&material.errors);
            RankedMaterial {
                name: material.name.clone(),
                fits: fits
                    .map(|(brdf, errors)| RankedFit::new(brdf, errors.total, errors.grazing))
                    .collect(),
            }
        });
        let spec = RankingSpec {
            sort: self.preset.models(self.options).first().copied(),
            fresnel: Some(self.options.fresnel),
            materials: materials.collect(),
            ..RankingSpec::default()
        };
        vec![RowSpec {
            panels: vec![PanelSpec {
                heading: None,
                subjects: Vec::new(),
                view: ViewSpec::Ranking(spec),
            }],
            ..RowSpec::default()
        }]
    }

    pub fn scatter(&self) -> Vec<RowSpec> {
        let model = self.preset.models(self.options).first().copied();
        let mut spec = ScatterSpec {
            model: model.unwrap_or(ScatterSpec::default().model),
            ..ScatterSpec::default()
        };
        // Without a Fresnel factor η says nothing.
        if self.options.fresnel == Fresnel::None
            && spec.quantities()[1] == Quantity::Param(ParamId::ETA)
        {
            spec.y = Some(Quantity::Param(ParamId::K_S));
        }
        let models = (0..self.materials.len()).map(|index| self.first(index) + 1);
        vec![RowSpec {
            panels: vec![PanelSpec {
                heading: None,
                subjects: models.collect(),
                view: ViewSpec::Scatter(spec),
            }],
            ..RowSpec::default()
        }]
    }
}
