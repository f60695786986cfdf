//! Sanitising: the one place where what a file says is brought to what there can be: every number in its range, every
//! position inside its list, unit vectors of length 1. What is possible stays to the last bit.

use crate::app::session::file::{SavedFitting, SavedMaterial, SavedProbe, SavedWhat, SessionFile};
use crate::app::state::fitting::settings::widest_bounds;
use crate::brdf::params::Param;
use crate::brdf::{Fresnel, MODELS, Model, all_params};
use crate::fit::{STAGES, Stage};
use crate::geom::directions::unit;
use crate::measured::samples::SAMPLES;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

/// Least grazing limit in radians.
const LEAST_LIMIT: f64 = 20.0 * PI / 180.0;

/// The session with every value that cannot be replaced by the nearest that can.
pub fn session(mut session: SessionFile) -> SessionFile {
    for (index, one) in session.materials.iter_mut().enumerate() {
        material(one, index);
    }
    let count = session.materials.len();
    session.shown = session.shown.min(count.saturating_sub(1));
    session.hidden.retain(|key| {
        let known = match &key.what {
            SavedWhat::Measured | SavedWhat::Model => true,
            SavedWhat::Fit { model, fresnel } => {
                Model::by_key(model).is_some() && Fresnel::by_key(fresnel).is_some()
            }
        };
        known && key.material < count
    });
    session.views = session.views.sanitized();
    fitting(&mut session.fit);
    session.probe = session.probe.and_then(probe);
    session
}

fn material(material: &mut SavedMaterial, index: usize) {
    material.name = material.name.replace(char::is_control, " ");
    if material.name.trim().is_empty() {
        material.name = format!("material {}", index + 1);
    }
    let known = |key: &String| SAMPLES.iter().any(|sample| sample.key == key);
    material.sample = material.sample.take().filter(known);
    // An empty path would be the folder.
    material.source = material
        .source
        .take()
        .filter(|s| !s.path.as_os_str().is_empty());
    let mut seen = Vec::new();
    material.fits.retain(|fit| {
        let variant = crate::fit::Variant::from(&fit.record.brdf);
        let new = !seen.contains(&variant);
        seen.push(variant);
        new
    });
    for fit in &mut material.fits {
        fit.seconds = fit.seconds.filter(|seconds| (0.0..1e9).contains(seconds));
    }
}

fn fitting(fit: &mut SavedFitting) {
    fit.limit = fit.limit.clamp(LEAST_LIMIT, FRAC_PI_2);
    let stages: Vec<usize> = STAGES.map(Stage::number).into();
    fit.stages = keep(stages, &fit.stages);
    let keys: Vec<String> = all_params().map(|row| row.key().into()).collect();
    fit.held = keep(keys, &fit.held);
    fit.bounds = std::mem::take(&mut fit.bounds)
        .into_iter()
        .filter(|(key, ends)| {
            // Ranges differ between models: what one of them takes is kept.
            let rows = MODELS.iter().flat_map(|model| model.rows());
            let mut rows = rows.filter(|row| row.key() == key);
            rows.any(|row| are_bounds(row, *ends))
        })
        .collect::<BTreeMap<_, _>>();
}

/// Members of `all` that are `wanted`, in their order and once.
fn keep<T: PartialEq>(all: Vec<T>, wanted: &[T]) -> Vec<T> {
    all.into_iter().filter(|one| wanted.contains(one)).collect()
}

fn are_bounds(row: &Param, (low, high): (f64, f64)) -> bool {
    let (least, most) = widest_bounds(row);
    least <= low && low <= high && high <= most
}

fn probe(probe: SavedProbe) -> Option<SavedProbe> {
    Some(SavedProbe {
        wi: unit(probe.wi)?,
        wo: unit(probe.wo)?,
    })
}
