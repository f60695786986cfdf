//! What the window shows as a figure: the same views of the same subjects.

use crate::app::state::State;
use crate::app::state::material::{Material, Opened, Origin};
use crate::app::state::subject_key::What;
use crate::app::state::subjects::Subjects;
use crate::app::state::views::ViewId;
use crate::app::views::albedo::settings::AlbedoSettings;
use crate::app::views::error_map::settings::ErrorMapSettings;
use crate::app::views::image::settings::ImageSettings;
use crate::app::views::landscape::settings::LandscapeSettings;
use crate::app::views::landscape::work::{path, place};
use crate::app::views::lobe3d::settings::Lobe3dSettings;
use crate::app::views::lobes::settings::{LobeSettings, drawable};
use crate::app::views::scatter::combined_fits;
use crate::app::views::slices::settings::{SliceSettings, through};
use crate::app::views::sphere::settings::{Show, SphereSettings};
use crate::brdf::Fresnel;
use crate::export::{FigureSpec, SubjectLook, SubjectSource, SubjectSpec};
use crate::figure::ViewSpec;
use crate::figure::error_map::ErrorMapSpec;
use crate::figure::landscape::LandscapePanel;
use crate::figure::lobe3d::Lobe3dSpec;
use crate::figure::page::{PageSpec, PanelSpec, RowSpec, Style};
use crate::figure::palette::Role;
use crate::figure::scatter::ScatterSpec;
use crate::figure::sphere_image::{SphereShow, SphereSpec};
use crate::figure::subject::{Look, Source};
use crate::measured::{SAMPLES, Table};
use std::sync::Arc;

/// A figure with the data that it is drawn from.
#[derive(Clone, Debug)]
pub struct Drawable {
    /// The figure.
    pub spec: FigureSpec,
    /// The data of its measured subjects.
    pub tables: Vec<(SubjectSource, Arc<Table>)>,
}

impl PartialEq for Drawable {
    /// The spec names its data.
    fn eq(&self, other: &Self) -> bool {
        self.spec == other.spec
    }
}

/// The figure of some tiles, `columns` beside each other; `None` where nothing can be drawn.
pub fn figure_of(
    state: &State,
    panes: &[ViewId],
    columns: usize,
    style: &Style,
) -> Option<Drawable> {
    let mut maker = Maker::new(state)?;
    let panels: Vec<PanelSpec> = panes
        .iter()
        .filter(|pane| state.can_draw(**pane))
        .flat_map(|pane| maker.panels(*pane))
        .collect();
    if panels.is_empty() {
        return None;
    }
    let row = |panels: &[PanelSpec]| RowSpec {
        panels: panels.to_vec(),
        ..RowSpec::default()
    };
    let page = PageSpec {
        rows: panels.chunks(columns.max(1)).map(row).collect(),
        style: style.clone(),
    };
    Some(Drawable {
        // As it is read back from its file, so that the file draws the same.
        spec: FigureSpec::new(maker.subjects, page).settled(),
        tables: maker.tables,
    })
}

struct Maker<'a> {
    state: &'a State,
    opened: Opened,
    subjects: Vec<SubjectSpec>,
    tables: Vec<(SubjectSource, Arc<Table>)>,
    /// Positions of the subjects of all plots.
    plotted: Vec<usize>,
    /// Positions of the data of the shown material and of the model over it.
    shown: Vec<usize>,
}

impl<'a> Maker<'a> {
    fn new(state: &'a State) -> Option<Self> {
        let (shown, opened) = state.current()?;
        let mut maker = Self {
            state,
            opened: *opened,
            subjects: Vec::new(),
            tables: Vec::new(),
            plotted: Vec::new(),
            shown: Vec::new(),
        };
        let all = Subjects::of(state);
        for (subject, key) in all.list.iter().zip(&all.keys) {
            let Some(material) = state.materials.get(&key.material) else {
                continue;
            };
            let at = maker.subjects.len();
            let source = match &subject.source {
                Source::Measured(table, _) => {
                    let Some(source) = source_of(state, material) else {
                        continue;
                    };
                    maker.tables.push((source.clone(), Arc::clone(table)));
                    source
                }
                Source::Model(brdf) => SubjectSource::Model(*brdf),
                Source::Function(_) => continue,
            };
            maker.subjects.push(SubjectSpec {
                label: subject.label.clone(),
                look: Some(subject.look.into()),
                series: subject.series,
                source,
            });
            if !subject.hidden {
                maker.plotted.push(at);
            }
            let own = key.material == opened.id && !matches!(key.what, What::Fit(_));
            if own && std::ptr::eq(material, shown) {
                maker.shown.push(at);
            }
        }
        Some(maker)
    }

    fn panels(&mut self, pane: ViewId) -> Vec<PanelSpec> {
        let scene = &self.state.scene;
        let shown = self.shown.clone();
        let of = |view: ViewSpec, subjects: &[usize]| PanelSpec {
            heading: None,
            subjects: subjects.to_vec(),
            view,
        };
        match pane {
            ViewId::Sphere => {
                let settings = scene.views.get::<SphereSettings>();
                let sphere = |show| {
                    let spec = SphereSpec {
                        view: settings.view.clone(),
                        show,
                        split: settings.split,
                        sight: settings.sight,
                    };
                    of(ViewSpec::Sphere(spec), &shown)
                };
                let shows = match settings.show {
                    Show::Measured => vec![SphereShow::Measured],
                    Show::Model => vec![SphereShow::Model],
                    Show::Split => vec![SphereShow::Split],
                    Show::SideBySide => vec![SphereShow::Measured, SphereShow::Model],
                    Show::Error(error) => vec![SphereShow::Split, SphereShow::Error(error)],
                };
                shows.into_iter().map(sphere).collect()
            }
            ViewId::Lobes => {
                let spec = drawable(scene.views.get(), None);
                vec![of(ViewSpec::Lobes(spec), &self.plotted)]
            }
            ViewId::Slices => {
                let view = scene.views.get::<SliceSettings>();
                let probe = self.state.probe().filter(|_| view.follow);
                let spec = probe.map_or_else(|| view.spec.clone(), |p| through(&view.spec, p));
                vec![of(ViewSpec::Slices(spec), &self.plotted)]
            }
            ViewId::Albedo => {
                let spec = scene.views.get::<AlbedoSettings>().spec.clone();
                vec![of(ViewSpec::Albedo(spec), &self.plotted)]
            }
            ViewId::Lobe3d => {
                let view = scene.views.get::<Lobe3dSettings>();
                let spec = Lobe3dSpec {
                    theta_i: self.state.probe().map_or(view.theta_i, |p| p.theta_i()),
                    ..*view
                };
                vec![of(ViewSpec::Lobe3d(spec), &self.plotted)]
            }
            ViewId::Image => {
                let spec = scene.views.get::<ImageSettings>().clone();
                vec![of(ViewSpec::ImageSlice(spec), &shown)]
            }
            ViewId::ErrorMap => {
                let (view, settings) = (
                    scene.views.get::<ErrorMapSettings>(),
                    &self.state.fit.settings,
                );
                let spec = ErrorMapSpec {
                    plane: view.plane,
                    scale: view.scale,
                    view: view.view,
                    weight: settings.weight.key().into(),
                    limit: settings.limit,
                };
                vec![of(ViewSpec::ErrorMap(spec), &shown)]
            }
            ViewId::Landscape => vec![of(ViewSpec::Landscape(self.landscape()), &shown)],
            ViewId::Scatter => vec![of(ViewSpec::Scatter(ScatterSpec::default()), &self.dots())],
            ViewId::Fits => Vec::new(),
        }
    }

    fn landscape(&self) -> LandscapePanel {
        let (brdf, settings) = (self.opened.brdf, &self.state.fit.settings);
        let view = self.state.scene.views.get::<LandscapeSettings>();
        let solved = view.solve_eta && brdf.fresnel != Fresnel::None;
        LandscapePanel {
            fresnel: brdf.fresnel.key().into(),
            eta: (!solved).then_some(brdf.params.eta),
            weight: settings.weight.key().into(),
            limit: settings.limit,
            path: path(self.state),
            here: Some(place(&brdf)),
            view: view.view,
        }
    }

    /// Every material with a combined fit, in the colours of the tile as far as paper has them.
    fn dots(&mut self) -> Vec<usize> {
        let fits = combined_fits(self.state);
        let first = self.subjects.len();
        let specs = fits.into_iter().map(|(name, brdf, role)| SubjectSpec {
            label: name,
            look: Some(SubjectLook::from(Look::Model)),
            series: match role {
                Role::Series(series) => series,
                _ => 0,
            },
            source: SubjectSource::Model(brdf),
        });
        self.subjects.extend(specs);
        (first..self.subjects.len()).collect()
    }
}

/// Where the data of a material come from.
fn source_of(state: &State, material: &Material) -> Option<SubjectSource> {
    let lookup = state.scene.lookup;
    match (&material.origin, &material.source) {
        (Origin::Sample(index), _) => Some(SubjectSource::Sample {
            key: SAMPLES.get(*index)?.key.into(),
            lookup,
        }),
        (Origin::File(_), Some(file)) => Some(SubjectSource::Measured {
            file: file.clone(),
            lookup,
        }),
        (Origin::File(_), None) => None,
    }
}

/// Default name of a figure of some tiles: material, plot, angles, model, scale.
pub fn default_name(state: &State, panes: &[ViewId]) -> String {
    let Some((material, opened)) = state.current() else {
        return "figure".into();
    };
    let scene = &state.scene;
    let mut words = vec![material.name.clone()];
    let angles = |theta_i: &[f64]| {
        let degrees = theta_i.iter().map(|t| format!("{:.0}", t.to_degrees()));
        format!("thi{}", degrees.collect::<Vec<_>>().join("-"))
    };
    let model = opened.brdf.model.key.to_string();
    match panes {
        [pane] => {
            words.push(pane.about().key.into());
            match pane {
                ViewId::Lobes => {
                    words.push(angles(&scene.views.get::<LobeSettings>().theta_i));
                    words.extend([model, scene.views.get::<LobeSettings>().scale.key().into()]);
                }
                ViewId::Slices => {
                    let spec = &scene.views.get::<SliceSettings>().spec;
                    words.push(match spec.over {
                        crate::figure::slices::Over::ThetaO => angles(&spec.theta_i),
                        over => over.key().into(),
                    });
                    words.extend([model, spec.scale.key().into()]);
                }
                ViewId::Lobe3d => {
                    words.push(angles(&[scene.views.get::<Lobe3dSettings>().theta_i]));
                    words.extend([
                        model,
                        scene.views.get::<Lobe3dSettings>().scale.key().into(),
                    ]);
                }
                ViewId::Image => {
                    let view = scene.views.get::<ImageSettings>();
                    words.push(format!("phd{:.0}", view.phi_d.to_degrees()));
                    words.push(view.shown.key().into());
                    words.extend([model, view.scale.key().into()]);
                }
                ViewId::Scatter => words = vec!["materials_scatter".into()],
                _ => words.push(model),
            }
        }
        _ => words.extend(["figure".into(), model]),
    }
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '-'
        }
    };
    words.join("_").chars().map(plain).collect()
}
