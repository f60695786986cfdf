//! Marks of a session: a person's work as it was when it was saved.

use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::material::{Material, MaterialId, Opened, Origin, Presence};
use crate::app::state::{Scene, State};

/// The scene and the fits as they were.
#[derive(Clone, Debug)]
pub struct SessionMark {
    scene: Scene,
    materials: Vec<MaterialMark>,
}

/// A material as far as it changes beside the scene: where it is, its fits by their E and tick.
type MaterialMark = (MaterialId, Origin, Presence, Vec<(u64, bool)>);

fn marks(state: &State) -> impl Iterator<Item = MaterialMark> {
    state.scene.opened.iter().filter_map(|opened| {
        let material = state.materials.get(&opened.id)?;
        // A table that comes or goes is no change.
        let lost = match material.presence {
            Presence::Missing => Presence::Missing,
            _ => Presence::Loaded,
        };
        let fits = material.fits.iter();
        let fits = fits.map(|fit| (fit.outcome.errors.total.to_bits(), fit.overlaid));
        Some((opened.id, material.origin.clone(), lost, fits.collect()))
    })
}

impl SessionMark {
    /// Mark of the present state.
    pub fn of(state: &State) -> Self {
        Self {
            scene: state.scene.clone(),
            materials: marks(state).collect(),
        }
    }

    /// Whether nothing has changed. Asked at each frame.
    pub fn is(&self, state: &State) -> bool {
        self.scene == state.scene && self.has_materials(state)
    }

    /// Whether nothing has changed but which material is shown.
    fn is_all_but_shown(&self, state: &State) -> bool {
        let mut scene = self.scene.clone();
        scene.selected = state.scene.selected;
        scene == state.scene && self.has_materials(state)
    }

    fn has_materials(&self, state: &State) -> bool {
        let mut known = self.materials.iter();
        marks(state).all(|mark| known.next() == Some(&mark)) && known.next().is_none()
    }
}

/// Whether there is work that is in no file.
pub fn is_unsaved(state: &State) -> bool {
    let session = state.scene.session;
    match state.session.saved.get(&session) {
        Some(mark) => !mark.is_all_but_shown(state),
        // What a run before has left is in no file of a person's.
        None if !state.session.restored.is_empty() => true,
        // What a lesson sets is its own.
        None => state.lesson.is_none() && has_work(state),
    }
}

/// Whether a person has made a model or a fit.
fn has_work(state: &State) -> bool {
    let made_model = |opened: &Opened, material: &Material| {
        let mut fits = material.fits.iter();
        opened.brdf != material.guess && !fits.any(|fit| fit.outcome.brdf == opened.brdf)
    };
    let made_fit = |fit: &KeptFit| !fit.on_opening && fit.seconds.is_some();
    state.scene.opened.iter().any(|opened| {
        state.materials.get(&opened.id).is_some_and(|material| {
            made_model(opened, material) || material.fits.iter().any(made_fit)
        })
    })
}
