//! Between points of a lobe plot and angles: where things are, for drawing and for the pointer.

use crate::figure::drawing::Point;
use crate::figure::scale::RadialScale;
use std::f64::consts::FRAC_PI_2;

/// The half disc of a lobe plot.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeFrame {
    /// Where the surface point is.
    pub origin: Point,
    /// Radius of the rim in points.
    pub radius: f32,
    /// Radius per value.
    pub scale: RadialScale,
    /// Value at the rim.
    pub limit: f64,
    theta_i: Vec<f64>,
}

/// Room around the half disc for labels: sides, top and bottom.
const MARGIN: [f32; 3] = [40.0, 30.0, 40.0];

/// Where on its radius the handle of a light is.
pub(super) const HANDLE: f32 = 1.0;

impl LobeFrame {
    pub(super) fn new(
        [width, height]: [f32; 2],
        scale: RadialScale,
        limit: f64,
        theta_i: Vec<f64>,
    ) -> Self {
        let [side, top, bottom] = MARGIN;
        let radius = (0.5 * width - side).min(height - top - bottom).max(8.0);
        // Centred in what is left, the surface towards the bottom.
        let spare = (height - top - bottom - radius).max(0.0);
        let origin = [0.5 * width, top + radius + 0.5 * spare];
        Self {
            origin,
            radius,
            scale,
            limit,
            theta_i,
        }
    }

    /// The point at signed `theta` in radians, `length` of the radius from the origin.
    pub fn at(&self, theta: f64, length: f32) -> Point {
        let (sin, cos) = theta.sin_cos();
        let r = self.radius * length;
        [
            self.origin[0] + r * sin as f32,
            self.origin[1] - r * cos as f32,
        ]
    }

    /// The point of a value at signed θo; values past the limit stay on the rim.
    pub fn point(&self, theta_o: f64, value: f64) -> Point {
        self.at(
            theta_o,
            self.scale.length(value, self.limit).min(1.0) as f32,
        )
    }

    /// Signed θo in radians and the value at a point, the inverse of [`LobeFrame::point`].
    pub fn theta_o_and_value(&self, point: Point) -> (f64, f64) {
        let (x, y) = (
            f64::from(point[0] - self.origin[0]),
            f64::from(self.origin[1] - point[1]),
        );
        let length = x.hypot(y) / f64::from(self.radius);
        (x.atan2(y), self.scale.value(length, self.limit))
    }

    /// Signed θo under the pointer; `None` below the surface or outside the rim.
    pub fn theta_o_at(&self, point: Point) -> Option<f64> {
        let (theta_o, _) = self.theta_o_and_value(point);
        let (x, y) = (point[0] - self.origin[0], point[1] - self.origin[1]);
        (theta_o.abs() < FRAC_PI_2 && x.hypot(y) <= 1.08 * self.radius).then_some(theta_o)
    }

    /// θi in [0, π/2] for a light dragged to a point: the light is on the left.
    pub fn theta_i_at(&self, point: Point) -> f64 {
        let (theta, _) = self.theta_o_and_value(point);
        (-theta).clamp(0.0, FRAC_PI_2)
    }

    /// Position in the list of the light whose handle is within `reach` points of a point.
    pub fn nearest_light(&self, point: Point, reach: f32) -> Option<usize> {
        let distance = |theta_i: f64| {
            let [x, y] = self.at(-theta_i, HANDLE);
            (x - point[0]).hypot(y - point[1])
        };
        (0..self.theta_i.len())
            .map(|index| (index, distance(self.theta_i[index])))
            .filter(|(_, distance)| *distance < reach)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(index, _)| index)
    }
}
