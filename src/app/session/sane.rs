//! The one place where what a file says is brought to what there can be: every number in its range, every position
//! inside its list, unit vectors of length 1. What is possible stays to the last bit.

use crate::app::session::file::{
    SavedFitting, SavedMaterial, SavedProbe, SavedWhat, SessionFile, Views,
};
use crate::brdf::params::Param;
use crate::brdf::{Fresnel, Model, params};
use crate::fit::options::default_bounds;
use crate::fit::{STAGES, Stage};
use crate::geom::limits::{MAX_EXPOSURE_STOPS, MAX_THETA_I};
use crate::geom::sphere::{MAX_LIGHTS, SphereView};
use crate::measured::samples::SAMPLES;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Angles of incidence that a tile offers at most.
const MOST_ANGLES: usize = 5;
/// The brightest light.
const STRONGEST: f64 = 1e3;
/// Least grazing limit in radians.
const LEAST_LIMIT: f64 = 20.0 * PI / 180.0;
/// Values in 1/sr on an axis are below this.
const HIGHEST: f64 = 1e12;

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
    views(&mut session.views);
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
    material.source = material.source.take().filter(|s| !s.path.is_empty());
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

fn views(views: &mut Views) {
    let sphere = &mut views.sphere;
    lights(&mut sphere.view);
    sphere.split = sphere.split.clamp(-1.0, 1.0);
    sphere.sight = sphere.sight.sane();

    angles(&mut views.lobes.theta_i, &[60f64.to_radians()], MAX_THETA_I);
    views.lobes.active = views.lobes.active.min(views.lobes.theta_i.len() - 1);

    let slices = &mut views.slices.spec;
    angles(&mut slices.theta_i, &[60f64.to_radians()], FRAC_PI_2);
    slices.active = slices.active.min(slices.theta_i.len() - 1);
    slices.theta_h = slices.theta_h.clamp(0.0, FRAC_PI_2);
    slices.theta_d = slices.theta_d.clamp(0.0, FRAC_PI_2);
    slices.phi_d = slices.phi_d.clamp(0.0, TAU);
    slices.window = window(slices.window, slices.over.range());
    slices.limits = limits(slices.limits);

    let albedo = &mut views.albedo.spec;
    albedo.window = window(albedo.window, [0.0, FRAC_PI_2]);
    albedo.limits = limits(albedo.limits);

    views.scatter = views.scatter.sane();
    views.lobe3d.theta_i = views.lobe3d.theta_i.clamp(0.0, MAX_THETA_I);
    views.lobe3d.camera = views.lobe3d.camera.held();
    views.image.phi_d = views.image.phi_d.clamp(0.0, PI);
    for view in [
        &mut views.image.view,
        &mut views.error_map.view,
        &mut views.landscape.view,
    ] {
        *view = view.or_all();
    }
}

fn lights(view: &mut SphereView) {
    view.lights.truncate(MAX_LIGHTS);
    if view.lights.is_empty() {
        view.lights = SphereView::default().lights;
    }
    for light in &mut view.lights {
        light.direction = unit(light.direction).unwrap_or(DVec3::Z);
        light.strength = light.strength.map(|channel| channel.clamp(0.0, STRONGEST));
    }
    view.exposure_stops = view
        .exposure_stops
        .clamp(-MAX_EXPOSURE_STOPS, MAX_EXPOSURE_STOPS);
}

/// At least one angle in [0, `last`], at most as many as the tile offers.
fn angles(angles: &mut Vec<f64>, usual: &[f64], last: f64) {
    angles.truncate(MOST_ANGLES);
    if angles.is_empty() {
        angles.extend(usual);
    }
    for angle in angles {
        *angle = angle.clamp(0.0, last);
    }
}

/// A part of a range of angles; `None` is all of it.
fn window(window: Option<[f64; 2]>, [first, last]: [f64; 2]) -> Option<[f64; 2]> {
    let [low, high] = window?;
    // As narrow as the wheel makes it.
    let least = 1e-3 * (last - first) / 90.0;
    let inside = low >= first - 1e-9 && high <= last + 1e-9;
    (inside && high - low >= 0.99 * least).then_some([low, high])
}

/// The ends of an axis of values.
fn limits(limits: Option<[f64; 2]>) -> Option<[f64; 2]> {
    let [low, high] = limits?;
    let possible = low >= 0.0 && (1e-12..HIGHEST).contains(&high) && high - low > 1e-6 * high;
    possible.then_some([low, high])
}

fn fitting(fit: &mut SavedFitting) {
    fit.limit = fit.limit.clamp(LEAST_LIMIT, FRAC_PI_2);
    let stages: Vec<usize> = STAGES.map(Stage::number).into();
    fit.stages = keep(stages, &fit.stages);
    let keys: Vec<String> = params::ALL.iter().map(|row| row.key.into()).collect();
    fit.held = keep(keys, &fit.held);
    fit.bounds = std::mem::take(&mut fit.bounds)
        .into_iter()
        .filter(|(key, ends)| {
            let row = params::ALL.iter().find(|row| row.key == key);
            row.is_some_and(|row| are_bounds(row, *ends))
        })
        .collect::<BTreeMap<_, _>>();
}

/// Those of `all` that are `wanted`, in their order and once.
fn keep<T: PartialEq>(all: Vec<T>, wanted: &[T]) -> Vec<T> {
    all.into_iter().filter(|one| wanted.contains(one)).collect()
}

fn are_bounds(row: &Param, (low, high): (f64, f64)) -> bool {
    let least = default_bounds(row).0.min(row.range.0).max(row.domain.0);
    least <= low && low <= high && high <= row.domain.1
}

fn probe(probe: SavedProbe) -> Option<SavedProbe> {
    Some(SavedProbe {
        wi: unit(probe.wi)?,
        wo: unit(probe.wo)?,
    })
}

/// The direction of a vector; `None` where it has none.
fn unit(v: DVec3) -> Option<DVec3> {
    match v.length() {
        length if (length - 1.0).abs() < 1e-12 => Some(v),
        length if (1e-6..1e6).contains(&length) => Some(v / length),
        _ => None,
    }
}
