//! One panel of a page: what a kind of view is on paper, what it is drawn from, and what comes out.

use super::albedo::KnownAlbedos;
use super::cosine::CosineFactor;
use super::drawing::Drawing;
use super::faults::Faults;
use super::fit_output::FitOutput;
use super::palette::Palette;
use super::scale::{Axis, RadialScale};
use super::subject::{Channel, Look, Source, Subject};
use super::table::DataTable;

/// Settings that must agree for the axes of two panels of one kind of view to have the same ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SharedAxis {
    /// Law from values to lengths or colours; `None` where the data choose it.
    pub scale: Option<RadialScale>,
    /// Cosines that f_r is multiplied by.
    pub cosine: CosineFactor,
    /// Channel of the values.
    pub channel: Channel,
}

/// A kind of view on paper. Its type is the spec of the view.
pub trait PanelView {
    /// Brings every value to the nearest that can be drawn, and names those that it changed.
    fn sanitize(&mut self, faults: &mut Faults);

    /// Names what does not suit so many subjects of a panel.
    fn check_subjects(&self, _count: usize, _faults: &mut Faults) {}

    /// Height of a panel `width` points wide that suits it: room for the picture and for words of the size `font`.
    fn height(&self, width: f32, font: f32) -> f32;

    /// Curves of each subject.
    fn curves(&self) -> usize {
        usize::from(self.has_curves())
    }

    /// Whether it has curves, which a legend below the page names.
    fn has_curves(&self) -> bool {
        false
    }

    /// Settings of the axis of values, where panels can share one.
    fn shared_axis(&self) -> Option<SharedAxis> {
        None
    }

    /// Takes an axis that is shared with other panels; one whose ends are set keeps them.
    fn share_axis(&mut self, _axis: Axis) {}

    /// Draws the panel in the size of `input`.
    fn draw(&self, input: &PanelInput) -> PanelDrawing;
}

/// The drawing of a panel with the numbers in it.
#[derive(Clone, Debug, Default)]
pub struct PanelDrawing {
    /// The picture, of the size that was asked for.
    pub drawing: Drawing,
    /// The numbers in the picture; no rows where it is a picture only.
    pub table: DataTable,
    /// Axis of values, where others may have the same.
    pub axis: Option<Axis>,
}

/// The subjects of a panel with its size in points and its palette.
pub struct PanelInput<'a> {
    /// The subjects of the panel, in its order; without names where the panel is not to name them.
    pub subjects: &'a [Subject],
    /// Subjects of the panel with their names, in the same order.
    pub named: &'a [Subject],
    /// Output of a fit, for the views that show it.
    pub made: Option<&'a FitOutput>,
    /// Name of the measured material.
    pub name: &'a str,
    /// Width and height in points of the drawing.
    pub size: [f32; 2],
    /// Pixels per point of the drawing.
    pub density: f32,
    /// Colours of the page.
    pub palette: &'a Palette,
    /// Whether the numbers are wanted too; without them a large figure takes a tenth of the memory.
    pub numbers: bool,
    /// Albedo curves of the page that are known.
    pub albedos: &'a KnownAlbedos,
}

impl PanelInput<'_> {
    /// The first measured subject, or the first other one.
    pub fn source(&self, measured: bool) -> Option<&Source> {
        let mut subjects = self.subjects.iter();
        let found = subjects.find(|subject| (subject.look == Look::Measured) == measured)?;
        Some(&found.source)
    }
}
