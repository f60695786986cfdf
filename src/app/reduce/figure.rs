//! Reducer of figures: pointing at views, choosing them, exporting.

use crate::app::msg::Task;
use crate::app::msg::figure::{FigureMsg, FigureTask};
use crate::app::state::State;
use crate::app::state::figure::{FigurePrefs, FigureViews};
use crate::app::state::notice::Dialog;
use crate::app::state::views::ViewId;

/// Part of the state that figures change: the views in them, their looks, and the dialog that makes one.
pub(crate) struct FigurePart<'a> {
    pub views: &'a mut FigureViews,
    pub prefs: &'a mut FigurePrefs,
    pub dialog: &'a mut Option<Dialog>,
}

/// Changes the part.
pub(crate) fn apply(part: &mut FigurePart, msg: FigureMsg) -> Vec<Task> {
    match msg {
        FigureMsg::Point(pane) => {
            part.views.pointed = pane;
            part.views.last = pane.or(part.views.last);
        }
        FigureMsg::Choose(panes) => part.views.chosen = panes,
        FigureMsg::Set(prefs) => *part.prefs = prefs,
        FigureMsg::Export => {
            *part.dialog = None;
            let views = part.views.chosen.clone();
            return vec![Task::Figure(FigureTask::Export(views))];
        }
    }
    Vec::new()
}

/// The views that a new figure begins with: those chosen by hand, or the one that is meant.
pub(crate) fn first_views(state: &State) -> Vec<ViewId> {
    let kept = state.views.chosen.iter().copied();
    let kept: Vec<ViewId> = kept.filter(|pane| state.can_draw(*pane)).collect();
    match (kept.len(), state.meant_view()) {
        // Several were chosen by hand.
        (2.., _) => kept,
        (_, Some(pane)) => vec![pane],
        (_, None) => Vec::new(),
    }
}

/// A task on the view that is meant.
pub(crate) fn copy(state: &State, task: impl FnOnce(ViewId) -> FigureTask) -> Vec<Task> {
    let task = state.meant_view().map(task);
    task.map(Task::Figure).into_iter().collect()
}
