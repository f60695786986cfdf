//! Writer of sessions, from the state to their data.

use crate::app::session::file::{
    SavedBrdf, SavedFit, SavedFitting, SavedKey, SavedMaterial, SavedProbe, SavedWhat, SessionFile,
    VERSION, keys_of_hidden,
};
use crate::app::state::State;
use crate::app::state::fitting::FitState;
use crate::app::state::material::{MaterialId, Opened, Origin, Presence};
use crate::app::state::subject_key::{SubjectKey, What};
use crate::brdf::all_params;
use crate::files::session::SavedSource;
use crate::fit::Stage;
use crate::measured::samples::SAMPLES;
use std::path::Path;

impl SessionFile {
    /// Open session, without relative paths ([`SessionFile::place_in`]). Of a fit under way, the best so far.
    pub fn of(state: &State) -> Self {
        let scene = &state.scene;
        let opened = scene.opened.iter();
        let position = |id: MaterialId| scene.opened.iter().position(|opened| opened.id == id);
        let probe = state.pinned.map(|probe| SavedProbe {
            wi: probe.wi,
            wo: probe.wo,
        });
        Self {
            grazing_session: VERSION,
            program: env!("CARGO_PKG_NAME").into(),
            version: env!("CARGO_PKG_VERSION").into(),
            saved_as: None,
            materials: opened.filter_map(|one| material(state, one)).collect(),
            shown: scene.selected,
            hidden: scene
                .hidden
                .iter()
                .filter_map(|key| hidden(*key, position))
                .collect(),
            lookup: scene.lookup,
            views: scene.views.clone(),
            fit: fitting(&state.fit),
            probe,
            layout: Some(state.tiles.clone()),
        }
    }

    /// Session with its paths from the folder of the session file on.
    pub fn placed(mut self, file: &Path) -> Self {
        if let Some(folder) = crate::files::absolute(file).parent() {
            self.place_in(folder);
        }
        self
    }
}

fn material(state: &State, opened: &Opened) -> Option<SavedMaterial> {
    let material = state.materials.get(&opened.id)?;
    let live = state.fit.run.as_ref().and_then(|run| run.live);
    let live = live.filter(|live| live.id == opened.id);
    let sample = match material.origin {
        Origin::Sample(index) => SAMPLES.get(index).map(|sample| sample.key.to_owned()),
        Origin::File(_) => None,
    };
    // One that was not found is named as the session before named it: it may come back in either place.
    let missing = state.session.missing_one(opened.id);
    let missing = missing.filter(|_| material.presence == Presence::Missing);
    let source = match missing {
        Some(missing) => Some(missing.source.clone()),
        None => material.source.as_ref().map(SavedSource::from),
    };
    let fits = material.fits.iter().map(|kept| SavedFit {
        record: kept.record(material.own_name.clone(), material.source.clone()),
        seconds: kept.seconds,
        overlaid: kept.overlaid,
    });
    Some(SavedMaterial {
        name: material.own_name.clone(),
        source,
        sample,
        model: SavedBrdf(live.map_or(opened.brdf, |live| live.brdf)),
        guess: SavedBrdf(material.guess),
        beside: opened.beside,
        fits: fits.collect(),
    })
}

fn hidden(key: SubjectKey, position: impl Fn(MaterialId) -> Option<usize>) -> Option<SavedKey> {
    Some(SavedKey {
        material: position(key.material)?,
        what: match key.what {
            What::Measured => SavedWhat::Measured,
            What::Model => SavedWhat::Model,
            What::Fit(variant) => SavedWhat::Fit {
                model: variant.model.key.into(),
                fresnel: variant.fresnel.key().into(),
            },
        },
    })
}

fn fitting(fit: &FitState) -> SavedFitting {
    let settings = &fit.settings;
    SavedFitting {
        weight: settings.weight,
        limit: settings.limit,
        stages: settings.stages.iter().map(Stage::number).collect(),
        held: all_params()
            .filter(|row| settings.held.contains(&row.id))
            .map(|row| row.key().into())
            .collect(),
        bounds: settings
            .bounds
            .iter()
            .map(|(id, bounds)| (id.key().into(), *bounds))
            .collect(),
        from_sliders: settings.from_sliders,
        keep_optimal: fit.keep_optimal,
        sort: fit.table.sort,
        descending: fit.table.descending,
        hidden_columns: keys_of_hidden(&fit.table),
    }
}
