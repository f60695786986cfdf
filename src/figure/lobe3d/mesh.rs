//! The mesh of a lobe: directions laid out around the mirror direction, values there, and the surface they make.

use crate::figure::scale::Axis;
use crate::figure::subject::Source;
use crate::geom::{Rgb, directions, mirror};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Fineness of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// Mesh for a large picture and for paper.
    #[default]
    Fine,
    /// Mesh for a picture in which the pieces of a fine mesh are about as small as pixels.
    Coarse,
}

/// A dome is large from here on: its width and height in points.
const LARGE: f64 = 280.0;

impl Detail {
    /// Fineness for a picture of this size in points, enlarged `zoom` times.
    pub fn of([width, height]: [f32; 2], zoom: f64) -> Self {
        if zoom * f64::from(width.min(height)) < LARGE {
            Self::Coarse
        } else {
            Self::Fine
        }
    }

    /// Rings around the mirror direction; the last one is the horizon.
    pub fn rings(self) -> usize {
        15 * self.pieces()
    }

    /// Directions on a ring.
    pub fn spokes(self) -> usize {
        20 * self.pieces()
    }

    /// Pieces of the mesh from one line of the wire to the next.
    fn pieces(self) -> usize {
        match self {
            Self::Fine => 4,
            Self::Coarse => 2,
        }
    }

    /// Position of a direction in a layout. Ring 0 is the mirror direction alone.
    fn index(self, ring: usize, spoke: usize) -> usize {
        if ring == 0 {
            0
        } else {
            1 + (ring - 1) * self.spokes() + spoke % self.spokes()
        }
    }

    /// Counter-clockwise seen from outside.
    fn triangles(self) -> impl Iterator<Item = [usize; 3]> {
        (0..self.rings()).flat_map(move |ring| {
            (0..self.spokes()).flat_map(move |spoke| {
                let near = [self.index(ring, spoke), self.index(ring, spoke + 1)];
                let far = [self.index(ring + 1, spoke), self.index(ring + 1, spoke + 1)];
                let outer = [near[0], far[0], far[1]];
                let inner = (ring > 0).then_some([near[0], far[1], near[1]]);
                std::iter::once(outer).chain(inner)
            })
        })
    }
}

/// Crowding of rings near the mirror direction: ring k of n is at (k/n)^CROWDING of the way to the horizon.
const CROWDING: f64 = 2.5;

/// The directions of a mesh for light at `theta_i` radians from the left: the mirror direction, then ring by ring.
///
/// The azimuth around the mirror direction runs from straight down, away from the light.
pub fn layout(theta_i: f64, detail: Detail) -> Vec<DVec3> {
    let (rings, spokes) = (detail.rings(), detail.spokes());
    let (sin, cos) = theta_i.sin_cos();
    let (peak, down, aside) = (
        DVec3::new(sin, 0.0, cos),
        DVec3::new(cos, 0.0, -sin),
        DVec3::Y,
    );
    let outwards: Vec<(DVec3, f64)> = (0..spokes)
        .map(|spoke| {
            let psi = azimuth(spoke as f64 / spokes as f64, cos);
            let outwards = psi.cos() * down + psi.sin() * aside;
            (outwards, cos.atan2(-outwards.z))
        })
        .collect();
    let mut all = vec![peak];
    for ring in 1..=rings {
        let share = (ring as f64 / rings as f64).powf(CROWDING);
        all.extend(outwards.iter().map(|(outwards, horizon)| {
            let (sin, cos) = (share * horizon).sin_cos();
            let w = cos * peak + sin * *outwards;
            // Rounding must not put the horizon below itself.
            DVec3::new(w.x, w.y, if ring == rings { 0.0 } else { w.z.max(0.0) }).normalize()
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
        .with_min_len(Detail::Fine.spokes())
        .map(f_r)
        .collect()
}

/// A lobe as triangles: the point of a direction is as far from the origin as its value says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LobeMesh {
    /// Corners, in units of the axis' limit; the origin where there is no value.
    pub positions: Vec<DVec3>,
    /// Outwards; 0 where no triangle is.
    pub normals: Vec<DVec3>,
    /// Corners of each triangle by position; only triangles whose corners all have values.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the direction has a value.
    valid: Vec<bool>,
    detail: Detail,
}

impl LobeMesh {
    /// The surface of these values at the directions of a layout of this detail on an axis; `scalar` says what
    /// is shown of f_r towards a direction.
    pub fn new(
        detail: Detail,
        (directions, values): (&[DVec3], &[Option<Rgb>]),
        scalar: impl Fn(Rgb, DVec3) -> f64,
        axis: &Axis,
    ) -> Self {
        let mut mesh = Self {
            detail,
            ..Self::default()
        };
        for (w, value) in directions.iter().zip(values) {
            let value = value.map(|f_r| scalar(f_r, *w));
            let value = value.filter(|value| value.is_finite());
            mesh.valid.push(value.is_some());
            // One that is brighter than the axis ends at its limit.
            let radius = value.map_or(0.0, |value| axis.position(value).min(1.0));
            mesh.positions.push(radius * *w);
        }
        for [a, b, c] in detail.triangles() {
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

    /// Polylines along some rings and spokes, broken where there are no values: the mesh as wire.
    pub fn wire(&self) -> Vec<Vec<DVec3>> {
        let detail = self.detail;
        let (rings, spokes, every) = (detail.rings(), detail.spokes(), detail.pieces());
        let mut lines = Vec::new();
        for ring in (every..=rings).step_by(every) {
            lines.extend(self.runs((0..=spokes).map(|spoke| detail.index(ring, spoke))));
        }
        for spoke in (0..spokes).step_by(every) {
            // Near the peak every other spoke would only blacken it.
            let first = if spoke % (2 * every) == 0 {
                0
            } else {
                rings / 3
            };
            lines.extend(self.runs((first..=rings).map(|ring| detail.index(ring, spoke))));
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
