//! Reducer of figures: pointing at views, choosing them, exporting.

use crate::app::msg::Task;
use crate::app::msg::figure::{FigureMsg, FigureTask};
use crate::app::state::State;
use crate::app::state::notice::Dialog;
use crate::app::state::views::ViewId;

/// Changes the state.
pub(crate) fn apply(state: &mut State, msg: FigureMsg) -> Vec<Task> {
    match msg {
        FigureMsg::Point(pane) => {
            state.views.pointed = pane;
            state.views.last = pane.or(state.views.last);
        }
        FigureMsg::Choose(panes) => state.views.chosen = panes,
        FigureMsg::Set(prefs) => state.prefs.figure = prefs,
        FigureMsg::Export => {
            state.dialog = None;
            let views = state.views.chosen.clone();
            return vec![Task::Figure(FigureTask::Export(views))];
        }
    }
    Vec::new()
}

/// Opens the dialog on the view that is meant.
pub(crate) fn open(state: &mut State) {
    let kept = state.views.chosen.iter().copied();
    let kept: Vec<ViewId> = kept.filter(|pane| state.can_draw(*pane)).collect();
    state.views.chosen = match (kept.len(), state.meant_view()) {
        // Several were chosen by hand.
        (2.., _) => kept,
        (_, Some(pane)) => vec![pane],
        (_, None) => Vec::new(),
    };
    state.dialog = Some(Dialog::Figure);
}

/// A task on the view that is meant.
pub(crate) fn copy(state: &State, task: impl FnOnce(ViewId) -> FigureTask) -> Vec<Task> {
    let task = state.meant_view().map(task);
    task.map(Task::Figure).into_iter().collect()
}
