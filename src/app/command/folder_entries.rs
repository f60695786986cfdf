//! The rows of the command list that are about the folder and sessions.

use crate::app::command::{Command, Entry, Place};
use egui::{Key, KeyboardShortcut, Modifiers};

/// Puts them behind the rows they belong to.
pub(crate) fn insert(list: &mut Vec<Entry>) {
    let keys = Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::L));
    let rows = [
        (
            Command::OpenPath,
            vec![(
                Command::OpenFolder,
                "Open folder…",
                keys,
                "List the files of a folder in the library",
            )],
        ),
        (
            Command::Close,
            vec![
                (
                    Command::CloseFolder,
                    "Close folder",
                    None,
                    "Take the folder out of the library; open materials stay",
                ),
                (
                    Command::SaveFits,
                    "Save fits of the folder…",
                    None,
                    "Write the fits of all files of the folder to a fit file",
                ),
                (
                    Command::SaveSession,
                    "Save session…",
                    Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::S)),
                    "Save what is open with models, fits, views and layout; asks where the first time",
                ),
                (
                    Command::SaveSessionAs,
                    "Save session as…",
                    None,
                    "Save what is open to another session file",
                ),
            ],
        ),
        (
            Command::CancelFit,
            vec![
                (
                    Command::FitFolder,
                    "Fit the folder",
                    None,
                    "Fit the shown model to every file of the folder that has no such fit, in the background",
                ),
                (
                    Command::FitFolderAll,
                    "Fit all six to the folder",
                    None,
                    "Fit every model to every file of the folder that has no such fits, in the background",
                ),
                (
                    Command::CancelFitFolder,
                    "Cancel fit of the folder",
                    None,
                    "Stop fitting the folder and keep the files that are done",
                ),
            ],
        ),
    ];
    for (after, rows) in rows {
        let place = |entry: &Entry| (entry.command == after).then_some(entry.place);
        let found = list
            .iter()
            .enumerate()
            .find_map(|(k, entry)| Some((k, place(entry)?)));
        let Some((at, Place { menu, submenu })) = found else {
            continue;
        };
        let rows = rows.into_iter().map(|(command, name, keys, help)| Entry {
            command,
            place: Place { menu, submenu },
            name: name.into(),
            keys,
            help: help.into(),
        });
        list.splice(at + 1..at + 1, rows);
    }
}
