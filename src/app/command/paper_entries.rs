//! The rows of the command list that are about figures and the clipboard.

use crate::app::command::{Command, Entry, Place};
use egui::{Key, KeyboardShortcut, Modifiers};

/// Puts them where they belong.
pub(crate) fn insert(list: &mut Vec<Entry>) {
    const CTRL: Modifiers = Modifiers::COMMAND;
    const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
    let row = |menu, command, name: &str, keys: Option<(Modifiers, Key)>, help: &str| Entry {
        command,
        place: Place { menu, submenu: "" },
        name: name.into(),
        keys: keys.map(|(modifiers, key)| KeyboardShortcut::new(modifiers, key)),
        help: help.into(),
    };
    let figure = row(
        "File",
        Command::ExportFigure,
        "Export figure…",
        Some((CTRL, Key::E)),
        "Make a figure for a paper: SVG, PDF, PNG or CSV",
    );
    let copies = [
        row(
            "Edit",
            Command::Copy,
            "Copy",
            Some((CTRL, Key::C)),
            "Copy the pinned values, or else the picture of the view under the pointer",
        ),
        row(
            "Edit",
            Command::CopyPicture,
            "Copy picture",
            None,
            "Copy the view as a picture on white, as a figure has it",
        ),
        row(
            "Edit",
            Command::CopyNumbers,
            "Copy numbers",
            Some((CTRL_SHIFT, Key::C)),
            "Copy the numbers that the view draws as a table for a spreadsheet",
        ),
    ];
    put_before(list, Command::SavePicture, [figure]);
    put_before(list, Command::CopyProbe, copies);
}

fn put_before<const N: usize>(list: &mut Vec<Entry>, before: Command, rows: [Entry; N]) {
    let at = list.iter().position(|entry| entry.command == before);
    let at = at.unwrap_or(list.len());
    list.splice(at..at, rows);
}
