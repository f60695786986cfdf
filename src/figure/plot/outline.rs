//! The layout that a plot is asked for, and the pens of its curves.

use crate::figure::palette::{Ink, Role};
use crate::figure::scale::{Axis, Steps};
use crate::figure::subject::Subject;

/// Input of the layout of a plot.
#[derive(Clone, Debug)]
pub struct Outline<'a> {
    /// Titles as markup: the fullest first, shorter ones for less room.
    pub title: Vec<String>,
    /// Subjects named in the legend.
    pub subjects: &'a [Subject],
    /// The axis that all panels share.
    pub x: Axis,
    /// Kind of round steps between the numbers of the horizontal axis.
    pub x_steps: Steps,
    /// Names at 1, 2, … on the horizontal axis, upright below it in place of numbers; numbers where it is empty.
    pub x_names: Vec<String>,
    /// Name and unit of the horizontal axis, as markup.
    pub x_name: String,
    /// Panels from above to below.
    pub panels: Vec<Panel>,
}

/// Panel of a plot; several stand over each other and share x.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Axis of values, from below to above.
    pub axis: Axis,
    /// Height in relation to the other panels.
    pub height: f32,
    /// Over it, as markup, like the title of the plot; the first panel has none.
    pub title: Vec<String>,
}

/// Look of a curve.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// Width in points.
    pub width: f32,
    /// Dash and gap in points; solid without.
    pub dash: Option<[f32; 2]>,
    /// Colour of the curve.
    pub ink: Ink,
}

impl Pen {
    /// The pen of a subject; thin and pale where it is not the one that matters.
    pub fn of(subject: &Subject, strong: bool) -> Self {
        Self {
            width: subject.look.width() * if strong { 1.0 } else { 0.6 },
            dash: subject.look.dash(),
            ink: Ink::from(Role::Series(subject.series)).faded(if strong { 1.0 } else { 0.5 }),
        }
    }

    /// A thin solid line.
    pub fn thin(ink: Ink) -> Self {
        Self {
            width: 1.0,
            dash: None,
            ink,
        }
    }
}
