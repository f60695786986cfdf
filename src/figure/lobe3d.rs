//! Lobes in space: f_r over all outgoing directions for one θi, measured as a solid, models as wire.
//!
//! The light comes from the left, in the plane of incidence y = 0; the mirror direction is on the right. Whoever draws
//! it (a graphics adapter, a writer of files) gets the surfaces, the lines in space and what is written over them.

mod camera;
mod lobes;
mod mesh;
mod overlay;
mod panel;
mod raster;
mod space;

pub use camera::{Camera, SpaceProjection};
pub use lobes::{Lobe, Lobes, Shape};
pub use mesh::{Detail, LobeMesh, layout, sample};
pub use overlay::Overlay;
pub use panel::Lobe3dSpec;
pub use raster::picture;
pub use space::{SpaceFill, SpaceLine, ground, wires};

use super::drawing::Point;
use glam::DVec3;

/// The direction under a point of the canvas: that of the nearest point of any of the meshes there.
pub fn pick<'a>(
    meshes: impl Iterator<Item = &'a LobeMesh>,
    projection: &SpaceProjection,
    point: Point,
) -> Option<DVec3> {
    let [x, y] = projection.unproject(point);
    let mut nearest: Option<(f64, DVec3)> = None;
    for mesh in meshes {
        let seen: Vec<DVec3> = mesh.positions.iter().map(|p| projection.view(*p)).collect();
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|index| seen[index as usize]);
            let Some(weights) = barycentric([x, y], a, b, c) else {
                continue;
            };
            let z = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
            if nearest.is_none_or(|(nearest, _)| z > nearest) {
                let [a, b, c] = corners.map(|index| mesh.positions[index as usize]);
                nearest = Some((z, weights[0] * a + weights[1] * b + weights[2] * c));
            }
        }
    }
    let hit = nearest?.1;
    let w = DVec3::new(hit.x, hit.y, hit.z.max(0.0));
    (w.length() > 1e-6).then(|| w.normalize())
}

/// Weights of the corners at a point of the view; `None` outside the triangle.
fn barycentric([x, y]: [f64; 2], a: DVec3, b: DVec3, c: DVec3) -> Option<[f64; 3]> {
    let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if area.abs() < 1e-15 {
        return None;
    }
    let v = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
    let w = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
    let weights = [1.0 - v - w, v, w];
    weights
        .iter()
        .all(|weight| *weight >= 0.0)
        .then_some(weights)
}

#[cfg(test)]
mod tests;
