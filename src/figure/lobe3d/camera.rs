//! Camera of the lobes in space: turned as on a ball under the hand, without perspective, so that lengths compare.

use crate::figure::drawing::Point;
use crate::figure::faults::{Faults, list};
use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// A view of the unit dome. The same on every canvas.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Camera {
    /// Rotation from the surface's frame to the view: x to the right, y up, z to the eye.
    pub rotation: DQuat,
    /// 1 where the dome just fits the canvas.
    pub zoom: f64,
    /// Point of the view in the middle of the canvas, in units of the dome's radius.
    pub center: [f64; 2],
}

/// Limits of the zoom.
const ZOOM: [f64; 2] = [0.5, 60.0];
/// The middle of the canvas is never farther than this from the dome's foot.
const REACH: f64 = 1.5;

impl Default for Camera {
    /// View from the front and a little above: light comes from the left, the mirror direction is on the right.
    fn default() -> Self {
        let upright = DQuat::from_mat3(&DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y));
        let turn = DQuat::from_rotation_x(0.38) * DQuat::from_rotation_y(0.32);
        Self {
            rotation: (turn * upright).normalize(),
            zoom: 1.0,
            center: [0.0, 0.40],
        }
    }
}

impl Camera {
    /// Brought to the nearest camera that there can be: from a file, its numbers may be any. The length of a rotation means
    /// nothing.
    pub fn sanitize(&mut self, faults: &mut Faults) {
        match self.rotation.length() {
            length if (length - 1.0).abs() < 1e-12 => {}
            length if (1e-6..1e6).contains(&length) => self.rotation = self.rotation.normalize(),
            _ => {
                let expected = "a quaternion of a length from 1e-6 to 1e6";
                faults.add("rotation", list(&self.rotation.to_array()), expected);
                self.rotation = Self::default().rotation;
            }
        }
        faults.number("zoom", &mut self.zoom, ZOOM);
        faults.inside("center", |faults| {
            for (key, middle) in ["0", "1"].into_iter().zip(&mut self.center) {
                faults.number(key, middle, [-REACH, REACH]);
            }
        });
    }
}

/// A camera on a canvas of a size in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceProjection {
    /// Direction and zoom of the view.
    pub camera: Camera,
    /// The point of the canvas where the middle of the view is.
    pub middle: Point,
    /// Points per unit of the dome's radius.
    pub scale: f64,
}

impl SpaceProjection {
    /// The dome with its arrows fits between the points `min` and `max` at zoom 1.
    pub fn new(camera: Camera, min: Point, max: Point) -> Self {
        let (width, height) = (f64::from(max[0] - min[0]), f64::from(max[1] - min[1]));
        Self {
            camera,
            middle: [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])],
            scale: camera.zoom * (width / 2.6).min(height / 1.85).max(1.0),
        }
    }

    /// Point in view space: x and y in units of the radius from the dome's foot, z to the eye.
    pub fn view(&self, p: DVec3) -> DVec3 {
        self.camera.rotation * p
    }

    /// Point of the canvas at which a point of the surface's frame is seen.
    pub fn point(&self, p: DVec3) -> Point {
        let v = self.view(p);
        let [x, y] = self.camera.center;
        [
            self.middle[0] + (self.scale * (v.x - x)) as f32,
            self.middle[1] - (self.scale * (v.y - y)) as f32,
        ]
    }

    /// The place in view space that is under a point of the canvas.
    pub fn unproject(&self, [px, py]: Point) -> [f64; 2] {
        let [x, y] = self.camera.center;
        [
            x + f64::from(px - self.middle[0]) / self.scale,
            y - f64::from(py - self.middle[1]) / self.scale,
        ]
    }

    /// Turned by a drag from one point of the canvas to another, as by a hand on a ball [Shoemake92].
    pub fn dragged(&self, from: Point, to: Point) -> Camera {
        let on_ball = |point: Point| {
            let [x, y] = [point[0] - self.middle[0], self.middle[1] - point[1]]
                .map(|d| f64::from(d) / (self.scale / self.camera.zoom) / 1.3);
            let inside = 1.0 - x * x - y * y;
            // Outside its half the ball goes on as a hyperbola, so that turning has no end.
            let flat = x.hypot(y);
            let z = if flat < std::f64::consts::FRAC_1_SQRT_2 {
                inside.sqrt()
            } else {
                0.5 / flat
            };
            DVec3::new(x, y, z).normalize()
        };
        let turn = DQuat::from_rotation_arc(on_ball(from), on_ball(to));
        Camera {
            rotation: (turn * self.camera.rotation).normalize(),
            ..self.camera
        }
    }

    /// Larger by `factor`; what is under `point` stays there.
    pub fn zoomed(&self, factor: f64, point: Point) -> Camera {
        let zoom = (self.camera.zoom * factor).clamp(ZOOM[0], ZOOM[1]);
        let kept = self.camera.zoom / zoom;
        let at = self.unproject(point);
        let center = [0, 1].map(|k| {
            let moved = at[k] + (self.camera.center[k] - at[k]) * kept;
            moved.clamp(-REACH, REACH)
        });
        Camera {
            zoom,
            center,
            ..self.camera
        }
    }
}
