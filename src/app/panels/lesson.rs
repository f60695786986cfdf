//! The card of a lesson: its text, and the way back and on.

use crate::app::lessons::rows::LESSONS;
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::lesson::LessonAt;
use crate::app::widgets::paint::{rich_text_job, role_color};
use crate::figure::palette::Role;
use crate::figure::text::RichText;
use egui::{Rect, Stroke, StrokeKind};

/// Draws the card under the tiles, where it covers nothing, if a lesson is under way.
pub fn lesson_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    let Some((at, step)) = state.lesson.and_then(|at| Some((at, at.step()?))) else {
        return;
    };
    let lesson = &LESSONS[at.lesson];
    egui::Panel::bottom("lesson").show(ui, |ui| {
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            ui.strong(lesson.title);
            ui.weak(format!("{} of {}", at.step + 1, lesson.steps.len()));
            if at.waits {
                ui.weak("The material is being made…");
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                buttons_ui(ui, at, out);
            });
        });
        let mut job = rich_text_job(&RichText::parse(step.text), 14.0, ui.visuals().text_color());
        job.wrap.max_width = ui.available_width();
        ui.label(job);
        ui.add_space(4.0);
    });
}

fn buttons_ui(ui: &mut egui::Ui, at: LessonAt, out: &mut Vec<Msg>) {
    let last = at.step + 1 == LESSONS[at.lesson].steps.len();
    let go = |step| Msg::Lesson {
        lesson: at.lesson,
        step,
    };
    // From the right.
    let end = if last { "Done" } else { "End lesson" };
    if ui.button(end).clicked() {
        out.push(Msg::EndLesson);
    }
    if ui
        .button("Again")
        .on_hover_text("Set the scene of this step once more")
        .clicked()
    {
        out.push(go(at.step));
    }
    if !last && ui.button("Next").clicked() {
        out.push(go(at.step + 1));
    }
    if ui
        .add_enabled(at.step > 0, egui::Button::new("Back"))
        .clicked()
    {
        out.push(go(at.step - 1));
    }
}

/// Frames what was drawn since, if a lesson speaks of it.
pub fn frame_from(ui: &egui::Ui, top: egui::Pos2, framed: bool) {
    if framed {
        let bottom = egui::pos2(ui.max_rect().right(), ui.min_rect().bottom());
        frame(ui, Rect::from_min_max(top, bottom).expand(3.0));
    }
}

/// Frames what a step speaks of.
pub fn frame(ui: &egui::Ui, rect: Rect) {
    let color = role_color(ui.visuals().dark_mode, Role::Accent);
    ui.painter()
        .rect_stroke(rect, 6.0, Stroke::new(2.0, color), StrokeKind::Inside);
}
