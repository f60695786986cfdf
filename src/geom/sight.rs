//! The visible part of a sphere: zoom and centre.

use serde::{Deserialize, Serialize};

/// Largest zoom.
pub const MAX_ZOOM: f64 = 50.0;

/// Zoom and centre of a view of the sphere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sight {
    /// Magnification, in [1, 50]; 1 where the whole sphere just fits.
    pub zoom: f64,
    /// Point in the middle of the view, in units of the radius, x to the right and y up.
    pub center: [f64; 2],
}

impl Default for Sight {
    fn default() -> Self {
        Self {
            zoom: 1.0,
            center: [0.0; 2],
        }
    }
}

impl Sight {
    /// Point of the sphere at a point of the picture; both in units of the radius, x to the right and y up.
    pub fn point(self, x: f64, y: f64) -> (f64, f64) {
        (
            self.center[0] + x / self.zoom,
            self.center[1] + y / self.zoom,
        )
    }

    /// View with the zoom multiplied by `factor` around a point that stays in place; the whole sphere where the zoom
    /// would not exceed 1.
    pub fn zoomed(self, factor: f64, point: [f64; 2]) -> Self {
        let zoom = (self.zoom * factor).clamp(1.0, MAX_ZOOM);
        if zoom == 1.0 || !zoom.is_finite() {
            return Self::default();
        }
        let stays = self.zoom / zoom;
        Self {
            zoom,
            center: std::array::from_fn(|k| {
                (point[k] + stays * (self.center[k] - point[k])).clamp(-1.0, 1.0)
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_point_under_the_pointer_stays() {
        let point = [0.4, -0.2];
        let place =
            |sight: Sight| std::array::from_fn(|k| sight.zoom * (point[k] - sight.center[k]));
        let before: [f64; 2] = place(Sight::default());
        let near = Sight::default().zoomed(2.0, point).zoomed(1.7, point);
        let after: [f64; 2] = place(near);
        assert!(
            (0..2).all(|k| (before[k] - after[k]).abs() < 1e-12),
            "{after:?}"
        );
        assert!((near.zoom - 3.4).abs() < 1e-12);
        assert_eq!(near.zoomed(0.01, point), Sight::default());
        assert_eq!(near.zoomed(f64::NAN, point), Sight::default());
    }
}
