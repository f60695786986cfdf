//! Messages and tasks of figures.

use crate::app::state::figure::FigurePrefs;
use crate::app::state::views::ViewId;

/// Something about a figure.
#[derive(Clone, Debug)]
pub enum FigureMsg {
    /// The pointer is on this view.
    Point(Option<ViewId>),
    /// Put these views into the figure.
    Choose(Vec<ViewId>),
    /// Another look or format.
    Set(FigurePrefs),
    /// Ask where to, and write the figure.
    Export,
}

/// Work on figures that is done outside the state.
#[derive(Debug)]
pub enum FigureTask {
    /// Ask where to, and write a figure of these views.
    Export(Vec<ViewId>),
    /// Put a picture of this view on the clipboard.
    CopyPicture(ViewId),
    /// Put the numbers of this view on the clipboard.
    CopyNumbers(ViewId),
}
