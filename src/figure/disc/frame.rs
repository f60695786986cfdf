//! Map between directions and points of a disc.

use super::projection::DiscProjection;
use crate::figure::drawing::Point;
use crate::figure::heatmap::{HeatFrame, HeatView, Law, Side};
use glam::DVec3;

/// The disc in a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscFrame {
    /// Middle of the disc in points: the normal.
    pub center: Point,
    /// Radius in points: the horizon.
    pub radius: f32,
    /// Law from θo to the distance from the middle.
    pub projection: DiscProjection,
}

impl DiscFrame {
    /// The point at a place in units of the radius, x to the right and y upwards.
    pub fn at(&self, [x, y]: [f64; 2]) -> Point {
        [
            self.center[0] + self.radius * x as f32,
            self.center[1] - self.radius * y as f32,
        ]
    }

    /// The place of a point, in units of the radius.
    pub fn place(&self, point: Point) -> [f64; 2] {
        [
            f64::from(point[0] - self.center[0]) / f64::from(self.radius),
            f64::from(self.center[1] - point[1]) / f64::from(self.radius),
        ]
    }

    /// The point of a direction.
    pub fn point(&self, w: DVec3) -> Point {
        self.at(self.projection.place(w))
    }

    /// The direction at a point; `None` outside the disc.
    pub fn direction(&self, point: Point) -> Option<DVec3> {
        self.projection.direction(self.place(point))
    }

    /// The square around the disc, as its cells are drawn.
    pub(super) fn square(&self) -> HeatFrame {
        let side = || Side {
            title: String::new(),
            law: Law::Linear,
            range: (-1.0, 1.0),
            degrees: false,
        };
        HeatFrame {
            min: self.at([-1.0, 1.0]),
            max: self.at([1.0, -1.0]),
            x: side(),
            y: side(),
            view: HeatView::default(),
        }
    }
}
