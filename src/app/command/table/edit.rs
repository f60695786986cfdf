//! The rows of the Edit menu.

use crate::app::command::table::{Row, bare, ctrl, ctrl_shift, one};
use crate::app::msg::command::Command;
use egui::Key;

/// Rows from above to below.
pub(super) const ROWS: &[Row] = &[
    one(
        Command::Undo,
        "Undo",
        ctrl(Key::Z),
        "Take the last change back",
    ),
    one(
        Command::Redo,
        "Redo",
        ctrl_shift(Key::Z),
        "Make the change again",
    ),
    one(
        Command::Copy,
        "Copy",
        ctrl(Key::C),
        "Copy the pinned values, or else the picture of the view under the pointer",
    ),
    one(
        Command::CopyPicture,
        "Copy picture",
        None,
        "Copy the view as a picture on white, as a figure has it",
    ),
    one(
        Command::CopyNumbers,
        "Copy numbers",
        ctrl_shift(Key::C),
        "Copy the numbers that the view draws as a table for a spreadsheet",
    ),
    one(
        Command::CopyProbe,
        "Copy values",
        None,
        "Copy the probe's angles and values as a row for a spreadsheet",
    ),
    one(
        Command::Unpin,
        "Unpin",
        bare(Key::Escape),
        "Let the probe follow the pointer again",
    ),
    one(
        Command::CopyParams,
        "Copy parameters",
        None,
        "Copy model and numbers as JSON",
    ),
    one(
        Command::GuessParams,
        "Guess from data",
        ctrl(Key::G),
        "Read a first guess of the parameters off the data",
    ),
    one(
        Command::ResetParams,
        "Reset parameters",
        ctrl(Key::R),
        "Put all parameters back to their defaults",
    ),
];
