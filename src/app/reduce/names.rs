//! Reducer of names: open materials of the same name are told apart by their folders, for as long as both are open.

use crate::app::state::State;
use crate::app::state::material::{Material, Origin};
use crate::files;
use crate::files::names::told_apart;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Gives every open material a name that no other has, as far as files differ.
pub(crate) fn tell_apart(state: &mut State) {
    let State {
        materials, scene, ..
    } = state;
    let open = || {
        scene
            .opened
            .iter()
            .filter_map(|opened| materials.get(&opened.id))
    };
    let different: BTreeSet<&str> = open().map(|material| &*material.own_name).collect();
    if different.len() == open().count()
        && open().all(|material| material.name == material.own_name)
    {
        return;
    }
    let all: Vec<(String, Option<PathBuf>)> = open()
        .map(|material| (material.own_name.clone(), place(material)))
        .collect();
    let names = told_apart(&all);
    for (opened, name) in scene.opened.iter().zip(names) {
        if let Some(material) = materials.get_mut(&opened.id) {
            material.name = name;
        }
    }
}

/// File of a material; of a model without data the file that it came with.
fn place(material: &Material) -> Option<PathBuf> {
    match &material.origin {
        Origin::File(path) => Some(files::absolute(path)),
        Origin::Sample(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::Command;
    use crate::app::msg::{Loaded, Msg};
    use crate::app::reduce::apply;
    use crate::app::state::subjects::Subjects;
    use crate::measured::Table;

    fn open(state: &mut State, path: &str) {
        let loaded = Loaded::new(
            files::material_name(path.as_ref()),
            None,
            (*Table::unmeasured()).clone(),
        );
        let msg = Msg::Loaded {
            job: 0,
            origin: Origin::File(path.into()),
            result: Ok(loaded),
        };
        apply(state, msg);
    }

    fn names(state: &State) -> Vec<&str> {
        let opened = state.scene.opened.iter();
        opened
            .map(|opened| &*state.materials[&opened.id].name)
            .collect()
    }

    #[test]
    fn a_name_has_its_folder_while_another_has_it_too() {
        let mut state = State::default();
        open(&mut state, "/data/old/steel.binary");
        open(&mut state, "/data/old/gold.binary");
        assert_eq!(names(&state), ["steel", "gold"]);
        open(&mut state, "/data/new/steel.binary");
        assert_eq!(names(&state), ["old/steel", "gold", "new/steel"]);
        apply(&mut state, Msg::SetBeside(0, true));
        let labels: Vec<String> = Subjects::of(&state)
            .list
            .into_iter()
            .map(|s| s.label)
            .collect();
        assert!(
            labels.iter().any(|label| label.starts_with("old/steel, ")),
            "{labels:?}"
        );
        apply(&mut state, Msg::Close(0));
        assert_eq!(names(&state), ["gold", "steel"]);
        apply(&mut state, Msg::Run(Command::Undo));
        assert_eq!(names(&state), ["old/steel", "gold", "new/steel"]);
        // What is written down has no folder in it, which may be another one tomorrow.
        let material = &state.materials[&state.scene.opened[0].id];
        assert_eq!(material.own_name, "steel");
    }
}
