//! The palette: every command that can be run now, searched as one types.

use crate::app::command::search::{Hit, search};
use crate::app::command::{Command, ENTRIES};
use crate::app::msg::Msg;
use crate::app::state::State;
use egui::text::LayoutJob;
use egui::{Id, Key, TextFormat, TextStyle};

/// Draws the field and what it finds. Arrows move the choice, Enter runs it.
pub fn palette_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.set_width(460.0);
    // Before the field takes them for its cursor.
    let by = ui.input_mut(|input| {
        let mut pressed = |key| input.count_and_consume_key(egui::Modifiers::NONE, key) as i64;
        pressed(Key::ArrowDown) - pressed(Key::ArrowUp)
    });
    let mut text = state.typed.clone();
    let edit = ui.add(
        egui::TextEdit::singleline(&mut text)
            .hint_text("Type to search all commands")
            .desired_width(f32::INFINITY),
    );
    edit.request_focus();
    if edit.changed() {
        out.push(Msg::Typed(text.clone()));
    }
    let possible = ENTRIES
        .iter()
        .filter(|entry| entry.command.is_enabled(state));
    let hits = search(possible, &text);
    let chosen = choice(ui, &text, by, hits.len());
    let mut run = None;
    if ui.input(|input| input.key_pressed(Key::Enter)) {
        run = hits.get(chosen).map(|hit| hit.entry.command);
    }
    ui.add_space(6.0);
    egui::ScrollArea::vertical()
        .max_height(360.0)
        .auto_shrink([false, false])
        .show(ui, |ui| {
            for (index, hit) in hits.iter().enumerate() {
                let response = hit_ui(ui, hit, index == chosen);
                if index == chosen && by != 0 {
                    response.scroll_to_me(None);
                }
                if response.clicked() {
                    run = Some(hit.entry.command);
                }
            }
            if hits.is_empty() {
                ui.weak("No command has these words.");
            }
        });
    if let Some(command) = run {
        choose(command, out);
    }
}

fn choose(command: Command, out: &mut Vec<Msg>) {
    out.push(Msg::CloseDialog);
    out.push(Msg::Run(command));
}

/// Position of the chosen command, moved `by` steps: the first one again where the text has changed or the palette has just
/// opened.
fn choice(ui: &egui::Ui, text: &str, by: i64, count: usize) -> usize {
    let id = Id::unique("palette choice");
    let pass = ui.ctx().cumulative_pass_nr();
    let before = ui.data(|data| data.get_temp::<(String, usize, u64)>(id));
    // A pass without the palette means that it was closed in between.
    let at = before
        .filter(|(of, _, seen)| of == text && pass <= seen + 1)
        .map_or(0, |(_, at, _)| at);
    let last = count.saturating_sub(1) as i64;
    let at = (at as i64 + by).clamp(0, last) as usize;
    ui.data_mut(|data| data.insert_temp(id, (text.to_string(), at, pass)));
    at
}

fn hit_ui(ui: &mut egui::Ui, hit: &Hit, chosen: bool) -> egui::Response {
    let mut button = egui::Button::new(title_job(ui, hit))
        .selected(chosen)
        .frame_when_inactive(chosen);
    if let Some(keys) = &hit.entry.keys {
        button = button.shortcut_text(ui.ctx().format_shortcut(keys));
    }
    let response = ui.add_sized([ui.available_width(), 22.0], button.right_text(""));
    response.on_hover_text(&*hit.entry.help)
}

/// The title with the letters underlined that match.
fn title_job(ui: &egui::Ui, hit: &Hit) -> LayoutJob {
    let plain = TextFormat {
        font_id: TextStyle::Button.resolve(ui.style()),
        color: egui::Color32::PLACEHOLDER,
        ..TextFormat::default()
    };
    let underlined = TextFormat {
        underline: egui::Stroke::new(1.0, ui.visuals().text_color()),
        ..plain.clone()
    };
    let mut job = LayoutJob::default();
    let mut letter = [0; 4];
    for (index, c) in hit.entry.title().chars().enumerate() {
        let matched = hit.matched.contains(&(index as u32));
        let format = if matched { &underlined } else { &plain };
        job.append(c.encode_utf8(&mut letter), 0.0, format.clone());
    }
    job
}
