//! The menu bar, made from the command list.

use crate::app::command::table::MENUS;
use crate::app::command::{Command, ENTRIES, Entry};
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::files::folder::shown_name;

/// Draws the bar.
pub fn menu_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    egui::MenuBar::new().ui(ui, |ui| {
        for menu in MENUS {
            ui.menu_button(menu.name, |ui| entries_ui(ui, menu.name, state, out));
        }
    });
}

fn entries_ui(ui: &mut egui::Ui, menu: &str, state: &State, out: &mut Vec<Msg>) {
    let entries: Vec<&Entry> = ENTRIES.iter().filter(|entry| entry.menu == menu).collect();
    for group in entries.chunk_by(|a, b| a.submenu == b.submenu) {
        let submenu = group[0].submenu;
        if submenu.is_empty() {
            for entry in group {
                entry_ui(ui, entry, state, out);
                if entry.command == Command::Open {
                    recent_ui(ui, state, out);
                }
            }
        } else {
            ui.menu_button(submenu, |ui| {
                for entry in group {
                    entry_ui(ui, entry, state, out);
                }
            });
        }
    }
}

fn entry_ui(ui: &mut egui::Ui, entry: &Entry, state: &State, out: &mut Vec<Msg>) {
    let mut button =
        egui::Button::new(&*entry.name).selected(entry.command.is_checked(state).unwrap_or(false));
    if let Some(keys) = &entry.keys {
        button = button.shortcut_text(ui.ctx().format_shortcut(keys));
    }
    let response = ui
        .add_enabled(entry.command.is_enabled(state), button)
        .on_hover_text(&*entry.help);
    if response.clicked() {
        out.push(Msg::Run(entry.command));
    }
}

fn recent_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.add_enabled_ui(!state.prefs.recent.is_empty(), |ui| {
        ui.menu_button("Open recent", |ui| {
            for (index, path) in state.prefs.recent.iter().enumerate() {
                let mut name = shown_name(path);
                if state.prefs.folder.as_ref() == Some(path) {
                    name.push('/');
                }
                if ui
                    .button(name)
                    .on_hover_text(path.display().to_string())
                    .clicked()
                {
                    out.push(Msg::Run(Command::OpenRecent(index)));
                }
            }
            ui.separator();
            if ui.button("Clear list").clicked() {
                out.push(Msg::Run(Command::ClearRecent));
            }
        });
    });
}
