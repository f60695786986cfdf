//! The open folder: its name, what can be done with it, search, order, and keys.

use crate::app::command::Command;
use crate::app::msg::Msg;
use crate::app::msg::library::{FolderMsg, LibraryMsg};
use crate::app::panels::library::files;
use crate::app::state::State;
use crate::app::state::library::listing::{FileSort, SORT_KEYS, SortKey};
use crate::app::state::library::{Folder, Library, Scan};
use crate::app::state::prefs::MemoryLimit;
use crate::app::widgets::paint::plain;
use crate::files::folder::shown_name;
use egui::{Key, Modifiers};

/// Draws the folder. `panel` is where the whole library is: a press in it gives it the keys.
pub fn folder_ui(ui: &mut egui::Ui, state: &State, panel: egui::Rect, out: &mut Vec<Msg>) {
    let Some(folder) = &state.library.folder else {
        return;
    };
    title_ui(ui, state, folder, out);
    search_ui(ui, state, out);
    fit_ui(ui, state, out);
    keys(ui, state, panel, out);
    files::files_ui(ui, state, folder, out);
}

fn title_ui(ui: &mut egui::Ui, state: &State, folder: &Folder, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            menu_ui(ui, state, folder, out);
            if let Some(text) = scanned(folder) {
                ui.weak(text).on_hover_text("Files that have been read");
            }
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                let name = egui::RichText::new(shown_name(&folder.path)).strong();
                let name = ui.add(egui::Label::new(name).truncate());
                name.on_hover_text(folder.path.display().to_string());
            });
        });
    });
}

/// Progress of the scan in words, until it is done.
fn scanned(folder: &Folder) -> Option<String> {
    match folder.scan {
        Scan::Done => None,
        Scan::Listing => Some("…".into()),
        Scan::Looking => {
            let files = || folder.files.iter();
            let measured = files().filter(|file| file.is_measured()).count();
            let examined = files().filter(|file| file.examined().is_some()).count();
            Some(format!("{examined} of {measured}"))
        }
    }
}

fn menu_ui(ui: &mut egui::Ui, state: &State, folder: &Folder, out: &mut Vec<Msg>) {
    let menu = ui.menu_button("…", |ui| {
        for (name, command) in [
            ("Fit all files", Command::FitFolder),
            ("Compare on all files", Command::CompareFolder),
            ("Save fits…", Command::SaveFits),
        ] {
            let button = ui.add_enabled(command.is_enabled(state), egui::Button::new(name));
            if button.on_hover_text(command.hint(ui.ctx())).clicked() {
                out.push(Msg::Run(command));
            }
        }
        ui.separator();
        if ui
            .button("Look again")
            .on_hover_text("Read the folder anew")
            .clicked()
        {
            out.push(Msg::Library(LibraryMsg::Open(folder.path.clone())));
        }
        for (name, command) in [
            ("Open another…", Command::OpenFolder),
            ("Close folder", Command::CloseFolder),
        ] {
            let hint = command.hint(ui.ctx());
            if ui.button(name).on_hover_text(hint).clicked() {
                out.push(Msg::Run(command));
            }
        }
        ui.separator();
        limit_ui(ui, state, out);
    });
    menu.response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Menu of the folder"));
}

/// Draws the limit of the memory for tables.
fn limit_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.horizontal(|ui| {
        let label = ui.label("Memory");
        let mut mib = state.prefs.memory.0;
        let drag = egui::DragValue::new(&mut mib)
            .range(MemoryLimit::RANGE)
            .speed(4.0)
            .suffix(" MiB");
        let drag = ui.add(drag).labelled_by(label.id).on_hover_text(
            "How much the data of open materials may take, in memory and on the graphics card. Those not shown for the longest time are let go and read again when they are shown.",
        );
        if drag.changed() {
            out.push(Msg::Library(LibraryMsg::SetLimit(mib)));
        }
    });
}

fn search_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let library = &state.library;
    ui.horizontal(|ui| {
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            sort_ui(ui, library, out);
            let mut text = library.search.clone();
            let field = egui::TextEdit::singleline(&mut text)
                .hint_text("Search")
                .desired_width(f32::INFINITY);
            let field = ui.add(field);
            field.widget_info(|| {
                egui::WidgetInfo::labeled(egui::Role::TextInput, true, "Search the folder")
            });
            if field.changed() {
                out.push(Msg::Library(FolderMsg::Search(text).into()));
            }
            let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
            if let (true, Some(first)) = (entered, library.steps().first()) {
                out.push(Msg::Library(LibraryMsg::Show {
                    path: first.clone(),
                    keep: false,
                }));
            }
        });
    });
}

fn sort_ui(ui: &mut egui::Ui, library: &Library, out: &mut Vec<Msg>) {
    let sort = library.sort;
    let menu = ui.menu_button("Sort", |ui| {
        for key in SORT_KEYS {
            key_ui(ui, sort, key, out);
        }
        for model in library.fitted_models() {
            ui.menu_button(model.name, |ui| {
                for row in model.rows() {
                    key_ui(ui, sort, SortKey::Param(model, row.id), out);
                }
            });
        }
        ui.separator();
        for (descending, name) in [(false, "Ascending"), (true, "Descending")] {
            if ui
                .selectable_label(sort.descending == descending, name)
                .clicked()
            {
                out.push(Msg::Library(
                    FolderMsg::Sort(FileSort { descending, ..sort }).into(),
                ));
            }
        }
    });
    menu.response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Order of the folder"));
    let direction = if sort.descending {
        "descending"
    } else {
        "ascending"
    };
    let model = match sort.key {
        SortKey::Param(model, _) => format!("{}: ", model.name),
        _ => String::new(),
    };
    let name = plain(&sort.key.name());
    menu.response
        .on_hover_text(format!("Order of the files: {model}{name}, {direction}"));
}

/// A choice of the menu.
fn key_ui(ui: &mut egui::Ui, sort: FileSort, key: SortKey, out: &mut Vec<Msg>) {
    let button = ui.selectable_label(sort.key == key, plain(&key.name()));
    if button.clicked() {
        let sort = FileSort { key, ..sort };
        out.push(Msg::Library(FolderMsg::Sort(sort).into()));
    }
}

/// The fit of the folder under way.
fn fit_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let library = &state.library;
    if let Some(run) = &library.run {
        ui.horizontal(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let cancel = ui
                    .small_button("×")
                    .on_hover_text("Stop fitting the folder");
                cancel.widget_info(|| {
                    egui::WidgetInfo::labeled(egui::Role::Button, true, "Stop fitting the folder")
                });
                if cancel.clicked() {
                    out.push(Msg::Run(Command::CancelFitFolder));
                }
                let at = (run.done + 1).min(run.total);
                let waiting = state.fit.run.is_some();
                let text = if waiting {
                    format!("{at} of {}: waits", run.total)
                } else {
                    format!("{at} of {}: {}", run.total, run.name)
                };
                let bar =
                    egui::ProgressBar::new(run.progress()).desired_width(ui.available_width());
                let bar = ui.add(bar.text(egui::RichText::new(text.clone()).small()));
                bar.on_hover_text(format!(
                    "Fitting {text}. A fit of the shown material goes first."
                ));
            });
        });
    }
}

/// Arrows, Home, End and Enter, where the library was pressed last and nobody types.
fn keys(ui: &mut egui::Ui, state: &State, panel: egui::Rect, out: &mut Vec<Msg>) {
    let id = egui::Id::unique("library has the keys");
    let pressed = ui.input(|input| {
        let any = input.pointer.any_pressed();
        any.then(|| input.pointer.interact_pos()).flatten()
    });
    if let Some(at) = pressed {
        ui.data_mut(|data| data.insert_temp(id, panel.contains(at)));
    }
    let ours = ui.data(|data| data.get_temp(id)).unwrap_or(false)
        && state.dialog.is_none()
        && !ui.ctx().egui_wants_keyboard_input()
        && !egui::Popup::is_any_open(ui.ctx());
    if !ours {
        return;
    }
    let all = state.library.steps().len() as isize;
    let steps = [
        (Key::ArrowDown, 1),
        (Key::ArrowUp, -1),
        (Key::PageDown, 10),
        (Key::PageUp, -10),
        (Key::Home, -all),
        (Key::End, all),
    ];
    ui.input_mut(|input| {
        for (key, by) in steps {
            for _ in 0..input.count_and_consume_key(Modifiers::NONE, key) {
                out.push(Msg::Library(LibraryMsg::Step(by)));
            }
        }
        if input.consume_key(Modifiers::NONE, Key::Enter) {
            out.push(Msg::Library(LibraryMsg::Keep));
        }
    });
}
