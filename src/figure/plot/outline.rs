//! The layout that a plot is asked for, and the pens of its curves.

use crate::figure::palette::{Ink, Role};
use crate::figure::scale::{Axis, Steps};
use crate::figure::subject::Subject;

/// What a plot is laid out from.
#[derive(Clone, Debug)]
pub struct Outline<'a> {
    /// What is plotted, as markup: the fullest first, shorter ones for less room.
    pub title: Vec<String>,
    /// Whose names are in the legend.
    pub subjects: &'a [Subject],
    /// The axis that all panels share.
    pub x: Axis,
    /// What its numbers are.
    pub x_steps: Steps,
    /// Its name and unit, as markup.
    pub x_name: String,
    /// From above to below.
    pub panels: Vec<Panel>,
}

/// One of several plots over each other.
#[derive(Clone, Debug)]
pub struct Panel {
    /// From below to above.
    pub axis: Axis,
    /// In relation to the other panels.
    pub height: f32,
    /// Over it, as markup, like the title of the plot; the first panel has none.
    pub title: Vec<String>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    /// In points.
    pub width: f32,
    /// Dash and gap in points; solid without.
    pub dash: Option<[f32; 2]>,
    /// Its colour.
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
