//! Figures by name: what a paper on reflection shows, from files alone.

use super::spec::{FigureSpec, SubjectLook, SubjectSource, SubjectSpec};
use crate::brdf::{Brdf, Fresnel, MODELS, Model};
use crate::figure::ViewSpec;
use crate::figure::albedo::AlbedoSpec;
use crate::figure::error_map::ErrorMapSpec;
use crate::figure::image_slice::ImageSpec;
use crate::figure::landscape::LandscapePanel;
use crate::figure::lobe3d::Lobe3dSpec;
use crate::figure::lobes::LobeSpec;
use crate::figure::page::{COLUMNS, PageSpec, PanelSpec, RowSpec, SameAxes, Style};
use crate::figure::scale::RadialScale;
use crate::figure::scatter::ScatterSpec;
use crate::figure::shown::Shown;
use crate::figure::slices::{Residual, SliceSpec};
use crate::figure::sphere_image::{SphereShow, SphereSpec};
use crate::fit::Variant;
use crate::geom::sphere::SphereView;

/// A figure by name.
#[derive(Debug)]
pub struct Preset {
    /// Its name on the command line.
    pub key: &'static str,
    /// One sentence.
    pub help: &'static str,
    /// Whether it shows all three models instead of the chosen one.
    pub all_models: bool,
    /// Whether a model is named after its material.
    by_material: bool,
    /// Width of the page in millimetres.
    pub width_mm: f64,
    /// Which panels have the same axis.
    pub same_axes: SameAxes,
    rows: fn(&Builder) -> Vec<RowSpec>,
}

/// All of them in the order offered.
pub static PRESETS: [Preset; 10] = [
    Preset {
        key: "poster",
        help: "Each material measured and as all three models: spheres under a glancing and a grazing light, with polar lobes below",
        all_models: true,
        by_material: false,
        width_mm: COLUMNS[1].1,
        same_axes: SameAxes::Row,
        rows: |b| b.poster(),
    },
    Preset {
        key: "sphere",
        help: "Each material on a sphere that is split between data and model",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| {
            b.grid(2, |b, _| {
                ViewSpec::Sphere(SphereSpec {
                    view: b.options.view.clone(),
                    show: SphereShow::Split,
                    ..SphereSpec::default()
                })
            })
        },
    },
    Preset {
        key: "lobes",
        help: "Polar lobes in the plane of incidence, data and model",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.grid(1, |b, _| ViewSpec::Lobes(b.lobes())),
    },
    Preset {
        key: "slices",
        help: "f_r over the view angle in the plane of incidence, with model / measured below",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| {
            b.grid(1, |b, _| {
                ViewSpec::Slices(SliceSpec {
                    theta_i: b.options.theta_i.clone(),
                    active: b.options.theta_i.len() / 2,
                    scale: b.options.scale.unwrap_or(RadialScale::Log),
                    residual: Residual::Ratio,
                    ..SliceSpec::default()
                })
            })
        },
    },
    Preset {
        key: "image-slice",
        help: "f_r over half and difference angle: data, model, and model − measured",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[1].1,
        same_axes: SameAxes::Row,
        rows: |b| b.image_slices(),
    },
    Preset {
        key: "albedo",
        help: "Directional albedo over the angle of incidence, data and model",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.grid(1, |_, _| ViewSpec::Albedo(AlbedoSpec::default())),
    },
    Preset {
        key: "lobe3d",
        help: "The lobe over all view directions, data as a solid and model as wire",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| {
            b.grid(1, |b, _| {
                let theta_i = b.options.theta_i.get(b.options.theta_i.len() / 2);
                ViewSpec::Lobe3d(Lobe3dSpec {
                    theta_i: theta_i.copied().unwrap_or(Lobe3dSpec::default().theta_i),
                    scale: b.options.scale.unwrap_or(RadialScale::CubeRoot),
                    ..Lobe3dSpec::default()
                })
            })
        },
    },
    Preset {
        key: "error-map",
        help: "Where the error of the model comes from, over the angles of light and view",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.grid(1, |_, _| ViewSpec::ErrorMap(ErrorMapSpec::default())),
    },
    Preset {
        key: "landscape",
        help: "The best error of the combined model over s and α",
        all_models: false,
        by_material: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| {
            b.grid(1, |_, material| {
                let fit = material.models.first();
                ViewSpec::Landscape(LandscapePanel {
                    fresnel: fit.map_or("exact", |fit| fit.fresnel.key()).into(),
                    eta: fit.map(|fit| fit.params.eta),
                    here: fit.map(|fit| {
                        let params = fit.with_model(crate::fit::landscape::model()).params;
                        [params.s, params.alpha]
                    }),
                    ..LandscapePanel::default()
                })
            })
        },
    },
    Preset {
        key: "scatter",
        help: "Materials by α and s of the combined model: which are Phong-like, which Blinn-Phong-like",
        all_models: false,
        by_material: true,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.scatter(),
    },
];

/// What a preset is made for.
#[derive(Clone, Debug)]
pub struct Options {
    /// The model of presets that show one.
    pub model: &'static Model,
    /// The Fresnel factor of all models.
    pub fresnel: Fresnel,
    /// Angles of incidence in radians.
    pub theta_i: Vec<f64>,
    /// How values become lengths; as the preset likes it without.
    pub scale: Option<RadialScale>,
    /// Lights and exposure of spheres.
    pub view: SphereView,
    /// How it looks; its width is the preset's where `width_mm` is not given.
    pub style: Style,
}

/// A material with its models in the order of [`Preset::variants`].
#[derive(Clone, Debug)]
pub struct PresetMaterial {
    /// Its name.
    pub name: String,
    /// Its data.
    pub source: SubjectSource,
    /// Its models.
    pub models: Vec<Brdf>,
}

impl Preset {
    /// The preset of this name.
    pub fn by_key(key: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.key == key)
    }

    /// The models that each material needs, in this order.
    pub fn variants(&self, options: &Options) -> Vec<Variant> {
        let fresnel = options.fresnel;
        let of = |model: &'static Model| Variant { model, fresnel };
        match (self.all_models, self.key) {
            (true, _) => MODELS.map(of).to_vec(),
            (_, "scatter" | "landscape") => vec![of(crate::fit::landscape::model())],
            _ => vec![of(options.model)],
        }
    }

    /// The figure of some materials.
    pub fn figure(&self, materials: &[PresetMaterial], options: &Options) -> FigureSpec {
        let builder = Builder {
            materials,
            options,
            preset: self,
        };
        let page = PageSpec {
            rows: (self.rows)(&builder),
            style: options.style.clone(),
        };
        FigureSpec::new(builder.subjects(), page)
    }
}

struct Builder<'a> {
    materials: &'a [PresetMaterial],
    options: &'a Options,
    preset: &'a Preset,
}

impl Builder<'_> {
    /// Each material's data, then its models.
    fn subjects(&self) -> Vec<SubjectSpec> {
        let (all_models, alone) = (self.preset.all_models, self.materials.len() == 1);
        let mut subjects = Vec::new();
        for (index, material) in self.materials.iter().enumerate() {
            // Where each panel has one material, all have the same colours and one legend.
            let series = if all_models { 0 } else { index };
            subjects.push(SubjectSpec {
                label: if all_models && !alone {
                    "measured".into()
                } else {
                    material.name.clone()
                },
                look: None,
                series,
                source: material.source.clone(),
            });
            for brdf in &material.models {
                let model = brdf.model.name;
                subjects.push(SubjectSpec {
                    label: if self.preset.by_material {
                        material.name.clone()
                    } else if all_models || alone {
                        model.into()
                    } else {
                        format!("{}, {model}", material.name)
                    },
                    look: Some(SubjectLook::Model),
                    series: if all_models {
                        1 + brdf.model.index()
                    } else {
                        series
                    },
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
    fn grid(
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

    fn lobes(&self) -> LobeSpec {
        LobeSpec {
            theta_i: self.options.theta_i.clone(),
            active: 0,
            scale: self.options.scale.unwrap_or(RadialScale::CubeRoot),
            ..LobeSpec::default()
        }
    }

    /// As in the poster: what was measured and the models beside each other, spheres over lobes.
    fn poster(&self) -> Vec<RowSpec> {
        let mut rows = Vec::new();
        for (index, material) in self.materials.iter().enumerate() {
            let data = self.first(index);
            let sphere = |show, subject: usize, heading: &str| PanelSpec {
                heading: (index == 0).then(|| heading.to_string()),
                subjects: vec![subject],
                view: ViewSpec::Sphere(SphereSpec {
                    view: self.options.view.clone(),
                    show,
                    ..SphereSpec::default()
                }),
            };
            let lobes = |subjects: Vec<usize>| PanelSpec {
                heading: None,
                subjects,
                view: ViewSpec::Lobes(self.lobes()),
            };
            let models = material.models.iter().enumerate();
            let models: Vec<(usize, &Brdf)> =
                models.map(|(k, brdf)| (data + 1 + k, brdf)).collect();
            let mut spheres = vec![sphere(SphereShow::Measured, data, "Measured")];
            let mut plots = vec![lobes(vec![data])];
            for (at, brdf) in models {
                spheres.push(sphere(SphereShow::Model, at, brdf.model.name));
                plots.push(lobes(vec![data, at]));
            }
            rows.push(RowSpec {
                name: Some(material.name.clone()),
                panels: spheres,
                ..RowSpec::default()
            });
            rows.push(RowSpec {
                panels: plots,
                ..RowSpec::default()
            });
        }
        rows
    }

    fn image_slices(&self) -> Vec<RowSpec> {
        let shown = [Shown::Measured, Shown::Model, Shown::Residual];
        let of = |index: usize| {
            let data = self.first(index);
            RowSpec {
                panels: shown
                    .map(|shown| PanelSpec {
                        heading: None,
                        subjects: vec![data, data + 1],
                        view: ViewSpec::ImageSlice(ImageSpec {
                            shown,
                            scale: self.options.scale.unwrap_or(RadialScale::Log),
                            ..ImageSpec::default()
                        }),
                    })
                    .to_vec(),
                ..RowSpec::default()
            }
        };
        (0..self.materials.len()).map(of).collect()
    }

    fn scatter(&self) -> Vec<RowSpec> {
        let models = (0..self.materials.len()).map(|index| self.first(index) + 1);
        vec![RowSpec {
            panels: vec![PanelSpec {
                heading: None,
                subjects: models.collect(),
                view: ViewSpec::Scatter(ScatterSpec::default()),
            }],
            ..RowSpec::default()
        }]
    }
}
