//! Figures by name: what a paper on reflection shows, from files alone.

mod builder;

use super::spec::{FigureSpec, SubjectSource};
use crate::brdf::{Brdf, COMBINED, Fresnel, Model, PHONG_FAMILY};
use crate::figure::ViewSpec;
use crate::figure::albedo::AlbedoSpec;
use crate::figure::disc::DiscSpec;
use crate::figure::error_map::ErrorMapSpec;
use crate::figure::image_slice::ImageSpec;
use crate::figure::landscape::LandscapePanel;
use crate::figure::lobe3d::Lobe3dSpec;
use crate::figure::page::{COLUMNS, PageSpec, RowSpec, SameAxes, Style};
use crate::figure::scale::RadialScale;
use crate::figure::shown::Shown;
use crate::figure::slices::{Residual, SliceSpec};
use crate::figure::sphere_image::{SphereShow, SphereSpec};
use crate::fit::{Errors, Variant};
use crate::geom::sphere::SphereView;
use builder::Builder;

/// A figure by name.
#[derive(Debug)]
pub struct Preset {
    /// Name on the command line.
    pub key: &'static str,
    /// One sentence.
    pub help: &'static str,
    /// Models that it can show.
    pub models: PresetModels,
    /// Whether a model is named after its material.
    by_material: bool,
    /// Whether it shows the errors of the models, and no data.
    pub shows_errors: bool,
    /// Width of the page in millimetres.
    pub width_mm: f64,
    /// Group of panels that have the same axis.
    pub same_axes: SameAxes,
    rows: fn(&Builder) -> Vec<RowSpec>,
}

/// Models that a preset can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PresetModels {
    /// One; the combined model where none is chosen.
    One,
    /// One or several over each other; the combined model where none is chosen.
    Several,
    /// As many as there are; the Phong family where none is chosen.
    Family,
    /// The combined model, whose parameters it shows.
    Combined,
}

/// Presets in the order offered.
pub static PRESETS: [Preset; 12] = [
    Preset {
        key: "poster",
        help: "Each material measured and as several models, the Phong family where none is chosen: spheres under a glancing and a grazing light, and below them the lobes at each angle of incidence over each other",
        models: PresetModels::Family,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[1].1,
        // One angle's peak would make blobs of the others.
        same_axes: SameAxes::Panel,
        rows: |b| b.poster(),
    },
    Preset {
        key: "sphere",
        help: "Each material on a sphere that is split between data and model",
        models: PresetModels::One,
        by_material: false,
        shows_errors: false,
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
        help: "Polar lobes in the plane of incidence, data and models",
        models: PresetModels::Several,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.grid(1, |b, _| ViewSpec::Lobes(b.lobes())),
    },
    Preset {
        key: "slices",
        help: "f_r over the view angle in the plane of incidence, with model / measured below",
        models: PresetModels::Several,
        by_material: false,
        shows_errors: false,
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
        models: PresetModels::One,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[1].1,
        same_axes: SameAxes::Row,
        rows: |b| {
            b.compared(
                [Shown::Measured, Shown::Model, Shown::Residual],
                |b, shown| {
                    ViewSpec::ImageSlice(ImageSpec {
                        shown,
                        scale: b.options.scale.unwrap_or(RadialScale::Log),
                        ..ImageSpec::default()
                    })
                },
            )
        },
    },
    Preset {
        key: "albedo",
        help: "Directional albedo over the angle of incidence, data and models",
        models: PresetModels::Several,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.grid(1, |_, _| ViewSpec::Albedo(AlbedoSpec::default())),
    },
    Preset {
        key: "lobe3d",
        help: "The lobe over all view directions, data as a solid and model as wire",
        models: PresetModels::One,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| {
            b.grid(1, |b, _| {
                ViewSpec::Lobe3d(Lobe3dSpec {
                    theta_i: b.middle_theta_i(Lobe3dSpec::default().theta_i),
                    scale: b.options.scale.unwrap_or(RadialScale::CubeRoot),
                    ..Lobe3dSpec::default()
                })
            })
        },
    },
    Preset {
        key: "disc",
        help: "f_r over all view directions under one light, seen from above: data, model, and model / measured",
        models: PresetModels::One,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[1].1,
        same_axes: SameAxes::Row,
        rows: |b| {
            b.compared([Shown::Measured, Shown::Model, Shown::Ratio], |b, shown| {
                ViewSpec::Disc(DiscSpec {
                    shown,
                    theta_i: b.middle_theta_i(DiscSpec::default().theta_i),
                    scale: b.options.scale.unwrap_or(RadialScale::Log),
                    ..DiscSpec::default()
                })
            })
        },
    },
    Preset {
        key: "error-map",
        help: "Where the error of the model comes from, over the angles of light and view",
        models: PresetModels::One,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.grid(1, |_, _| ViewSpec::ErrorMap(ErrorMapSpec::default())),
    },
    Preset {
        key: "landscape",
        help: "The best error of the combined model over s and α",
        models: PresetModels::Combined,
        by_material: false,
        shows_errors: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| {
            b.grid(1, |_, material| {
                let fit = material.models.first();
                ViewSpec::Landscape(LandscapePanel {
                    fresnel: fit.map_or(Fresnel::Exact, |fit| fit.fresnel),
                    eta: fit.map(|fit| fit.params.eta),
                    here: fit.map(crate::fit::landscape::place),
                    ..LandscapePanel::default()
                })
            })
        },
    },
    Preset {
        key: "scatter",
        help: "Materials by the parameters of a model; of the combined one by α and s: which are Phong-like, which Blinn-Phong-like",
        models: PresetModels::One,
        by_material: true,
        shows_errors: false,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.scatter(),
    },
    Preset {
        key: "ranking",
        help: "E of each model over the materials, the Phong family where none is chosen: in the order of the first model's E",
        models: PresetModels::Family,
        by_material: false,
        shows_errors: true,
        width_mm: COLUMNS[1].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.ranking(),
    },
];

/// Options that a preset is built with.
#[derive(Clone, Debug)]
pub struct PresetOptions {
    /// The models that are asked for; none where the preset is to choose.
    pub models: Vec<&'static Model>,
    /// The Fresnel factor of all models.
    pub fresnel: Fresnel,
    /// Angles of incidence in radians.
    pub theta_i: Vec<f64>,
    /// Law from values to lengths; the preset's own where it is `None`.
    pub scale: Option<RadialScale>,
    /// Lights and exposure of spheres.
    pub view: SphereView,
    /// Look on paper; its width is the preset's where `width_mm` is not given.
    pub style: Style,
}

/// A material with its models in the order of [`Preset::variants`].
#[derive(Clone, Debug)]
pub struct PresetMaterial {
    /// Display name.
    pub name: String,
    /// Source of the data; not needed where the preset shows errors.
    pub source: Option<SubjectSource>,
    /// Models over the data.
    pub models: Vec<Brdf>,
    /// E of the models, in their order, where the preset shows it.
    pub errors: Vec<Errors>,
}

impl Preset {
    /// The preset of this name.
    pub fn by_key(key: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.key == key)
    }

    /// The models that it shows.
    pub fn models(&self, options: &PresetOptions) -> Vec<&'static Model> {
        match (self.models, &options.models[..]) {
            (PresetModels::Combined, _) => vec![crate::fit::landscape::model()],
            (PresetModels::Family, []) => PHONG_FAMILY.to_vec(),
            (_, []) => vec![&COMBINED],
            (_, models) => models.to_vec(),
        }
    }

    /// Models that are asked for are shown.
    ///
    /// # Errors
    /// One sentence where they are more than it can show, or others.
    pub fn check(&self, options: &PresetOptions) -> Result<(), String> {
        let count = options.models.len();
        let key = self.key;
        match self.models {
            PresetModels::One if count > 1 => Err(format!(
                "--model names {count} models; the preset {key} shows one: name one of them"
            )),
            PresetModels::Combined if !options.models.iter().all(|m| *m == &COMBINED) => {
                Err(format!(
                    "the preset {key} shows the combined model only; expected --model {} or none",
                    COMBINED.key
                ))
            }
            _ => Ok(()),
        }
    }

    /// The models that each material needs, in this order.
    pub fn variants(&self, options: &PresetOptions) -> Vec<Variant> {
        let fresnel = options.fresnel;
        let models = self.models(options).into_iter();
        models.map(|model| Variant { model, fresnel }).collect()
    }

    /// Whether models, and not materials, have colours of their own.
    fn tells_models_apart(&self, options: &PresetOptions) -> bool {
        self.models == PresetModels::Family || self.models(options).len() > 1
    }

    /// The figure of some materials.
    pub fn figure(&self, materials: &[PresetMaterial], options: &PresetOptions) -> FigureSpec {
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
