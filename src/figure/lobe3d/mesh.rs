//! The mesh of a lobe: directions laid out around the mirror direction, values there, and the surface they make.

use crate::figure::scale::Axis;
use crate::figure::subject::{Channel, Source};
use crate::geom::{Rgb, directions, mirror};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Rings around the mirror direction; the last one is the horizon.
pub const RINGS: usize = 60;
/// Directions on a ring.
pub const SPOKES: usize = 80;
/// How much closer rings lie near the mirror direction: ring k is at (k / RINGS)^CROWDING of the way to the horizon.
const CROWDING: f64 = 2.5;

/// The directions of a mesh for light at `theta_i` radians from the left: the mirror direction, then ring by ring.
///
/// The azimuth around the mirror direction runs from straight down, away from the light.
pub fn layout(theta_i: f64) -> Vec<DVec3> {
    let (sin, cos) = theta_i.sin_cos();
    let (peak, down, aside) = (
        DVec3::new(sin, 0.0, cos),
        DVec3::new(cos, 0.0, -sin),
        DVec3::Y,
    );
    let spokes: Vec<(DVec3, f64)> = (0..SPOKES)
        .map(|spoke| {
            let psi = azimuth(spoke as f64 / SPOKES as f64, cos);
            let outwards = psi.cos() * down + psi.sin() * aside;
            (outwards, cos.atan2(-outwards.z))
        })
        .collect();
    let mut all = vec![peak];
    for ring in 1..=RINGS {
        let share = (ring as f64 / RINGS as f64).powf(CROWDING);
        all.extend(spokes.iter().map(|(outwards, horizon)| {
            let (sin, cos) = (share * horizon).sin_cos();
            let w = cos * peak + sin * *outwards;
            // Rounding must not put the horizon below itself.
            DVec3::new(w.x, w.y, if ring == RINGS { 0.0 } else { w.z.max(0.0) }).normalize()
        }));
    }
    all
}

/// The azimuth of a spoke around the mirror direction, from its share of the circle: half way between an even spread
/// there and one that is even where the spokes meet the horizon. Near the horizon they would else leave half of it bare.
fn azimuth(share: f64, cos_theta_i: f64) -> f64 {
    let (mut low, mut high) = (0.0, TAU);
    for _ in 0..50 {
        let psi = 0.5 * (low + high);
        let on_horizon = (psi.sin() * cos_theta_i).atan2(psi.cos());
        if psi + directions::wrap(on_horizon, TAU) < 2.0 * TAU * share {
            low = psi;
        } else {
            high = psi;
        }
    }
    0.5 * (low + high)
}

/// f_r of every direction of a layout; `None` where there is no value.
pub fn sample(source: &Source, directions: &[DVec3]) -> Vec<Option<Rgb>> {
    let wi = mirror(directions[0]);
    let f_r = |wo: &DVec3| source.f_r(wi, *wo);
    directions
        .par_iter()
        .with_min_len(SPOKES)
        .map(f_r)
        .collect()
}

/// A lobe as triangles: the point of a direction is as far from the origin as its value says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LobeMesh {
    /// In units of the axis' limit; the origin where there is no value.
    pub positions: Vec<DVec3>,
    /// Outwards; 0 where no triangle is.
    pub normals: Vec<DVec3>,
    /// Only where all corners have values.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the direction has a value.
    valid: Vec<bool>,
}

impl LobeMesh {
    /// The surface of these values on an axis, times `factor`.
    pub fn new(
        directions: &[DVec3],
        values: &[Option<Rgb>],
        channel: Channel,
        factor: f64,
        axis: &Axis,
    ) -> Self {
        let mut mesh = Self::default();
        for (w, value) in directions.iter().zip(values) {
            let value = value.map(|rgb| factor * channel.of(rgb));
            let value = value.filter(|value| value.is_finite());
            mesh.valid.push(value.is_some());
            // One that is brighter than the axis ends at its limit.
            let radius = value.map_or(0.0, |value| axis.position(value).min(1.0));
            mesh.positions.push(radius * *w);
        }
        for [a, b, c] in all_triangles() {
            if mesh.valid[a] && mesh.valid[b] && mesh.valid[c] {
                mesh.triangles.push([a, b, c].map(|index| index as u32));
            }
        }
        mesh.normals = vec![DVec3::ZERO; mesh.positions.len()];
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|index| mesh.positions[index as usize]);
            let across = (b - a).cross(c - a);
            for index in corners {
                mesh.normals[*index as usize] += across;
            }
        }
        for normal in &mut mesh.normals {
            *normal = normal.normalize_or_zero();
        }
        mesh
    }

    /// Some rings and spokes as polylines, broken where there are no values: the mesh as wire.
    pub fn wire(&self) -> Vec<Vec<DVec3>> {
        const EVERY: usize = 4;
        let mut lines = Vec::new();
        for ring in (EVERY..=RINGS).step_by(EVERY) {
            lines.extend(self.runs((0..=SPOKES).map(|spoke| index(ring, spoke))));
        }
        for spoke in (0..SPOKES).step_by(EVERY) {
            // Near the peak every other spoke would only blacken it.
            let first = if spoke % (2 * EVERY) == 0 {
                0
            } else {
                RINGS / 3
            };
            lines.extend(self.runs((first..=RINGS).map(|ring| index(ring, spoke))));
        }
        lines
    }

    fn runs(&self, path: impl Iterator<Item = usize>) -> Vec<Vec<DVec3>> {
        let (mut runs, mut run) = (Vec::new(), Vec::new());
        for index in path {
            if self.valid[index] {
                run.push(self.positions[index]);
            } else {
                runs.push(std::mem::take(&mut run));
            }
        }
        runs.push(run);
        runs.retain(|run| run.len() > 1);
        runs
    }
}

/// Position of a direction in a layout. Ring 0 is the mirror direction alone.
fn index(ring: usize, spoke: usize) -> usize {
    if ring == 0 {
        0
    } else {
        1 + (ring - 1) * SPOKES + spoke % SPOKES
    }
}

/// Counter-clockwise seen from outside.
fn all_triangles() -> impl Iterator<Item = [usize; 3]> {
    (0..RINGS).flat_map(|ring| {
        (0..SPOKES).flat_map(move |spoke| {
            let near = [index(ring, spoke), index(ring, spoke + 1)];
            let far = [index(ring + 1, spoke), index(ring + 1, spoke + 1)];
            let outer = [near[0], far[0], far[1]];
            let inner = (ring > 0).then_some([near[0], far[1], near[1]]);
            std::iter::once(outer).chain(inner)
        })
    })
}
