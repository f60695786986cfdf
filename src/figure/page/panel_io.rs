//! Input and output of drawing one panel.

use super::fit_output::FitOutput;
use crate::figure::drawing::Drawing;
use crate::figure::palette::Palette;
use crate::figure::scale::Axis;
use crate::figure::subject::{Look, Source, Subject};
use crate::figure::table::Table;

/// The drawing of a panel with the numbers in it.
#[derive(Clone, Debug, Default)]
pub(super) struct PanelDrawing {
    pub drawing: Drawing,
    pub table: Table,
    /// Its axis of values, where others may have the same.
    pub axis: Option<Axis>,
}

/// The subjects of a panel with its size in points and its palette.
pub(super) struct PanelInput<'a> {
    /// The subjects of the panel, in its order; without names where the panel is not to name them.
    pub subjects: &'a [Subject],
    /// The same subjects with their names.
    pub named: &'a [Subject],
    pub made: Option<&'a FitOutput>,
    /// Name of the measured material.
    pub name: &'a str,
    /// In points of the drawing.
    pub size: [f32; 2],
    /// Pixels per point of the drawing.
    pub density: f32,
    pub palette: &'a Palette,
}

impl PanelInput<'_> {
    pub(super) fn source(&self, measured: bool) -> Option<&Source> {
        let mut subjects = self.subjects.iter();
        let found = subjects.find(|subject| (subject.look == Look::Measured) == measured)?;
        Some(&found.source)
    }
}
