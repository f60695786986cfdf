//! Figures by name: what a paper on reflection shows, from files alone.

mod builder;

use super::spec::{FigureSpec, SubjectSource};
use crate::brdf::{Brdf, Fresnel, Model, PHONG_FAMILY};
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
use crate::fit::Variant;
use crate::geom::sphere::SphereView;
use builder::Builder;

/// A figure by name.
#[derive(Debug)]
pub struct Preset {
    /// Name on the command line.
    pub key: &'static str,
    /// One sentence.
    pub help: &'static str,
    /// Whether it shows all three models instead of the chosen one.
    pub all_models: bool,
    /// Whether a model is named after its material.
    by_material: bool,
    /// Width of the page in millimetres.
    pub width_mm: f64,
    /// Group of panels that have the same axis.
    pub same_axes: SameAxes,
    rows: fn(&Builder) -> Vec<RowSpec>,
}

/// Presets in the order offered.
pub static PRESETS: [Preset; 11] = [
    Preset {
        key: "poster",
        help: "Each material measured and as all three models: spheres under a glancing and a grazing light, and below them the lobes at each angle of incidence over each other",
        all_models: true,
        by_material: false,
        width_mm: COLUMNS[1].1,
        // One angle's peak would make blobs of the others.
        same_axes: SameAxes::Panel,
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
        all_models: false,
        by_material: false,
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
        all_models: false,
        by_material: true,
        width_mm: COLUMNS[0].1,
        same_axes: SameAxes::Figure,
        rows: |b| b.scatter(),
    },
];

/// Options that a preset is built with.
#[derive(Clone, Debug)]
pub struct PresetOptions {
    /// The model of presets that show one.
    pub model: &'static Model,
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
    /// Source of the data.
    pub source: SubjectSource,
    /// Models over the data.
    pub models: Vec<Brdf>,
}

impl Preset {
    /// The preset of this name.
    pub fn by_key(key: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.key == key)
    }

    /// The models that each material needs, in this order.
    pub fn variants(&self, options: &PresetOptions) -> Vec<Variant> {
        let fresnel = options.fresnel;
        let of = |model: &'static Model| Variant { model, fresnel };
        match (self.all_models, self.key) {
            (true, _) => PHONG_FAMILY.iter().copied().map(of).collect(),
            (_, "landscape") => vec![of(crate::fit::landscape::model())],
            _ => vec![of(options.model)],
        }
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
