//! Views in a figure: their panels, the subjects that they draw, and the names of their files.

use crate::app::state::State;
use crate::app::state::material::{Material, Opened, Origin};
use crate::app::state::subject_key::What;
use crate::app::state::subjects::Subjects;
use crate::brdf::Brdf;
use crate::export::{SubjectLook, SubjectSource, SubjectSpec};
use crate::figure::ViewSpec;
use crate::figure::page::PanelSpec;
use crate::figure::subject::{Look, Source};
use crate::measured::{SAMPLES, Table};
use std::sync::Arc;

/// A view in a figure.
pub struct PaperView {
    /// Panels that show what the tile shows.
    pub panels: fn(&mut FigureSubjects) -> Vec<PanelSpec>,
    /// Words of the default name of its file, without the extension.
    pub name: fn(&Naming) -> Vec<String>,
}

/// Parts of the names of files.
pub struct Naming<'a> {
    /// Views are set as here.
    pub state: &'a State,
    /// Name of the shown material.
    pub material: &'a str,
    /// Key of the view.
    pub view: &'a str,
    /// Key of the shown model.
    pub model: &'a str,
}

impl Naming<'_> {
    /// Material, view, `set` and then model.
    pub fn words(&self, set: &[String]) -> Vec<String> {
        let mut words = vec![self.material.to_string(), self.view.to_string()];
        words.extend_from_slice(set);
        words.push(self.model.to_string());
        words
    }
}

/// Angles of incidence in a name, such as `thi30-60`; from radians.
pub fn theta_i_word(theta_i: &[f64]) -> String {
    let degrees = theta_i.iter().map(|t| format!("{:.0}", t.to_degrees()));
    format!("thi{}", degrees.collect::<Vec<_>>().join("-"))
}

/// The subjects of a figure: those of all plots, and what single views add.
pub struct FigureSubjects<'a> {
    /// State of the window.
    pub state: &'a State,
    /// The shown material with its model.
    pub opened: Opened,
    /// All subjects so far.
    pub list: Vec<SubjectSpec>,
    /// Data of the measured subjects.
    pub tables: Vec<(SubjectSource, Arc<Table>)>,
    /// Positions of the subjects that plots draw.
    pub plotted: Vec<usize>,
    /// Positions of the data of the shown material and of the model over it.
    pub shown: Vec<usize>,
}

impl<'a> FigureSubjects<'a> {
    /// The subjects of all plots; `None` where no material is open.
    pub fn new(state: &'a State) -> Option<Self> {
        let (shown, opened) = state.current()?;
        let mut subjects = Self {
            state,
            opened: *opened,
            list: Vec::new(),
            tables: Vec::new(),
            plotted: Vec::new(),
            shown: Vec::new(),
        };
        let all = Subjects::of(state);
        for (subject, key) in all.list.iter().zip(&all.keys) {
            let Some(material) = state.materials.get(&key.material) else {
                continue;
            };
            let at = subjects.list.len();
            let source = match &subject.source {
                Source::Measured(table, _) => {
                    let Some(source) = source_of(state, material) else {
                        continue;
                    };
                    subjects.tables.push((source.clone(), Arc::clone(table)));
                    source
                }
                Source::Model(brdf) => SubjectSource::Model(*brdf),
                Source::Function(_) => continue,
            };
            subjects.list.push(SubjectSpec {
                label: subject.label.clone(),
                look: Some(subject.look.into()),
                series: subject.series,
                source,
            });
            if !subject.hidden {
                subjects.plotted.push(at);
            }
            let own = key.material == opened.id && !matches!(key.what, What::Fit(_));
            if own && std::ptr::eq(material, shown) {
                subjects.shown.push(at);
            }
        }
        Some(subjects)
    }

    /// Adds a model. Gives back its position.
    pub fn add_model(&mut self, label: String, series: usize, brdf: Brdf) -> usize {
        self.list.push(SubjectSpec {
            label,
            look: Some(SubjectLook::from(Look::Model)),
            series,
            source: SubjectSource::Model(brdf),
        });
        self.list.len() - 1
    }

    /// A panel of what plots draw.
    pub fn plot(&self, view: ViewSpec) -> PanelSpec {
        panel(view, self.plotted.clone())
    }

    /// A panel of the shown material and its model.
    pub fn picture(&self, view: ViewSpec) -> PanelSpec {
        panel(view, self.shown.clone())
    }
}

/// A panel without a heading; `subjects` by their positions.
pub fn panel(view: ViewSpec, subjects: Vec<usize>) -> PanelSpec {
    PanelSpec {
        heading: None,
        subjects,
        view,
    }
}

/// Source of the data of a material; `None` for a model without data.
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
