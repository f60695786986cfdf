//! Figures for papers out of the window: what is on one, how it looks, and the jobs that preview, write and copy it.

mod figure;
mod work;

pub use figure::{Drawable, can_draw, default_name, figure_of};
pub use work::{PreviewWish, Sheet, start};

use super::state::{Dialog, State};
use super::tiles::Pane;
use super::update::Task;
use crate::export::Format;
use crate::figure::page::Style;
use serde::{Deserialize, Serialize};

/// What a figure is set to, kept between runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FigurePrefs {
    /// How it looks.
    pub style: Style,
    /// What it is written as.
    pub format: Format,
    /// Panels beside each other.
    pub columns: usize,
}

impl Default for FigurePrefs {
    fn default() -> Self {
        Self {
            style: Style::default(),
            format: Format::default(),
            columns: 2,
        }
    }
}

/// Which view the pointer is on, and which ones go into a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Views {
    /// Under the pointer.
    pub pointed: Option<Pane>,
    /// The last one that was.
    pub last: Option<Pane>,
    /// Those in the figure that is being made, in its order.
    pub chosen: Vec<Pane>,
}

/// Something about a figure.
#[derive(Clone, Debug)]
pub enum PaperMsg {
    /// The pointer is on this view.
    Point(Option<Pane>),
    /// Put these views into the figure.
    Choose(Vec<Pane>),
    /// Another look or format.
    Set(FigurePrefs),
    /// Ask where to, and write the figure.
    Export,
}

/// What is to be done with figures outside the state.
#[derive(Debug)]
pub enum PaperTask {
    /// Ask where to, and write it; the proposed name.
    Export(Drawable, Format, String),
    /// Put its picture on the clipboard; the name of the view.
    CopyPicture(Drawable, &'static str),
    /// Put its numbers on the clipboard.
    CopyNumbers(Drawable, &'static str),
}

impl State {
    /// The view that is meant by a command: the one under the pointer, else the last one that can be drawn.
    pub fn meant_view(&self) -> Option<Pane> {
        let drawn = |pane: &Pane| can_draw(self, *pane);
        let views = &self.views;
        views.pointed.or(views.last).filter(drawn).or_else(|| {
            let front = [Pane::Lobes, Pane::Sphere, Pane::Slices];
            front.into_iter().find(drawn)
        })
    }
}

/// Changes the state.
pub(super) fn apply(state: &mut State, msg: PaperMsg) -> Vec<Task> {
    match msg {
        PaperMsg::Point(pane) => {
            state.views.pointed = pane;
            state.views.last = pane.or(state.views.last);
        }
        PaperMsg::Choose(panes) => state.views.chosen = panes,
        PaperMsg::Set(prefs) => state.prefs.figure = prefs,
        PaperMsg::Export => {
            let prefs = &state.prefs.figure;
            let drawable = figure_of(state, &state.views.chosen, prefs.columns, &prefs.style);
            if let Some(drawable) = drawable {
                let name = default_name(state, &state.views.chosen);
                let name = format!("{name}.{}", prefs.format.extension());
                let format = prefs.format;
                state.dialog = None;
                return vec![Task::Paper(PaperTask::Export(drawable, format, name))];
            }
        }
    }
    Vec::new()
}

/// Opens the dialog on the view that is meant.
pub(super) fn open(state: &mut State) {
    let kept = state.views.chosen.iter().copied();
    let kept: Vec<Pane> = kept.filter(|pane| can_draw(state, *pane)).collect();
    state.views.chosen = match (kept.len(), state.meant_view()) {
        // Several were chosen by hand.
        (2.., _) => kept,
        (_, Some(pane)) => vec![pane],
        (_, None) => Vec::new(),
    };
    state.dialog = Some(Dialog::Figure);
}

/// A task on the view that is meant, alone on a page.
pub(super) fn copy(
    state: &State,
    task: impl FnOnce(Drawable, &'static str) -> PaperTask,
) -> Vec<Task> {
    let Some(pane) = state.meant_view() else {
        return Vec::new();
    };
    let drawable = figure_of(state, &[pane], 1, &state.prefs.figure.style);
    let task = drawable.map(|drawable| task(drawable, pane.row().name));
    task.map(Task::Paper).into_iter().collect()
}
