//! The table of commands, menu by menu: what stands behind menus, shortcuts, tooltips and the palette.

mod edit;
mod file;
mod fit;
mod help;
mod model;
mod view;

use crate::app::msg::command::Command;
use egui::{Key, KeyboardShortcut, Modifiers};
use std::borrow::Cow;

/// A menu of the menu bar.
pub struct Menu {
    /// Name in the bar.
    pub name: &'static str,
    /// Rows from above to below.
    pub rows: &'static [Row],
}

/// The menus from left to right.
pub const MENUS: [Menu; 6] = [
    Menu {
        name: "File",
        rows: file::ROWS,
    },
    Menu {
        name: "Edit",
        rows: edit::ROWS,
    },
    Menu {
        name: "Model",
        rows: model::ROWS,
    },
    Menu {
        name: "Fit",
        rows: fit::ROWS,
    },
    Menu {
        name: "View",
        rows: view::ROWS,
    },
    Menu {
        name: "Help",
        rows: help::ROWS,
    },
];

/// A row of a menu.
pub enum Row {
    /// A command.
    One(Item),
    /// A command for each entry of a list elsewhere, in a submenu of this name; in the menu itself where that is empty.
    Each(&'static str, fn() -> Vec<Item>),
}

/// A command with its words and its keys.
pub struct Item {
    /// The command.
    pub command: Command,
    /// Name in the menu.
    pub name: Cow<'static, str>,
    /// Keys that run it.
    pub keys: Option<KeyboardShortcut>,
    /// One sentence.
    pub help: Cow<'static, str>,
}

const fn one(
    command: Command,
    name: &'static str,
    keys: Option<KeyboardShortcut>,
    help: &'static str,
) -> Row {
    Row::One(Item {
        command,
        name: Cow::Borrowed(name),
        keys,
        help: Cow::Borrowed(help),
    })
}

/// An entry of a submenu.
fn item(command: Command, name: impl Into<Cow<'static, str>>, help: &'static str) -> Item {
    Item {
        command,
        name: name.into(),
        keys: None,
        help: help.into(),
    }
}

/// Ctrl (Cmd on a Mac) and a key.
const fn ctrl(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND, key))
}

/// Ctrl (Cmd on a Mac), Shift and a key.
const fn ctrl_shift(key: Key) -> Option<KeyboardShortcut> {
    const BOTH: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
    Some(KeyboardShortcut::new(BOTH, key))
}

/// A key alone.
const fn bare(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::NONE, key))
}
