//! Queries about files that were not found, and the title of the window.

use crate::app::state::State;
use crate::app::state::material::Presence;
use crate::app::state::session::Missing;
use crate::files::session;

impl State {
    /// The open materials that were not found and not skipped.
    pub fn all_asked_for(&self) -> impl Iterator<Item = &Missing> {
        let lost = |missing: &&Missing| {
            let open = self.scene.opened.iter().any(|one| one.id == missing.id);
            let material = self.materials.get(&missing.id);
            !missing.skipped && open && material.is_some_and(|m| m.presence == Presence::Missing)
        };
        self.session.missing.iter().filter(lost)
    }

    /// The first of them.
    pub fn asked_for(&self) -> Option<&Missing> {
        self.all_asked_for().next()
    }

    /// What stands in the title of the window.
    pub fn title(&self) -> String {
        match self.session.files.get(&self.scene.session) {
            Some(file) => format!("{} — Grazing", session::name(file)),
            None => "Grazing".into(),
        }
    }
}
