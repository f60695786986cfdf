//! The rows of the Help menu.

use crate::app::command::table::{Row, bare, ctrl, item, one};
use crate::app::lessons::Lesson;
use crate::app::lessons::rows::LESSONS;
use crate::app::msg::command::Command;
use egui::Key;

/// Rows from above to below.
pub(super) const ROWS: &[Row] = &[
    one(
        Command::Palette,
        "All commands…",
        ctrl(Key::P),
        "Search all commands",
    ),
    Row::Each("Lessons", || {
        let lessons = LESSONS.iter().enumerate();
        let row = |(index, lesson): (usize, &Lesson)| {
            item(Command::Lesson(index), lesson.title, lesson.about)
        };
        lessons.map(row).collect()
    }),
    one(
        Command::Guide,
        "Guide",
        None,
        "How to work in the window and without one, figures, formats and theory",
    ),
    one(
        Command::Conventions,
        "Conventions",
        bare(Key::F1),
        "Angles, vectors and units",
    ),
    one(
        Command::About,
        "About",
        None,
        "Version and graphics adapter",
    ),
];
