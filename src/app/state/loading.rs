//! Queries about files that are open or on their way.

use crate::app::state::State;
use crate::app::state::material::Material;
use std::path::Path;

impl State {
    /// What is on its way to the screen, in words.
    pub fn loading(&self) -> Option<String> {
        let current = || self.current().map(|(material, _)| material);
        let name = match &self.library.pending {
            Some(pending) => &pending.name,
            None => &current().filter(|material| material.is_loading())?.name,
        };
        Some(format!("Loading {name}…"))
    }

    /// Whether and where a file is open: its position in the scene.
    pub fn position_of_file(&self, path: &Path) -> Option<usize> {
        self.scene.opened.iter().position(|opened| {
            let material = self.materials.get(&opened.id);
            material.and_then(Material::file).as_deref() == Some(path)
        })
    }
}
