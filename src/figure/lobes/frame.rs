//! Map between angles, values and points of a lobe plot.

use crate::figure::drawing::Point;
use crate::figure::scale::Axis;
use crate::geom::limits::MAX_THETA_I;
use std::f64::consts::FRAC_PI_2;

/// The half disc of a lobe plot.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeFrame {
    /// Point of the drawing at which the light meets the surface.
    pub origin: Point,
    /// Radius of the rim in points.
    pub radius: f32,
    /// Values along the radius.
    pub axis: Axis,
    /// Angles of incidence in radians; their handles are on the rim, on the left.
    pub theta_i: Vec<f64>,
}

impl LobeFrame {
    /// The point of a signed angle from the normal, in radians, and a value.
    pub fn point(&self, theta: f64, value: f64) -> Point {
        self.at(theta, self.axis.position(value))
    }

    /// The point of a signed angle, in radians, and a share of the radius.
    pub fn at(&self, theta: f64, position: f64) -> Point {
        let r = f64::from(self.radius) * position;
        [
            (f64::from(self.origin[0]) + r * theta.sin()) as f32,
            (f64::from(self.origin[1]) - r * theta.cos()) as f32,
        ]
    }

    /// The signed angle in radians and the value at a point; `None` outside the half disc.
    pub fn locate(&self, point: Point) -> Option<(f64, f64)> {
        let (x, up) = self.offset(point);
        let position = x.hypot(up) / f64::from(self.radius);
        let inside = up >= 0.0 && position <= 1.0;
        inside.then(|| (x.atan2(up), self.axis.value(position)))
    }

    /// The signed θo in radians of a point of the half disc or of its rim; `None` elsewhere.
    pub fn theta_o_at(&self, point: Point) -> Option<f64> {
        let (x, up) = self.offset(point);
        let near = up >= 0.0 && x.hypot(up) <= 1.08 * f64::from(self.radius);
        near.then(|| x.atan2(up))
    }

    /// The signed angle of a point in radians, held to the horizon below it.
    fn theta_at(&self, point: Point) -> f64 {
        let (x, up) = self.offset(point);
        x.atan2(up).clamp(-FRAC_PI_2, FRAC_PI_2)
    }

    /// θi for a handle that is dragged to a point, from 0 to [`MAX_THETA_I`].
    pub fn theta_i_at(&self, point: Point) -> f64 {
        (-self.theta_at(point)).clamp(0.0, MAX_THETA_I)
    }

    /// Point of the handle of a θi.
    pub fn handle(&self, theta_i: f64) -> Point {
        self.at(-theta_i, 1.0)
    }

    /// Position of the θi whose handle is within `reach` of a point; the nearest if several have.
    pub fn nearest_light(&self, point: Point, reach: f32) -> Option<usize> {
        self.theta_i
            .iter()
            .map(|theta_i| distance(self.handle(*theta_i), point))
            .enumerate()
            .filter(|(_, distance)| *distance <= reach)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(index, _)| index)
    }

    /// (to the right, upwards) from the centre.
    fn offset(&self, point: Point) -> (f64, f64) {
        (
            f64::from(point[0]) - f64::from(self.origin[0]),
            f64::from(self.origin[1]) - f64::from(point[1]),
        )
    }
}

/// Distance of two points of a drawing, in points.
pub(super) fn distance(a: Point, b: Point) -> f32 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
