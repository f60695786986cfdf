//! Map between values and points of a heat map, and the part of it that is in sight.

use super::Side;
use crate::figure::drawing::Point;
use crate::figure::faults::{Faults, list};
use serde::{Deserialize, Serialize};

/// The part of both axes that is in sight, as shares from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename = "View")]
pub struct HeatView {
    /// First and last share to the right.
    pub x: (f64, f64),
    /// First and last share upwards.
    pub y: (f64, f64),
}

impl Default for HeatView {
    /// All.
    fn default() -> Self {
        Self {
            x: (0.0, 1.0),
            y: (0.0, 1.0),
        }
    }
}

/// The least share of an axis that fills the picture.
const CLOSEST: f64 = 0.02;

impl HeatView {
    /// View shrunk towards a share of the picture (from its lower left corner) by a factor: below 1 is nearer.
    pub fn zoomed(self, at: [f64; 2], factor: f64) -> Self {
        let zoom = |(low, high): (f64, f64), at: f64| {
            let width = ((high - low) * factor).clamp(CLOSEST, 1.0);
            let fixed = low + (high - low) * at;
            held((fixed - width * at, fixed + width * (1.0 - at)))
        };
        Self {
            x: zoom(self.x, at[0]),
            y: zoom(self.y, at[1]),
        }
    }

    /// Brought to all where it is no part that there can be: from a file, its numbers may be any.
    pub fn sanitize(&mut self, faults: &mut Faults) {
        let possible = |(low, high): (f64, f64)| {
            low >= 0.0 && high <= 1.0 + 1e-9 && high - low >= CLOSEST * (1.0 - 1e-9)
        };
        let sides = [("x", self.x), ("y", self.y)];
        for (key, (low, high)) in sides.into_iter().filter(|(_, side)| !possible(*side)) {
            let expected = format!("two shares from 0 to 1, at least {CLOSEST} apart");
            faults.add(key, list(&[low, high]), expected);
            *self = Self::default();
        }
    }

    /// Moved by shares of the picture.
    pub fn moved(self, by: [f64; 2]) -> Self {
        let shift = |(low, high): (f64, f64), by: f64| {
            let by = by * (high - low);
            held((low + by, high + by))
        };
        Self {
            x: shift(self.x, by[0]),
            y: shift(self.y, by[1]),
        }
    }
}

/// Moved back where it goes past an end.
fn held((low, high): (f64, f64)) -> (f64, f64) {
    let width = (high - low).min(1.0);
    let low = low.clamp(0.0, 1.0 - width);
    (low, low + width)
}

/// The rectangle of the cells.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatFrame {
    /// Upper left corner in points of the drawing.
    pub min: Point,
    /// Lower right corner.
    pub max: Point,
    /// Horizontal axis, to the right.
    pub x: Side,
    /// Upwards.
    pub y: Side,
    /// Part of the map in sight.
    pub view: HeatView,
}

impl HeatFrame {
    /// Width and height in points.
    pub fn size(&self) -> [f32; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    /// The point of a pair of values; outside the rectangle where they are out of sight.
    pub fn point(&self, [x, y]: [f64; 2]) -> Point {
        let within =
            |side: &Side, (low, high): (f64, f64), at: f64| (side.share(at) - low) / (high - low);
        let [width, height] = self.size().map(f64::from);
        [
            (f64::from(self.min[0]) + width * within(&self.x, self.view.x, x)) as f32,
            (f64::from(self.max[1]) - height * within(&self.y, self.view.y, y)) as f32,
        ]
    }

    /// The share of the rectangle at a point, from its lower left corner, held to its edges.
    pub fn share_at(&self, point: Point) -> [f64; 2] {
        let [width, height] = self.size();
        [
            f64::from((point[0] - self.min[0]) / width).clamp(0.0, 1.0),
            f64::from((self.max[1] - point[1]) / height).clamp(0.0, 1.0),
        ]
    }

    /// The values at a point; `None` outside the rectangle.
    pub fn locate(&self, point: Point) -> Option<[f64; 2]> {
        let inside = (0..2).all(|k| (self.min[k]..=self.max[k]).contains(&point[k]));
        let [x, y] = self.share_at(point);
        let along = |(low, high): (f64, f64), share: f64| low + (high - low) * share;
        inside.then(|| {
            [
                self.x.value(along(self.view.x, x)),
                self.y.value(along(self.view.y, y)),
            ]
        })
    }
}
