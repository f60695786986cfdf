//! Narrow contexts of reducers: what they may do besides changing their own part of the state.

use crate::app::state::Scene;
use crate::app::state::history::History;
use crate::app::state::notice::{Notice, Severity};

/// Notices, and numbers for what is new.
pub(crate) struct Context<'a> {
    pub notices: &'a mut Vec<Notice>,
    pub next_id: &'a mut u64,
}

impl Context<'_> {
    /// A number not used before in this run.
    pub fn fresh_id(&mut self) -> u64 {
        *self.next_id += 1;
        *self.next_id
    }

    /// Says something in the corner of the window. What is said already is not said twice: it comes to the front.
    pub fn notify(&mut self, level: Severity, text: String) {
        self.notices
            .retain(|said| (said.level, &said.text) != (level, &text));
        let id = self.fresh_id();
        self.notices.push(Notice { id, level, text });
    }
}

/// The scene, to be changed in steps that undo takes back.
pub(crate) struct Edit<'a> {
    pub scene: &'a mut Scene,
    pub history: &'a mut History<Scene>,
}

impl Edit<'_> {
    /// Changes the scene. All changes until [`History::settle`] are one step.
    pub fn edit(&mut self, change: impl FnOnce(&mut Scene)) {
        self.history.before_change(self.scene);
        change(self.scene);
    }
}
