//! Keys that mean commands, and files that are dropped on the window.

use crate::app::command::ENTRIES;
use crate::app::msg::Msg;
use crate::app::msg::command::Command;
use crate::app::state::State;
use egui::{Key, KeyboardShortcut, Modifiers};
use std::path::PathBuf;

/// Runs the commands whose keys were pressed. A field that is being edited keeps the keys it understands.
pub(super) fn shortcuts(ctx: &egui::Context, state: &State, out: &mut Vec<Msg>) {
    let typing = ctx.egui_wants_keyboard_input();
    // "+" is Shift and "=" on many keyboards: without Shift it means the same.
    if ctx.input_mut(|input| input.consume_key(Modifiers::COMMAND, Key::Equals)) {
        out.push(Msg::Run(Command::ZoomIn));
    }
    let mut entries: Vec<_> = ENTRIES
        .iter()
        .filter_map(|entry| Some((entry, entry.keys?)))
        .collect();
    // Ctrl+Z also matches while Shift is held, so the longer combinations go first.
    entries.sort_by_key(|(_, keys)| std::cmp::Reverse(usize::from(keys.modifiers.shift)));
    for (entry, keys) in entries {
        if keys == COPY {
            if !typing && entry.command.is_enabled(state) && copy_pressed(ctx) {
                out.push(Msg::Run(entry.command));
            }
            continue;
        }
        let bare = keys.modifiers.is_none();
        let kept = typing && (entry.menu == "Edit" || bare);
        // A bare key such as Esc has other uses where its command has none.
        let elsewhere = bare && (egui::Popup::is_any_open(ctx) || !entry.command.is_enabled(state));
        if !kept
            && !elsewhere
            && ctx.input_mut(|input| input.consume_shortcut(&keys))
            && entry.command.is_enabled(state)
        {
            out.push(Msg::Run(entry.command));
        }
    }
}

/// The keys that the system tells as a wish to copy rather than as keys.
const COPY: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::C);

/// Takes the wish to copy, unless text is selected that it means.
fn copy_pressed(ctx: &egui::Context) -> bool {
    let selected = ctx
        .plugin::<egui::text_selection::LabelSelectionState>()
        .lock()
        .has_selection();
    !selected
        && ctx.input_mut(|input| {
            let before = input.events.len();
            input.events.retain(|event| *event != egui::Event::Copy);
            input.events.len() < before
        })
}

pub(super) fn dropped_files(ctx: &egui::Context, out: &mut Vec<Msg>) {
    let (paths, hovering) = ctx.input(|input| {
        let dropped = &input.raw.dropped_files;
        let paths: Vec<PathBuf> = dropped
            .iter()
            .map(|file| file.path().to_path_buf())
            .collect();
        (paths, !input.raw.hovered_files.is_empty())
    });
    if !paths.is_empty() {
        out.push(Msg::OpenFiles(paths));
    }
    if hovering {
        let rect = ctx.content_rect();
        let painter = ctx.layer_painter(egui::LayerId::new(
            egui::Order::Foreground,
            egui::Id::unique("drop"),
        ));
        painter.rect_filled(rect, 0.0, egui::Color32::from_black_alpha(160));
        painter.text(
            rect.center(),
            egui::Align2::CENTER_CENTER,
            "Drop MERL files, fit files, a session or a folder to open them",
            egui::FontId::proportional(24.0),
            egui::Color32::WHITE,
        );
    }
}
