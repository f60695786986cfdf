//! Mark of the probe in a plot.

use super::drawing::{Item, Point};
use super::palette::Role;

/// A place on an axis (or on two) that the probe is at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbeMark<T = f64> {
    /// Place of the mark, in the terms of the plot.
    pub at: T,
    /// Whether the plot holds the probe itself. If not, this is where it would be by the plotted angle alone: other
    /// angles of the probe are not those of the plot, and it is drawn hollow.
    pub exact: bool,
}

/// The dot of the probe on a curve or an image.
pub(super) fn probe_dot(center: Point, role: Role, exact: bool) -> Item {
    let (ink, rim) = if exact {
        (role, Role::Background)
    } else {
        (Role::Background, role)
    };
    Item::Dot {
        center,
        radius: 4.0,
        ink: ink.into(),
        outline: Some((1.5, rim.into())),
    }
}
