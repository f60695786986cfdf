//! Questions about sessions: whether to save before closing, where a material is, and whether to restore what was open.

use crate::app::msg::Msg;
use crate::app::msg::session::{Close, SessionMsg};
use crate::app::state::State;
use crate::app::state::session::{Closing, Crashed, Missing};
use crate::files::session;
use crate::quote::shown;
use egui::{Align2, Id, Key, Modifiers, Window};
use std::time::Duration;

const WIDTH: f32 = 440.0;

/// Draws the one question that is open, if any. The rest of the window goes on.
pub fn session_ui(ctx: &egui::Context, state: &State, out: &mut Vec<Msg>) {
    if matches!(state.session.closing, Closing::Asked | Closing::WhenSaved) {
        window(ctx, "Save the session before closing?", |ui| {
            closing_ui(ui, state, out);
        });
    } else if let Some(crashed) = state.session.crashed.first() {
        let title = match crashed.by_system {
            true => "Grazing was closed by the system",
            false => "Grazing ended unexpectedly",
        };
        window(ctx, title, |ui| {
            crashed_ui(ui, crashed, out);
        });
    } else if let Some(missing) = state.asked_for() {
        let material = state.materials.get(&missing.id);
        let name = material.map_or("A material".into(), |material| shown(&material.name));
        window(ctx, &format!("{name} is not where it was"), |ui| {
            missing_ui(ui, state, missing, out);
        });
    }
}

fn window(ctx: &egui::Context, title: &str, content: impl FnOnce(&mut egui::Ui)) {
    Window::new(title)
        .id(Id::unique("session"))
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ctx, |ui| {
            ui.set_width(WIDTH);
            content(ui);
        });
}

fn closing_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.label(match state.session.files.get(&state.scene.session) {
        Some(file) => format!("{} has changed since it was saved.", session::name(file)),
        None => "Its models and fits are in no file yet.".into(),
    });
    ui.add_space(6.0);
    let asked = state.session.closing == Closing::Asked;
    ui.horizontal(|ui| {
        ui.add_enabled_ui(asked, |ui| {
            let save = ui.button("Save");
            if save.clicked() {
                out.push(Msg::Session(SessionMsg::Close(Close::Save)));
            }
            if asked && ui.memory(|memory| memory.focused().is_none()) {
                // Enter takes the way that loses nothing.
                save.request_focus();
            }
            if ui.button("Don't save").clicked() {
                out.push(Msg::Session(SessionMsg::Close(Close::Discard)));
            }
        });
        let escaped = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        if ui.button("Cancel").clicked() || escaped {
            out.push(Msg::Session(SessionMsg::Close(Close::Stay)));
        }
        if !asked {
            ui.spinner();
        }
    });
}

fn crashed_ui(ui: &mut egui::Ui, crashed: &Crashed, out: &mut Vec<Msg>) {
    let when = crashed.age.map(|age| format!(", kept {}", ago(age)));
    ui.label(format!(
        "Restore what was open{}?",
        when.unwrap_or_default()
    ));
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        if ui.button("Restore").clicked() {
            out.push(Msg::Session(SessionMsg::Restore));
        }
        if ui.button("Discard").clicked() {
            out.push(Msg::Session(SessionMsg::Discard));
        }
    });
}

fn missing_ui(ui: &mut egui::Ui, state: &State, missing: &Missing, out: &mut Vec<Msg>) {
    ui.label("Its models and fits are open without its data. It was looked for at");
    for path in &missing.tried {
        ui.add(
            egui::Label::new(egui::RichText::new(path.display().to_string()).monospace()).wrap(),
        );
    }
    let others = state.all_asked_for().count().saturating_sub(1);
    if others > 0 {
        let were = if others == 1 { "is" } else { "are" };
        ui.add_space(4.0);
        ui.weak(format!(
            "{others} more {were} missing; those beside the file you choose are found with it."
        ));
    }
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        if ui.button("Locate…").clicked() {
            out.push(Msg::Session(SessionMsg::Locate(missing.id)));
        }
        if ui.button("Skip").clicked() {
            out.push(Msg::Session(SessionMsg::Skip { all: false }));
        }
        if others > 0 && ui.button("Skip all").clicked() {
            out.push(Msg::Session(SessionMsg::Skip { all: true }));
        }
    });
}

/// A time that has passed, in words.
fn ago(age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    let (count, unit) = match minutes {
        0 => return "less than a minute ago".into(),
        1..60 => (minutes, "minute"),
        60..1440 => (minutes / 60, "hour"),
        _ => (minutes / 1440, "day"),
    };
    let s = if count == 1 { "" } else { "s" };
    format!("{count} {unit}{s} ago")
}
