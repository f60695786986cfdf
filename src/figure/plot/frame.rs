//! Map between values and points of a plot.

use crate::figure::drawing::Point;
use crate::figure::scale::Axis;

/// The rectangle of a plot with its two axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlotFrame {
    /// Upper left corner in points of the drawing.
    pub min: Point,
    /// Lower right corner.
    pub max: Point,
    /// Horizontal axis, from left to right.
    pub x: Axis,
    /// Vertical axis, from below to above.
    pub y: Axis,
}

impl PlotFrame {
    /// Width and height in points.
    pub fn size(&self) -> [f32; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    /// The point of a pair of values.
    pub fn point(&self, x: f64, y: f64) -> Point {
        self.at(x, self.y.share(y))
    }

    /// The point of a value of x and a share of the height, 0 below.
    pub fn at(&self, x: f64, share: f64) -> Point {
        let [width, height] = self.size();
        [
            self.min[0] + width * self.x.share(x) as f32,
            self.max[1] - height * share as f32,
        ]
    }

    /// The pair of values at a point; `None` outside.
    pub fn locate(&self, point: Point) -> Option<[f64; 2]> {
        self.contains(point).then(|| {
            let [x, y] = self.shares(point);
            [self.x.value(x), self.y.value(y)]
        })
    }

    /// Whether a point is inside.
    pub fn contains(&self, point: Point) -> bool {
        (0..2).all(|k| (self.min[k]..=self.max[k]).contains(&point[k]))
    }

    /// Shares of width and height of a point, in [0, 1] inside.
    pub fn shares(&self, point: Point) -> [f64; 2] {
        let [width, height] = self.size();
        [
            f64::from((point[0] - self.min[0]) / width.max(1e-3)),
            f64::from((self.max[1] - point[1]) / height.max(1e-3)),
        ]
    }

    /// Whether a pair of values is inside.
    pub fn shows(&self, x: f64, y: f64) -> bool {
        let inside = |share: f64| (-1e-9..=1.0 + 1e-9).contains(&share);
        inside(self.x.share(x)) && inside(self.y.share(y))
    }
}
