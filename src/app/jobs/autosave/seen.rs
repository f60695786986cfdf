//! The state as it was kept, to see whether it has changed since.

use crate::app::state::State;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::state::fitting::table::FitTable;
use crate::app::state::layout::Tiles;
use crate::app::state::material::Origin;
use crate::app::state::probe::Probe;
use crate::app::state::session_mark::SessionMark;
use std::path::PathBuf;

/// The state as it was kept.
pub(super) struct Seen {
    work: SessionMark,
    tiles: Tiles,
    settings: FitSettings,
    keep_optimal: bool,
    table: FitTable,
    pinned: Option<Probe>,
    saved_as: Option<PathBuf>,
}

impl Seen {
    pub fn of(state: &State) -> Self {
        Self {
            work: SessionMark::of(state),
            tiles: state.tiles.clone(),
            settings: state.fit.settings.clone(),
            keep_optimal: state.fit.keep_optimal,
            table: state.fit.table.clone(),
            pinned: state.pinned,
            saved_as: state.session.files.get(&state.scene.session).cloned(),
        }
    }

    /// Whether nothing has changed. Asked at each frame.
    pub fn is(&self, state: &State) -> bool {
        self.tiles == state.tiles
            && self.settings == state.fit.settings
            && self.keep_optimal == state.fit.keep_optimal
            && self.table == state.fit.table
            && self.pinned == state.pinned
            && self.saved_as.as_ref() == state.session.files.get(&state.scene.session)
            && self.work.is(state)
    }
}

/// Whether there is more than what every start shows.
pub(super) fn is_worth_keeping(state: &State) -> bool {
    state.history.can_undo()
        || state.session.files.contains_key(&state.scene.session)
        || state
            .materials
            .values()
            .any(|material| matches!(material.origin, Origin::File(_)) || !material.fits.is_empty())
}
