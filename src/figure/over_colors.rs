//! Lines and rings over a picture: light with a dark rim, to be seen on all colours.

use super::drawing::{Drawing, Item, Point};
use super::palette::{Ink, Role};

/// The light part.
pub(super) const LIGHT: Role = Role::Fixed([255, 255, 255]);
/// The rim.
pub(super) const DARK: Role = Role::Fixed([16, 16, 20]);

/// A polyline of some width in points; `dash` has the lengths of dash and gap.
pub(super) fn line(
    drawing: &mut Drawing,
    points: Vec<Point>,
    width: f32,
    dash: Option<[f32; 2]>,
    opacity: f32,
) {
    let rim = Ink::from(DARK).faded(0.45 * opacity);
    drawing.line(points.clone(), width + 1.6, rim);
    drawing.dashed_line(points, width, dash, Ink::from(LIGHT).faded(opacity));
}

/// A ring, filled with `middle` or hollow.
pub(super) fn ring(drawing: &mut Drawing, center: Point, radius: f32, filled: bool, middle: Role) {
    let inside = if filled { (middle, 1.0) } else { (DARK, 0.25) };
    drawing.items.push(Item::Dot {
        center,
        radius,
        ink: Ink::from(inside.0).faded(inside.1),
        outline: Some((3.0, Ink::from(DARK).faded(0.8))),
    });
    drawing.items.push(Item::Dot {
        center,
        radius,
        ink: Ink::from(middle).faded(f32::from(filled)),
        outline: Some((1.4, LIGHT.into())),
    });
}
