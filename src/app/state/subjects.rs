//! Whom the plots show: the shown material, its model and its ticked fits, then the materials beside it.

use crate::app::state::fitting::kept::{KeptFit, variant_name};
use crate::app::state::material::{Material, Opened};
use crate::app::state::subject_key::{SubjectKey, What};
use crate::app::state::{Scene, State};
use crate::brdf::Fresnel;
use crate::figure::palette::companion;
use crate::figure::subject::{Look, Source, Subject};
use crate::fit::Variant;

/// The subjects of all plots.
#[derive(Clone, Debug, Default)]
pub struct Subjects {
    /// The shown material first.
    pub list: Vec<Subject>,
    /// Keys of the subjects, in the same order.
    pub keys: Vec<SubjectKey>,
}

impl Subjects {
    /// The subjects in this state.
    pub fn of(state: &State) -> Self {
        let mut subjects = Self::default();
        let Some((material, opened)) = state.current() else {
            return subjects;
        };
        let scene = &state.scene;
        subjects.add_material(scene, material, opened, scene.selected, true);
        for (index, opened) in scene.opened.iter().enumerate() {
            let material = state.materials.get(&opened.id);
            if let Some(material) = material.filter(|_| opened.beside && index != scene.selected) {
                subjects.add_material(scene, material, opened, index, false);
            }
        }
        subjects
    }

    /// Measurement and model; of the shown material the ticked fits too.
    fn add_material(
        &mut self,
        scene: &Scene,
        material: &Material,
        opened: &Opened,
        series: usize,
        shown: bool,
    ) {
        let model = opened.brdf.model.name;
        let model = if shown {
            model.to_string()
        } else {
            format!("{}, {model}", material.name)
        };
        let mut add = |what, label, look, series, source| {
            let key = SubjectKey {
                material: opened.id,
                what,
            };
            self.keys.push(key);
            self.list.push(Subject {
                label,
                look,
                series,
                hidden: scene.hidden.contains(&key),
                source,
            });
        };
        if material.table.valid_count() > 0 {
            let source = Source::Measured(material.table.clone(), scene.lookup);
            let name = material.name.clone();
            add(What::Measured, name, Look::Measured, series, source);
        }
        let source = Source::Model(opened.brdf);
        add(What::Model, model, Look::Model, series, source);
        if !shown {
            return;
        }
        // A colour per model, dots without and dashes with Fresnel.
        let mut ticked: Vec<&KeptFit> = material.fits.iter().filter(|fit| fit.overlaid).collect();
        ticked.sort_by_key(|fit| (fit.variant().model.index(), fit.variant().fresnel.index()));
        for fit in ticked {
            let variant = fit.variant();
            let (look, series) = look_beside(variant, series);
            let source = Source::Model(fit.outcome.brdf);
            let name = variant_name(variant);
            add(What::Fit(variant), name, look, series, source);
        }
    }
}

/// Line and colour of a variant beside the model of series `series`.
pub fn look_beside(variant: Variant, series: usize) -> (Look, usize) {
    let long = variant.fresnel != Fresnel::None;
    (
        Look::Beside { long },
        companion(series, variant.model.index()),
    )
}

/// A click on a name in a legend: shows or hides it, or leaves it alone; alone already, shows all again.
pub(crate) fn toggle(scene: &mut Scene, all: &[SubjectKey], key: SubjectKey, solo: bool) {
    if solo {
        let others: Vec<SubjectKey> = all.iter().copied().filter(|other| *other != key).collect();
        scene.hidden = if scene.hidden == others {
            Vec::new()
        } else {
            others
        };
    } else if scene.hidden.contains(&key) {
        scene.hidden.retain(|other| *other != key);
    } else {
        scene.hidden.push(key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::material::MaterialId;

    #[test]
    fn a_name_toggles_and_goes_alone() {
        let key = |what| SubjectKey {
            material: MaterialId(1),
            what,
        };
        let all = [key(What::Measured), key(What::Model)];
        let mut scene = Scene::default();
        toggle(&mut scene, &all, all[1], false);
        assert_eq!(scene.hidden, [all[1]]);
        toggle(&mut scene, &all, all[1], false);
        assert_eq!(scene.hidden, []);
        toggle(&mut scene, &all, all[1], true);
        assert_eq!(scene.hidden, [all[0]]);
        toggle(&mut scene, &all, all[1], true);
        assert_eq!(scene.hidden, []);
    }
}
